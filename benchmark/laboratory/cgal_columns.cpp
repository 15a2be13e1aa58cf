// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's own ways to near pairs: Compare_squared_distance, kd-trees with and without a cache of
// coordinates, and intersecting boxes.

#include "columns.h"

#include "methods/Cell_list.h"
#include "methods/box_intersection.h"
#include "methods/kd_tree.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace lab {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

auto by_compare_squared_distance()
{
  return on_points<Found, Epick>([](const auto& points, double r, Found& found) {
    for_each_candidate(points, r, [&](std::size_t i, std::size_t j) {
      if(CGAL::compare_squared_distance(points[i], points[j], r * r) != CGAL::LARGER)
        found(i, j);
    });
  });
}

template <class Kernel, class EnableCache>
auto by_kd_tree()
{
  return on_points<Found, Kernel>([](const auto& points, double r, Found& found) {
    kd_tree_search<Kernel, EnableCache>(points, r, found);
  });
}

// The pairs of boxes that meet are decided exactly, so that only lost ones are wrong.
auto by_boxes(CGAL::Box_intersection_d::Topology topology)
{
  return [topology](const Scene& scene) {
    const auto search = [topology, r = scene.r, exact = exact_points(scene)](const auto& points,
                                                                             Found& found) {
      const auto is_near
        = [&](std::size_t i, std::size_t j) { return exact.are_within_radius(i, j); };
      box_intersection<CGAL::Sequential_tag>(boxes_around(points, r, as_written), is_near, found,
                                             10, topology);
    };
    return run_on_points<Found, Epick>(scene, search);
  };
}

} // namespace

Columns cgal_columns()
{
  using CGAL::Tag_false;
  using CGAL::Tag_true;
  return {
    {{"EPICK Compare_squared_distance", by_compare_squared_distance()}, "library"},
    {{"Kd_tree EPICK", by_kd_tree<Epick, Tag_false>()}, "library"},
    {{"Kd_tree EPICK, cache", by_kd_tree<Epick, Tag_true>()}, "library"},
    {{"Kd_tree EPECK", by_kd_tree<Epeck, Tag_false>()}, "library"},
    {{"Kd_tree EPECK, cache", by_kd_tree<Epeck, Tag_true>()}, "library"},
    {{"Kd_tree rational", by_kd_tree<Rational_kernel, Tag_false>()}, "library"},
    {{"Kd_tree rational, cache", by_kd_tree<Rational_kernel, Tag_true>()}, "library"},
    {{"boxes, closed", by_boxes(CGAL::Box_intersection_d::CLOSED)}, "boxes"},
    {{"boxes, half-open", by_boxes(CGAL::Box_intersection_d::HALF_OPEN)}, "boxes"},
  };
}

} // namespace lab
