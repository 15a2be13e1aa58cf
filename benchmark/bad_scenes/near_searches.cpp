// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// fixed_radius_near_neighbors() in the plane and in space, whose work is not counted.

#include "bad_scenes/Work.h"
#include "measuring/timing.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <limits>
#include <type_traits>

namespace thick_benchmark {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

template <int Dimension, bool AreTwoSets>
Work run_near(const Made_scene& scene)
{
  using Point = std::conditional_t<Dimension == 2, Kernel::Point_2, Kernel::Point_3>;
  const std::vector<Point> points = points_of<Point>(scene);
  const auto bound = CGAL::within_distance(scene.reach);
  const double limit = max_pairs_per_element * static_cast<double>(points.size());
  Work work;
  const auto count_pairs = [&] {
    CGAL::fixed_radius_near_neighbors(points, bound, [&](std::size_t, std::size_t) {
      return ++work.pairs < limit;
    });
  };
  work.seconds = processor_seconds_of(count_pairs);
  if(work.pairs >= limit)
    work.pairs = std::numeric_limits<double>::infinity();
  else if(AreTwoSets) {
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(scene.first_size);
    const std::vector<Point> first(points.begin(), middle), second(middle, points.end());
    work.seconds = processor_seconds_of([&] {
      CGAL::fixed_radius_near_neighbors(first, second, bound, [](std::size_t, std::size_t) {});
    });
  }
  return work;
}

const double pi = std::acos(-1);

} // namespace

std::vector<Subject_search> near_searches()
{
  return {{"near2", 2, run_near<2, false>, pi},
          {"near3", 3, run_near<3, false>, 4 * pi / 3},
          {"near2_sets", 2, run_near<2, true>, pi},
          {"near3_sets", 3, run_near<3, true>, 4 * pi / 3}};
}

} // namespace thick_benchmark
