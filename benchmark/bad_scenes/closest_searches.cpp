// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// closest_pair() and find_close_pair(), on points that count how often they are looked at.

#include "bad_scenes/Work.h"
#include "measuring/timing.h"
#include "support/counted_points.h"

#include <CGAL/Dimension.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/closest_pair.h>

#include <CGAL/Thick_intersection_d/internal/closest_pair/find_closest_pair.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

namespace thick_benchmark {
namespace {

namespace internal = CGAL::Thick_intersection_d::internal;
using Kernel = CGAL::Simple_cartesian<double>;

// A point of a kernel that has nothing but its dimension.
class Point_5
{
public:
  struct R
  {
    template <class>
    struct Ambient_dimension
    {
      using type = CGAL::Dimension_tag<5>;
    };
  };

  explicit Point_5(const std::array<double, 5>& x) : x_(x) {}
  int dimension() const { return 5; }
  double cartesian(int axis) const { return x_[static_cast<std::size_t>(axis)]; }

private:
  std::array<double, 5> x_;
};

// Runs search(points), on points that count.
template <class Point, class Search>
Work run_counted(const Made_scene& scene, const Search& search)
{
  const auto points = points_of<Point>(scene);
  std::size_t looks = 0;
  const test_support::Counted_points<Point> counted = {points, looks};
  Work work;
  work.seconds = processor_seconds_of([&] { search(counted); });
  work.counted = static_cast<double>(looks);
  return work;
}

template <class Point>
Work run_closest(const Made_scene& scene)
{
  return run_counted<Point>(scene, [](const auto& points) {
    internal::find_closest_pair(points, CGAL::parameters::default_values(), internal::Threads());
  });
}

template <class Point>
Work run_close(const Made_scene& scene)
{
  return run_counted<Point>(scene, [&](const auto& points) {
    internal::find_pair_within(points, CGAL::within_distance(scene.reach),
                               CGAL::parameters::default_values(), internal::Threads());
  });
}

} // namespace

std::vector<Subject_search> closest_searches()
{
  return {{"closest2", 2, run_closest<Kernel::Point_2>, 0},
          {"closest3", 3, run_closest<Kernel::Point_3>, 0},
          {"closest5", 5, run_closest<Point_5>, 0},
          {"close2", 2, run_close<Kernel::Point_2>, 0},
          {"close3", 3, run_close<Kernel::Point_3>, 0},
          {"close5", 5, run_close<Point_5>, 0}};
}

} // namespace thick_benchmark
