// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every scene on the kernels for points of any dimension, fixed when compiled or not.

#include "support/check_kernel.h"

#include <CGAL/Epick_d.h>

using namespace test_support;

template <int Dimension>
using Static_points = Points_d<CGAL::Epick_d<CGAL::Dimension_tag<Dimension>>>;
using Dynamic_points = Points_d<CGAL::Epick_d<CGAL::Dynamic_dimension_tag>>;

BOOST_AUTO_TEST_CASE(epick_d_2) { check_kernel<Static_points<2>>(2); }
BOOST_AUTO_TEST_CASE(epick_d_3) { check_kernel<Static_points<3>>(3); }
BOOST_AUTO_TEST_CASE(epick_d_5) { check_kernel<Static_points<5>>(5); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_1) { check_kernel<Dynamic_points>(1); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_2) { check_kernel<Dynamic_points>(2); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_3) { check_kernel<Dynamic_points>(3); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_4) { check_kernel<Dynamic_points>(4); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_5) { check_kernel<Dynamic_points>(5); }

// Enough points for cuts, by boxes and by recursion. The lattice has ties along all axes.
BOOST_AUTO_TEST_CASE(epick_d_dynamic_many_points)
{
  for(const int dimension : {1, 4, 5, 8}) {
    Points many = clustered_points(dimension, 2000, 20, 1. / 16, 3);
    for(const Coordinates& c : lattice_points(dimension, dimension == 8 ? 2 : 3, 0.125))
      many.push_back(c);
    const auto points = make_points<Dynamic_points>(repeated(many, 2));
    for(const double r : {0., 0.05, 0.125, 0.25}) {
      const auto bound = CGAL::within_distance(r);
      const Pairs expected = near_pairs_by_recursion(points, bound, dimension);
      const std::string what = std::to_string(dimension) + "D, r = " + std::to_string(r);
      check_pairs(what, expected, near_pairs(points, bound));
      check_pairs(what + ", two sets", between_even_and_odd(expected),
                  near_pairs(every_other(points, 0), every_other(points, 1), bound));
    }
  }
}

// More axes than the recursion cuts: the predicate takes care of the others.
BOOST_AUTO_TEST_CASE(epick_d_dynamic_40)
{
  Points points = uniform_points(40, 200, 0, 1, 71);
  points.push_back(points.front());
  points.back()[39] += 3;
  check_scene<Dynamic_points>(scene("uniform", 40, points, Radius::of_length(2.5)));
}

BOOST_AUTO_TEST_CASE(points_of_different_dimension_are_refused)
{
  const auto points = make_points<Dynamic_points>({{0, 0}, {0, 0, 0}});
  const auto bound = CGAL::within_distance(1);
  BOOST_CHECK_THROW(near_pairs(points, bound), std::invalid_argument);
  BOOST_CHECK_THROW(CGAL::closest_pair(points), std::invalid_argument);
  BOOST_CHECK_THROW(CGAL::has_close_pair(points, bound), std::invalid_argument);
}

// ---- closest pairs ------------------------------------------------------------------------------

// What the families of the plane and of space have.
BOOST_AUTO_TEST_CASE(extremes_in_other_dimensions)
{
  for(const int d : {1, 4, 5}) {
    const Points lattice = shuffled(lattice_points(d, lattice_side(d), 1, -2), 1);
    const Points uniform = uniform_points(d, 200, 0, 1, 2);
    for(const double scale : {5e-324, 1e-200, 1e-160, 1e153, 1e200})
      for(const Points& points : {lattice, uniform})
        BOOST_TEST_CONTEXT(d << "D, scale " << scale)
        check_closest_and_close_pair<Dynamic_points>(moved(points, scale, 0));
    BOOST_TEST_CONTEXT(d << "D, far away")
    check_closest_and_close_pair<Dynamic_points>(moved(lattice, 1, 1e15));
  }
}

// Enough points in one strip for cells along two axes.
BOOST_AUTO_TEST_CASE(division_by_cells_in_dimension_4)
{
  Points wall = embedded(lattice_points(3, 12, 1), 4);
  wall.push_back({3, 3.5, 3, 0});
  for(Coordinates& c : wall)
    std::reverse(c.begin(), c.end());
  check_closest_pair<Dynamic_points>(shuffled(wall, 1));
}

BOOST_AUTO_TEST_CASE(closest_pair_in_dimension_40)
{
  Points points = uniform_points(40, 200, 0, 1, 71);
  points.push_back(points.front());
  points.back()[39] += 0.25;
  const auto made = make_points<Dynamic_points>(points);
  check_pair("default", known_closest(points).pair, CGAL::closest_pair(made));
  BOOST_CHECK(CGAL::find_close_pair(made, CGAL::within_distance(0.25)) == Pair(0, 200));
  BOOST_CHECK(!CGAL::has_close_pair(made, CGAL::within_distance(0.25).open()));
}
