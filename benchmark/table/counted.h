// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Ways to the same pairs, of which the first one is ours, and their times.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_COUNTED_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_COUNTED_H

#include "measuring/timing.h"
#include "methods/Method.h"

#include <algorithm>
#include <limits>

namespace thick_benchmark {

struct Counted_times
{
  std::string name;
  std::size_t count;
  double median;          // milliseconds
  double least;           // milliseconds
  double over_first = 1;  // the median of the quotients within the rounds
  double over_second = 1;
};

inline std::vector<Counted_times> time_in_turns(const std::vector<Counted>& ways, int rounds)
{
  std::vector<Job> jobs;
  std::vector<Counted_times> all;
  for(const Counted& way : ways) {
    all.push_back({way.name, way.count(), 0, std::numeric_limits<double>::infinity()});
    jobs.push_back(timed(way.count));
  }
  const std::vector<Seconds> times = time_in_turns(jobs, rounds, 0);
  for(std::size_t k = 0; k < all.size(); ++k) {
    all[k].median = 1000 * median(times, [=](const Seconds& s) { return s[k]; });
    for(const Seconds& s : times)
      all[k].least = (std::min)(all[k].least, 1000 * s[k]);
    all[k].over_first = median(times, [=](const Seconds& s) { return s[k] / s[0]; });
    all[k].over_second = median(times, [=](const Seconds& s) { return s[k] / s[1]; });
  }
  return all;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_COUNTED_H
