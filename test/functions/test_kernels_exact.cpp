// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every scene on the Cartesian kernels whose coordinates are exact numbers.

#include "support/check_kernel.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

using namespace test_support;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

namespace {

// All coordinates divided by three, which leaves few doubles.
template <class Kernel, int Dimension>
struct Thirds : Cartesian_points<Kernel, Dimension>
{
  using FT = typename Kernel::FT;
  using Point = typename Cartesian_points<Kernel, Dimension>::Point;

  static Point make(const Coordinates& c)
  {
    if constexpr(Dimension == 2)
      return Point(FT(c[0]) / FT(3), FT(c[1]) / FT(3));
    else
      return Point(FT(c[0]) / FT(3), FT(c[1]) / FT(3), FT(c[2]) / FT(3));
  }
};

CGAL::Exact_rational square_of(const Radius& radius)
{
  if(!radius.length())
    return exact_rational(radius.square_text());
  const CGAL::Exact_rational length(*radius.length());
  return length * length;
}

// Coordinates that are doubles are searched as such, whatever their type; these by their bounds.
template <class Kernel, int Dimension>
void check_thirds(const Scenes& scenes)
{
  for(const Point_scene& scene : scenes) {
    const CGAL::Exact_rational square = square_of(scene.radius) / 9;
    check_scene<Thirds<Kernel, Dimension>>(scene, CGAL::within_squared_distance(square));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(epeck_2) { check_kernel<Cartesian_points<Epeck, 2>>(2); }
BOOST_AUTO_TEST_CASE(epeck_3) { check_kernel<Cartesian_points<Epeck, 3>>(3); }
BOOST_AUTO_TEST_CASE(rational_2) { check_kernel<Cartesian_points<Rational_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(rational_3) { check_kernel<Cartesian_points<Rational_kernel, 3>>(3); }

// Each lazy number takes memory: all scenes of these take a minute.
BOOST_AUTO_TEST_CASE(thirds_epeck_2) { check_thirds<Epeck, 2>(small_scenes(2)); }
BOOST_AUTO_TEST_CASE(thirds_epeck_3) { check_thirds<Epeck, 3>(small_scenes(3)); }
BOOST_AUTO_TEST_CASE(thirds_rational_2) { check_thirds<Rational_kernel, 2>(all_scenes(2)); }
BOOST_AUTO_TEST_CASE(thirds_rational_3) { check_thirds<Rational_kernel, 3>(all_scenes(3)); }

// Coordinates beyond the range of doubles.
BOOST_AUTO_TEST_CASE(coordinates_beyond_the_doubles)
{
  CGAL::Exact_rational huge(1e300);
  huge *= huge;
  const std::vector<Rational_kernel::Point_2> points
    = {{huge, 0}, {huge + 3, 4}, {huge + 3, 5}, {-huge, 0}};
  const Pairs expected = {{0, 1}, {1, 2}};
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(5)) == expected);
  const auto far = CGAL::within_distance(CGAL::Exact_rational(3 * huge));
  BOOST_CHECK_EQUAL(near_pairs(points, far).size(), 6u);
}
