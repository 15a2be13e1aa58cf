// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Searches of points in space that repeats, ours and others, in one form.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_PERIODIC_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_PERIODIC_METHODS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

namespace thick_benchmark {

struct Periodic_scene
{
  std::string name;
  std::vector<std::array<double, 3>> points;
  std::array<std::array<double, 3>, 3> vectors; // all of them repeat
  double r;
};

// The point i and the point j moved by the offset: i < j, or i = j and a positive offset.
using Offset = std::array<std::int32_t, 3>;
using Image_pair = std::tuple<std::int32_t, std::int32_t, Offset>;
using Image_pairs = std::vector<Image_pair>;

// Returns a pair in the order of Image_pair.
inline Image_pair ordered(const Image_pair& pair)
{
  const auto& [i, j, offset] = pair;
  if(i < j || (i == j && offset > Offset{}))
    return pair;
  return {j, i, Offset{-offset[0], -offset[1], -offset[2]}};
}

// What a method makes of a scene, which outlives it.
struct Periodic_run
{
  std::function<std::size_t()> count; // searches, and returns how many pairs or neighbors it found
  std::function<Image_pairs()> pairs; // the same pairs, in any order
};

struct Periodic_method
{
  std::string name;
  bool is_open; // whether points at the distance are no pair
  std::function<Periodic_run(const Periodic_scene&)> prepare;
};

Periodic_method periodic_counted();      // ours, by a callback that counts
Periodic_method periodic_stored();       // ours, by a callback that stores pairs
Periodic_method periodic_lists();        // ours, lists of all neighbors
Periodic_method points_without_periods(); // ours: the pairs that no offset moves
Periodic_method vesin_half_list();       // of each two neighbors, one is in the list of the other
Periodic_method vesin_full_list();

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_PERIODIC_METHODS_H
