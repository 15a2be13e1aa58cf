// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes on the lazy exact kernel for points of any dimension, fixed when compiled or not.

#include "support/check_kernel.h"

#include <CGAL/Epeck_d.h>

using namespace test_support;

template <int Dimension>
using Static_points = Points_d<CGAL::Epeck_d<CGAL::Dimension_tag<Dimension>>>;
using Dynamic_points = Points_d<CGAL::Epeck_d<CGAL::Dynamic_dimension_tag>>;

// No double is a third.
template <class Maker>
void check_thirds(int dimension)
{
  using FT = typename CGAL::Kernel_traits<typename Maker::Point>::Kernel::FT;
  std::vector<typename Maker::Point> points;
  for(const Coordinates& c : lattice_points(dimension, 3, 1)) {
    std::vector<FT> thirds;
    for(const double x : c)
      thirds.push_back(FT(x) / FT(3));
    points.emplace_back(thirds.begin(), thirds.end());
  }
  const auto bound = CGAL::within_distance(CGAL::Exact_rational(1) / 3);
  const std::size_t lines = dimension == 2 ? 6 : 27;
  BOOST_CHECK_EQUAL(near_pairs(points, bound).size(), 2 * lines);
  BOOST_CHECK(near_pairs(points, bound.open()).empty());
  BOOST_CHECK(CGAL::closest_pair(points) == Pair(0, 1));
}

BOOST_AUTO_TEST_CASE(epeck_d_thirds)
{
  check_thirds<Static_points<3>>(3);
  check_thirds<Dynamic_points>(2);
  check_thirds<Dynamic_points>(3);
}

BOOST_AUTO_TEST_CASE(epeck_d_3) { check_kernel<Static_points<3>>(3); }
BOOST_AUTO_TEST_CASE(epeck_d_dynamic_2) { check_kernel<Dynamic_points>(2); }
BOOST_AUTO_TEST_CASE(epeck_d_dynamic_5) { check_kernel<Dynamic_points>(5); }
