// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Standard streams and signals; see standard_streams.h.

#include "standard_streams.h"

#include "error.h"
#include "stop.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>

namespace near_pairs {
namespace {

std::atomic<bool> is_pipe_broken = false;

} // namespace

void keep_closed_streams_closed()
{
  for(int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if(fcntl(stream, F_GETFD) == -1)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY); // takes the lowest place
}

void catch_signals()
{
  const auto stop = [](int signal) {
    stop_requested = true;
    std::signal(signal, SIG_DFL); // the second one ends the program at once
  };
  const auto stop_quietly = [](int) {
    is_pipe_broken = true;
    stop_requested = true;
  };
  std::signal(SIGXFSZ, SIG_IGN); // a file that is too large for the limit is an error then
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  if(std::signal(SIGHUP, stop) == SIG_IGN)
    std::signal(SIGHUP, SIG_IGN); // started by nohup
  if(std::signal(SIGPIPE, stop_quietly) == SIG_IGN)
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
