// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The slab route with parts of any size, so that few points make many parts.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H

#include "pairs.h"

#include <CGAL/fixed_radius_near_neighbors.h>

#include <optional>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Part_sizes;

// With two sets, the first `first_set_size` points are those of the first.
template <int Dimension, class Point, class NT>
Pairs slab_pairs(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& distance_bound,
                 const Part_sizes& sizes, std::optional<std::size_t> first_set_size = std::nullopt)
{
  using Elements = internal::Elements<std::vector<Point>>;
  using Number = internal::Coordinate_t<Point>;
  Pairs pairs;
  if(points.empty())
    return pairs;
  const Elements elements(points);
  const internal::Squared_bound<internal::Exact_number_t<Number>> bound(distance_bound);
  internal::Doubles<Elements> doubles(elements);
  const internal::Coordinate_scan scan = internal::scan_coordinates<CGAL::Sequential_tag>(
    elements, "point",
    [&](std::size_t position, int axis, double x) { doubles.set(position, axis, x); });
  const CGAL::Scene_profile profile = internal::make_profile(points.size(), scan, bound);
  const CGAL::Thick_point_traits_d<Point> traits(bound, profile);
  const auto is_within = traits.do_intersect_d_object();
  const internal::Slab_route<CGAL::Sequential_tag, Dimension, Elements> route(
    elements, doubles, scan.error, profile, is_within, sizes);
  auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  internal::Pair_reporter<decltype(callback)> report(callback);
  internal::No_progress progress;
  if(first_set_size)
    route.search(*first_set_size, report, progress);
  else
    route.search(report, progress);
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
