// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search, functions of each kernel. They are compiled in a file for each kernel from the
// templates in search_with_kernel.h and closest_with_kernel.h, and those of a scene that repeats in
// search_periodic.cpp. stop.h stops them.

#ifndef NEAR_PAIRS_SEARCH_H
#define NEAR_PAIRS_SEARCH_H

#include "exact_number.h"
#include "scene.h"
#include "search_options.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace near_pairs {

struct Search_result
{
  std::size_t pairs = 0;
  std::size_t on_boundary = 0; // pairs exactly at the distance, if the bound is closed
  double seconds = 0;
  std::size_t crossing = 0;    // pairs with an image in another cell, if the scene repeats
  std::string tier;            // the arithmetic that the scene needed; empty: it is not known
  std::string profile;         // a description of the scene, with --explain
};

struct Closest_result
{
  std::pair<std::size_t, std::size_t> pair;
  Offset offset = {};
  Exact_number squared_distance; // in the unit of the file, exactly
  double seconds = 0;
};

// Receives each pair once, as positions in the scene, and the offset of the image of the second
// point: i < j, or i = j if a point is near an image of itself. It is never called by two threads
// at once.
using Pair_sink = std::function<void(std::size_t i, std::size_t j, const Offset& offset)>;

// Where the scene has rounded decimals, `lost` receives pairs that are beyond the distance by so
// little that rounding may be the reason.
Search_result search_epick(const Scene& scene, const Search_options& options,
                           const Pair_sink& sink, const Pair_sink& lost);
Search_result search_exact(const Scene& scene, const Search_options& options,
                           const Pair_sink& sink, const Pair_sink& lost);
Search_result search_periodic(const Scene& scene, const Search_options& options,
                              const Pair_sink& sink, const Pair_sink& lost);

// The closest pair, or that of a point of each of two files; the first one of those at the same
// distance. Throws std::invalid_argument if there are fewer than two points, or Error if a file has
// none. In a scene that repeats, one point and an image of it are a pair.
Closest_result closest_epick(const Scene& scene, const Search_options& options);
Closest_result closest_exact(const Scene& scene, const Search_options& options);
Closest_result closest_periodic(const Scene& scene, const Search_options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_SEARCH_H
