// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search of search.h for any CGAL kernel: this is where the library is used.

#ifndef NEAR_PAIRS_SEARCH_WITH_KERNEL_H
#define NEAR_PAIRS_SEARCH_WITH_KERNEL_H

#include "bound.h"
#include "error.h"
#include "progress.h"
#include "rational.h"
#include "search.h"

#include <CGAL/Iterator_range.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_point_traits_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/tags.h>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

namespace near_pairs {

template <class FT>
FT coordinate_as(const Scene& scene, std::size_t at)
{
  if constexpr(!std::is_floating_point_v<FT>)
    if(!scene.exact.empty())
      return FT(scene.exact[at].value);
  return FT(scene.doubles[at]);
}

// Points in the plane get z = 0: the library neither stores nor searches an axis along which all
// points have the same coordinate. So each kernel is compiled for space only.
template <class Kernel>
std::vector<typename Kernel::Point_3> points_of(const Scene& scene)
{
  using FT = typename Kernel::FT;
  std::vector<typename Kernel::Point_3> points;
  points.reserve(scene.size());
  for(std::size_t i = 0; i < scene.size(); ++i) {
    const std::size_t at = i * scene.dimension;
    points.emplace_back(coordinate_as<FT>(scene, at), coordinate_as<FT>(scene, at + 1),
                        scene.dimension == 3 ? coordinate_as<FT>(scene, at + 2) : FT(0));
  }
  return points;
}

// Compares the distance of a pair with the one that the user typed: -1, 0 or 1. The scene has
// doubles.
inline int compare_with_typed(const Scene& scene, const Search_options& options, std::size_t i,
                              std::size_t j, const Offset& offset)
{
  CGAL::Exact_rational squared(0);
  for(int axis = 0; axis < scene.dimension; ++axis) {
    const Exact_number difference = scene.exact_difference(i, j, offset, axis);
    squared += difference->value * difference->value;
  }
  const CGAL::Exact_rational& typed = options.distance->value;
  const CGAL::Exact_rational bound = options.squared ? typed : CGAL::Exact_rational(typed * typed);
  return squared < bound ? -1 : bound < squared ? 1 : 0;
}

// The points of each of two files.
template <class Point>
auto ranges_of(const std::vector<Point>& points, std::size_t first_size)
{
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(first_size);
  return std::make_pair(CGAL::make_range(points.begin(), middle),
                        CGAL::make_range(middle, points.end()));
}

// Searches one set, or two if the first of them has a size.
template <class ConcurrencyTag, class Point, class Bound, class Callback, class NamedParameters>
bool report_pairs_by(const std::vector<Point>& points, std::optional<std::size_t> first_size,
                     const Bound& bound, Callback& callback, CGAL::Scene_profile& profile,
                     const NamedParameters& parameters)
{
  if(!first_size)
    return CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(points, bound, callback, profile,
                                                             parameters);
  const auto [first, second] = ranges_of(points, *first_size);
  return CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(first, second, bound, callback, profile,
                                                           parameters);
}

// Describes the scene in `profile`. Returns false iff the search was stopped.
template <class Point, class Bound, class Callback>
bool report_pairs(const std::vector<Point>& points, std::optional<std::size_t> first_size,
                  const Bound& bound, const Search_options& options, Callback& callback,
                  CGAL::Scene_profile& profile)
{
  const auto go_on = progress_functor(options.progress);
  const auto parameters = CGAL::parameters::callback(go_on);
#ifdef CGAL_LINKED_WITH_TBB
  if(options.parallel)
    return report_pairs_by<CGAL::Parallel_tag>(points, first_size, bound, callback, profile,
                                               parameters);
#endif
  return report_pairs_by<CGAL::Sequential_tag>(points, first_size, bound, callback, profile,
                                               parameters);
}

inline void describe(const CGAL::Scene_profile& profile, Search_result& result)
{
  std::ostringstream tier, description;
  tier << profile.tier();
  description << profile;
  result.tier = tier.str();
  result.profile = description.str();
}

template <class Point>
Search_result search_points(const std::vector<Point>& points, const Scene& scene,
                            const Search_options& options, const Pair_sink& sink,
                            const Pair_sink& lost)
{
  Search_result result;
  const Exact_bound typed_bound = bound_of(options, scene.scale);
  const double excess = excess_of_longer_bound(options, scene.rounding);
  const Exact_bound bound = excess == 0 ? typed_bound : longer_bound_of(options, excess);
  const CGAL::Thick_point_traits_d<Point> strict_traits(typed_bound.open());
  const auto is_closer = strict_traits.do_intersect_d_object();
  std::mutex mutex; // the library may call from several threads
  auto callback = [&, offset = scene.first_size.value_or(0)](std::size_t i, std::size_t j) {
    j += offset;
    const bool is_far
      = (excess != 0 || !options.open) && !is_closer(points[i], points[j]);
    const int order = !is_far ? -1 : excess == 0 ? 0 : compare_with_typed(scene, options, i, j, {});
    const std::lock_guard<std::mutex> lock(mutex);
    if(order > 0)
      return lost(i, j, {});
    if(order == 0 && options.open)
      return;
    ++result.pairs;
    result.on_boundary += order == 0;
    sink(i, j, {});
  };

  CGAL::Scene_profile profile;
  const auto start = std::chrono::steady_clock::now();
  if(!report_pairs(points, scene.first_size, bound, options, callback, profile))
    throw Error("stopped");
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  describe(profile, result);
  return result;
}

template <class Kernel>
Search_result search_with_kernel(const Scene& scene, const Search_options& options,
                                 const Pair_sink& sink, const Pair_sink& lost)
{
  return search_points(points_of<Kernel>(scene), scene, options, sink, lost);
}

} // namespace near_pairs

#endif // NEAR_PAIRS_SEARCH_WITH_KERNEL_H
