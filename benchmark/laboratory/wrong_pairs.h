// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What is wrong with what a method finds.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_WRONG_PAIRS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_WRONG_PAIRS_H

#include "columns.h"
#include "run_in_child.h"

#include "measuring/timing.h"


#include <algorithm>
#include <iterator>

namespace lab {

// What came of a run in a process of its own.
struct Outcome
{
  std::string status;
  Found found;
  double seconds = 0; // from the points in the method's own type to the last pair

  bool is_ok() const { return status == "ok"; }
};

template <class Scene>
Outcome find_in_child(const Column_for<Scene>& column, const Scene& scene, unsigned int limit)
{
  // What is not a pair travels as one, at the end.
  const auto send = [&] {
    const Run<Found> run = column.prepare(scene);
    Found found;
    const double seconds = seconds_of([&] { found = run(); });
    found.pairs.emplace_back(found.is_directed, static_cast<std::size_t>(seconds * 1e9));
    return found.pairs;
  };
  Child_result<Pair> result = run_in_child(limit, send);
  if(!result.is_ok())
    return {result.status, {}};
  const Pair last = result.values.back();
  result.values.pop_back();
  return {result.status, {std::move(result.values), last.first != 0},
          1e-9 * static_cast<double>(last.second)};
}

inline std::size_t size_of_difference(const Pairs& a, const Pairs& b)
{
  Pairs difference;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                std::back_inserter(difference));
  return difference.size();
}

// The pairs that count as reported, sorted: of the neighbours of i those behind it.
inline Pairs reported(const Found& found)
{
  Pairs pairs;
  for(const Pair& pair : found.pairs)
    if(pair.first < pair.second)
      pairs.push_back(pair);
  return test_support::sorted(std::move(pairs));
}

// Pairs of which j is found from i, but i is not found from j, or the other way.
inline std::size_t count_asymmetric(const Found& found)
{
  if(!found.is_directed)
    return 0;
  Pairs back;
  for(const Pair& pair : found.pairs)
    if(pair.first > pair.second)
      back.emplace_back(pair.second, pair.first);
  return size_of_difference(reported(found), test_support::sorted(std::move(back)));
}

// Compares what a method has found with the sorted true pairs.
inline test_support::Pairs_difference wrong_pairs(const Outcome& outcome, const Pairs& truth)
{
  return outcome.is_ok() ? test_support::compare(truth, reported(outcome.found))
                         : test_support::Pairs_difference();
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_WRONG_PAIRS_H
