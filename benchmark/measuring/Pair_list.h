// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The callback that keeps the pairs, to tell how many of them differ between two searches.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_PAIR_LIST_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_PAIR_LIST_H

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace thick_benchmark {

struct Pair_list
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;

  // Searches of one set give i < j.
  void operator()(std::size_t i, std::size_t j) { pairs.emplace_back(i, j); }
};

// How many pairs of `a` are not in `b`.
inline std::size_t count_missing(Pair_list a, Pair_list b)
{
  std::sort(a.pairs.begin(), a.pairs.end());
  std::sort(b.pairs.begin(), b.pairs.end());
  Pair_list missing;
  std::set_difference(a.pairs.begin(), a.pairs.end(), b.pairs.begin(), b.pairs.end(),
                      std::back_inserter(missing.pairs));
  return missing.pairs.size();
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_PAIR_LIST_H
