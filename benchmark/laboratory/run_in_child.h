// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Methods that may crash or never end run in a process of their own.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_RUN_IN_CHILD_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_RUN_IN_CHILD_H

#include <csignal>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace lab {

// What came of it: "ok", or how it ended. Without "ok", there are no values.
template <class Value>
struct Child_result
{
  std::string status;
  std::vector<Value> values;

  bool is_ok() const { return status == "ok"; }
};

inline std::string name_of_end(int status)
{
  if(WIFEXITED(status))
    return WEXITSTATUS(status) == 0 ? "ok" : "exception";
  switch(WTERMSIG(status)) {
  case SIGALRM: return "endless";
  case SIGFPE: return "SIGFPE";
  case SIGSEGV: return "SIGSEGV";
  case SIGABRT: return "abort";
  default: return "signal " + std::to_string(WTERMSIG(status));
  }
}

// Reads all that comes out of the pipe.
template <class Value>
std::vector<Value> read_values(int pipe_end)
{
  std::vector<Value> values;
  std::FILE* const in = fdopen(pipe_end, "rb");
  Value block[256];
  for(std::size_t count; (count = std::fread(block, sizeof(Value), 256, in)) > 0;)
    values.insert(values.end(), block, block + count);
  std::fclose(in);
  return values;
}

// In the child: writes the values of f(), and never returns.
template <class Function>
[[noreturn]] void write_values(int pipe_end, unsigned int seconds, const Function& f)
{
  for(int crash : {SIGFPE, SIGSEGV, SIGABRT}) // a test library may have its own handlers
    std::signal(crash, SIG_DFL);
  alarm(seconds);
  try {
    const auto values = f();
    std::FILE* const out = fdopen(pipe_end, "wb");
    const bool is_written
      = std::fwrite(values.data(), sizeof(values[0]), values.size(), out) == values.size();
    _exit(std::fclose(out) == 0 && is_written ? 0 : 1);
  }
  catch(...) {
    _exit(1);
  }
}

// Runs f in a child, which is stopped after so many seconds of wall time. f returns a vector of
// plain values.
template <class Function>
auto run_in_child(unsigned int seconds, const Function& f)
{
  using Value = typename decltype(f())::value_type;
  int ends[2];
  if(pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  std::fflush(nullptr); // or the child would write what is left once more
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error("no child process");
  if(child == 0) {
    close(ends[0]);
    write_values(ends[1], seconds, f);
  }
  close(ends[1]);
  Child_result<Value> result;
  result.values = read_values<Value>(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  result.status = name_of_end(status);
  return result;
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_RUN_IN_CHILD_H
