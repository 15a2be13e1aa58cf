// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair does not depend on the number of threads, by any method.

#include "support/check_closest_pair.h"

#include <tbb/global_control.h>

using namespace test_support;

namespace {

template <int Dimension>
void check_parallel(const std::string& name, const Points& scene)
{
  BOOST_TEST_CONTEXT(name << ' ' << Dimension << 'D')
  {
    const auto points = make_points<Epick_points<Dimension>>(scene);
    const Pair expected = CGAL::closest_pair(points);
    check_pair("division", expected, closest_by_division(points));
    const double distance
      = std::sqrt(CGAL::squared_distance(points[expected.first], points[expected.second]));
    for(const std::size_t threads : {1, 2, 4, 7}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      check_pair("parallel", expected, CGAL::closest_pair<CGAL::Parallel_tag>(points));
      check_pair("parallel division", expected,
                 closest_by_division<CGAL::Parallel_tag>(points));
      for(const double factor : {0.5, 1.5, 1000.}) {
        const auto bound = CGAL::within_distance(factor * distance);
        BOOST_CHECK_EQUAL(CGAL::has_close_pair<CGAL::Parallel_tag>(points, bound),
                          CGAL::has_close_pair(points, bound));
      }
    }
  }
}

template <int Dimension>
void check_parallel_scenes()
{
  const Points uniform = uniform_points(Dimension, 50000, 0, 1, 1);
  check_parallel<Dimension>("uniform", uniform);
  check_parallel<Dimension>("lattice", shuffled(lattice_points(Dimension, Dimension == 2 ? 200 : 34,
                                                               1), 2));
  check_parallel<Dimension>("clusters", clustered_points(Dimension, 30000, 20, 1. / 4096, 3));
  check_parallel<Dimension>("copies", shuffled(repeated(uniform, 2), 4));
  check_parallel<Dimension>("huge lattice", lattice_points(Dimension, Dimension == 2 ? 80 : 18,
                                                           1e200));
}

} // namespace

// Coordinates over the distance overflow.
BOOST_AUTO_TEST_CASE(usual_points_and_a_tiny_distance)
{
  using Points_in_plane = std::vector<Epick::Point_2>;
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  Points_in_plane points;
  for(int i = 0; i < 10000; ++i)
    points.emplace_back(10 + i * 1e-3, 10 + (i * 7919 % 10000) * 1e-3);
  for(const double distance : {(std::numeric_limits<double>::min)(), 1e-305, 1e-290})
    BOOST_CHECK(!CGAL::has_close_pair<CGAL::Parallel_tag>(points, CGAL::within_distance(distance)));

  points = {{1.5, 0}, {1.5, 1e-310}};
  for(int i = 1; i < 10000; ++i)
    points.emplace_back(1 + i * 1e-5, .5 + i * 1e-5);
  check_pair("parallel", Pair(0, 1), CGAL::closest_pair<CGAL::Parallel_tag>(points));
}

BOOST_AUTO_TEST_CASE(same_pair_in_the_plane) { check_parallel_scenes<2>(); }
BOOST_AUTO_TEST_CASE(same_pair_in_space) { check_parallel_scenes<3>(); }
