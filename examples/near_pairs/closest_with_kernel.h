// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair of search.h for any CGAL kernel.

#ifndef NEAR_PAIRS_CLOSEST_WITH_KERNEL_H
#define NEAR_PAIRS_CLOSEST_WITH_KERNEL_H

#include "closest_between.h"
#include "error.h"
#include "exact_number.h"
#include "progress.h"
#include "rational.h"
#include "search_with_kernel.h"
#include "stop.h"

#include <CGAL/closest_pair.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace near_pairs {

// In the unit of the file.
inline CGAL::Exact_rational exact_squared_distance(const Scene& scene, std::size_t i,
                                                   std::size_t j)
{
  const std::size_t dimension = scene.dimension;
  CGAL::Exact_rational sum(0);
  for(std::size_t axis = 0; axis < dimension; ++axis) {
    const CGAL::Exact_rational difference
      = coordinate_as<CGAL::Exact_rational>(scene, i * dimension + axis)
        - coordinate_as<CGAL::Exact_rational>(scene, j * dimension + axis);
    sum += difference * difference;
  }
  return sum / power_of_ten(2 * scene.scale);
}

// Positions in the scene.
template <class ConcurrencyTag, class Point>
std::pair<std::size_t, std::size_t> closest_by(const std::vector<Point>& points,
                                               std::optional<std::size_t> first_size,
                                               const Search_options& options)
{
  const auto go_on = progress_functor(options.progress);
  if(!first_size)
    return CGAL::closest_pair<ConcurrencyTag>(points, CGAL::parameters::callback(go_on));
  if(*first_size == 0 || *first_size == points.size())
    throw Error("--closest needs a point in each file");
  const auto [i, j] = Closest_between<ConcurrencyTag, Point>(points, *first_size)();
  return {i, *first_size + j};
}

template <class Point>
Closest_result closest_of_points(const std::vector<Point>& points, const Scene& scene,
                                 const Search_options& options)
{
  Closest_result result;
  const auto start = std::chrono::steady_clock::now();
#ifdef CGAL_LINKED_WITH_TBB
  if(options.parallel)
    result.pair = closest_by<CGAL::Parallel_tag>(points, scene.first_size, options);
  else
#endif
    result.pair = closest_by<CGAL::Sequential_tag>(points, scene.first_size, options);
  if(stop_requested)
    throw Error("stopped");
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto [i, j] = result.pair;
  result.squared_distance = Exact_number({exact_squared_distance(scene, i, j)});
  return result;
}

template <class Kernel>
Closest_result closest_with_kernel(const Scene& scene, const Search_options& options)
{
  return closest_of_points(points_of<Kernel>(scene), scene, options);
}

} // namespace near_pairs

#endif // NEAR_PAIRS_CLOSEST_WITH_KERNEL_H
