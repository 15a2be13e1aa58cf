// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Standard streams and signals; see standard_streams.h.

#include "standard_streams.h"

#include "error.h"
#include "stop.h"
#include "temporary_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <string_view>

namespace near_pairs {
namespace {

std::atomic<bool> is_pipe_broken = false;

// Ends the program in a signal handler. Calls nothing but what handlers may call.
extern "C" void end_at_once(int)
{
  remove_temporary_files();
  if(is_pipe_broken) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  constexpr std::string_view message = "near_pairs: stopped\n";
  [[maybe_unused]] const ssize_t count = write(STDERR_FILENO, message.data(), message.size());
  _exit(2);
}

// Asks the program to end, which it does within a second.
extern "C" void stop(int signal)
{
  if(signal == SIGPIPE)
    is_pipe_broken = true;
  else if(stop_requested)
    end_at_once(signal);
  stop_requested = true;
  alarm(1);
}

} // namespace

void keep_closed_streams_closed()
{
  for(int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if(fcntl(stream, F_GETFD) == -1)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY); // takes the lowest place
}

void catch_signals()
{
  std::signal(SIGXFSZ, SIG_IGN); // a file that is too large for the limit is an error then
  std::signal(SIGALRM, end_at_once);
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  if(std::signal(SIGHUP, stop) == SIG_IGN)
    std::signal(SIGHUP, SIG_IGN); // started by nohup
  if(std::signal(SIGPIPE, stop) == SIG_IGN)
    std::signal(SIGPIPE, SIG_IGN); // whoever started the program wants an error
}

void finish(std::ostream& stream, const std::string& what)
{
  stream.flush();
  if(!stream)
    throw Error(what, "cannot be written to its end");
}

int end_with_error(const std::string& message)
{
  if(is_pipe_broken) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  std::cerr << "near_pairs: " << message << '\n';
  return 2;
}

} // namespace near_pairs
