// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What is wrong with what a method found.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_WRONG_PAIRS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_WRONG_PAIRS_H

#include "columns.h"
#include "run_in_child.h"

#include "support/point_generators.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace lab {

struct Wrong_pairs
{
  std::string status = "ok"; // or how the method ended; then the numbers mean nothing
  std::size_t missing = 0;
  std::size_t extra = 0; // with pairs that are reported twice
  std::size_t asymmetric = 0; // j is found from i, but i is not found from j
  double seconds = 0;
};

// Runs a method in a process of its own.
inline Child_result<Pair> find_in_child(const Method& method, const Point_scene& scene,
                                        unsigned int seconds, Found& found)
{
  // What is not a pair travels as one, at the end.
  const auto send = [&] {
    Found result = method.find(scene);
    result.pairs.emplace_back(result.is_directed, static_cast<std::size_t>(result.seconds * 1e9));
    return result.pairs;
  };
  Child_result<Pair> result = run_in_child(seconds, send);
  if(result.is_ok()) {
    found.is_directed = result.values.back().first != 0;
    found.seconds = 1e-9 * static_cast<double>(result.values.back().second);
    result.values.pop_back();
    found.pairs = std::move(result.values);
  }
  return result;
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

// The same points in another order, and where each of them was.
inline Point_scene reordered(const Point_scene& scene, std::vector<std::size_t>& positions)
{
  test_support::Random random(scene.points.size());
  positions.resize(scene.points.size());
  std::iota(positions.begin(), positions.end(), std::size_t(0));
  for(std::size_t i = positions.size(); i > 1; --i)
    std::swap(positions[i - 1], positions[random.below(i)]);
  Point_scene result = scene;
  for(std::size_t i = 0; i < positions.size(); ++i)
    result.points[i] = scene.points[positions[i]];
  return result;
}

// Counts the pairs that are answered differently when the input is in another order.
inline std::size_t count_order_dependent(const Method& method, const Point_scene& scene,
                                         unsigned int seconds)
{
  Found in_order, found;
  std::vector<std::size_t> positions;
  const Point_scene other = reordered(scene, positions);
  if(!find_in_child(method, scene, seconds, in_order).is_ok()
     || !find_in_child(method, other, seconds, found).is_ok())
    return 0;
  for(Pair& pair : found.pairs) {
    const std::size_t i = positions[pair.first], j = positions[pair.second];
    pair = found.is_directed ? Pair(i, j) : Pair(std::minmax(i, j));
  }
  return size_of_difference(reported(in_order), reported(found));
}

// Compares what a method finds with the sorted true pairs.
inline Wrong_pairs count_wrong_pairs(const Method& method, const Point_scene& scene,
                                     const Pairs& truth, unsigned int seconds)
{
  Wrong_pairs wrong;
  Found found;
  wrong.status = find_in_child(method, scene, seconds, found).status;
  if(wrong.status != "ok")
    return wrong;
  const Pairs pairs = reported(found);
  const test_support::Pairs_difference difference = test_support::compare(truth, pairs);
  wrong.missing = difference.missing.size();
  wrong.extra = difference.extra.size();
  wrong.asymmetric = count_asymmetric(found);
  wrong.seconds = found.seconds;
  return wrong;
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_WRONG_PAIRS_H
