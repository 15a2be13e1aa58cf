// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Times of jobs that take turns: what slows the machine down for a while slows them all, and the
// quotients of their times stay.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_TIMING_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_TIMING_H

#include <time.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace thick_benchmark {

using Seconds = std::vector<double>; // of each job in one round

// Tells the time since it was made.
class Stopwatch
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start_ = Clock::now();

public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
};

template <class Function>
double seconds_of(const Function& function)
{
  const Stopwatch watch;
  function();
  return watch.seconds();
}

// Those that the processor spent on this thread: the same on a machine that does nothing else, and
// more reliable on one that does.
template <class Function>
double processor_seconds_of(const Function& function)
{
  const auto now = [] {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  function();
  return now() - start;
}

// Does something and returns the seconds it took, without those of preparations.
using Job = std::function<double()>;

template <class Function>
Job timed(const Function& function)
{
  return [function] { return processor_seconds_of(function); };
}

// For jobs of several threads, and what is compared with them.
template <class Function>
Job timed_by_the_clock(const Function& function)
{
  return [function] { return seconds_of(function); };
}

// Runs every job once per round, one after the other, after a round that is not counted.
inline std::vector<Seconds> time_in_turns(const std::vector<Job>& jobs, int rounds,
                                          int uncounted_rounds = 1)
{
  std::vector<Seconds> times;
  for(int round = -uncounted_rounds; round < rounds; ++round) {
    Seconds seconds;
    for(const Job& job : jobs)
      seconds.push_back(job());
    if(round >= 0)
      times.push_back(seconds);
  }
  return times;
}

// The median of value(seconds) over the rounds.
template <class Value>
double median(const std::vector<Seconds>& times, const Value& value)
{
  std::vector<double> values;
  for(const Seconds& seconds : times)
    values.push_back(value(seconds));
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_TIMING_H
