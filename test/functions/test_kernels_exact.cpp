// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every scene on the kernels whose coordinates are exact numbers.

#include "support/check_kernel.h"

#include <CGAL/Homogeneous.h>

using namespace test_support;

using Integer_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;

namespace {

// All coordinates divided by three, which leaves few doubles.
template <class Kernel, int Dimension>
struct Thirds : Cartesian_points<Kernel, Dimension>
{
  using FT = typename Kernel::FT;
  using Point = typename Cartesian_points<Kernel, Dimension>::Point;

  static Point make(const Coordinates& c)
  {
    return Thirds::Types::point([&](std::size_t axis) { return FT(FT(c[axis]) / FT(3)); });
  }
};

// Coordinates are quotients of big integers, so that all of the time is spent in allocations; where
// addresses are watched these take ten times as long. A closest pair needs few of them.
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t max_size = 150;
constexpr std::size_t max_closest_size = 150;
#else
constexpr std::size_t max_size = 400;
constexpr std::size_t max_closest_size = 100000;
#endif

template <int Dimension>
void check_quotients()
{
  for(Point_scene scene : all_scenes(Dimension)) {
    scene.points.resize((std::min)(scene.points.size(), max_closest_size));
    check_closest_scene<Homogeneous_points<Integer_kernel, Dimension>>(scene);
    scene.points.resize((std::min)(scene.points.size(), max_size));
    check_scene<Homogeneous_points<Integer_kernel, Dimension>>(scene);
  }
}

BOOST_AUTO_TEST_CASE(epeck_2) { check_kernel<Cartesian_points<Epeck, 2>>(2); }
BOOST_AUTO_TEST_CASE(epeck_3) { check_kernel<Cartesian_points<Epeck, 3>>(3); }
BOOST_AUTO_TEST_CASE(rational_2) { check_kernel<Cartesian_points<Rational_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(rational_3) { check_kernel<Cartesian_points<Rational_kernel, 3>>(3); }
BOOST_AUTO_TEST_CASE(homogeneous_2) { check_quotients<2>(); }
BOOST_AUTO_TEST_CASE(homogeneous_3) { check_quotients<3>(); }

// Coordinates beyond the range of doubles.

// ---- closest pairs ------------------------------------------------------------------------------

// Enough points for a join; with ties, with one closest pair, with a point whose coordinates are
// known to an eighth only, and with points that differ by less than a double tells.
template <class Kernel>
void check_closest_thirds()
{
  using FT = typename Kernel::FT;
  const Points lattice = shuffled(lattice_points(2, 40, 1), 1);
  const Points uniform = uniform_points(2, 1500, 0, 1, 2);
  for(const Points& scene : {lattice, uniform}) {
    auto points = make_points<Thirds<Kernel, 2>>(scene);
    const Pair expected = known_closest(scene).pair;
    check_pair("thirds", expected, CGAL::closest_pair(points));
    check_pair("thirds, division", expected, closest_by_division(points));
    points.emplace_back(FT(1e15) + FT(1) / FT(3), FT(0));
    check_pair("outlier", expected, CGAL::closest_pair(points));

    // The squared distance of the closest pair is a ninth of that of the scene.
    CGAL::Exact_rational square = internal::exact_squared_distance(
      Cartesian_points<Rational_kernel, 2>::make(scene[expected.first]),
      Cartesian_points<Rational_kernel, 2>::make(scene[expected.second]), 2);
    square /= 9;
    BOOST_CHECK(CGAL::has_close_pair(points, CGAL::within_squared_distance(square)));
    BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_squared_distance(square).open()));
    points.emplace_back(points[7].x() + FT(1) / FT(1e30), points[7].y());
    check_pair("less than a double tells", Pair(7, points.size() - 1),
               CGAL::closest_pair(points));
    const auto tiny = CGAL::within_distance(CGAL::Exact_rational(1) / CGAL::Exact_rational(1e30));
    BOOST_CHECK(CGAL::find_close_pair(points, tiny) == Pair(7, points.size() - 1));
    BOOST_CHECK(!CGAL::has_close_pair(points, tiny.open()));
    points.push_back(points[9]);
    check_pair("equal", Pair(9, points.size() - 1), CGAL::closest_pair(points));
  }
}

BOOST_AUTO_TEST_CASE(closest_pair_between_the_doubles)
{
  check_closest_thirds<Epeck>();
  check_closest_thirds<Rational_kernel>();
}

BOOST_AUTO_TEST_CASE(coordinates_beyond_the_doubles)
{
  CGAL::Exact_rational huge(1e300);
  huge *= huge;
  std::vector<Rational_kernel::Point_2> points
    = {{huge, 0}, {huge + 3, 4}, {huge + 3, 8}, {-huge, 0}};
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(5)) == (Pairs{{0, 1}, {1, 2}}));
  const auto far = CGAL::within_distance(CGAL::Exact_rational(3 * huge));
  BOOST_CHECK_EQUAL(near_pairs(points, far).size(), 6u);
  BOOST_CHECK(CGAL::closest_pair(points) == Pair(1, 2));
  BOOST_CHECK(CGAL::find_close_pair(points, CGAL::within_distance(4)) == Pair(1, 2));
  BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(4).open()));
  for(int i = 0; i < 2000; ++i)
    points.emplace_back(huge + 100 + 5 * i, 5 * i);
  BOOST_CHECK(CGAL::closest_pair(points) == Pair(1, 2));
  BOOST_CHECK(CGAL::find_close_pair(points, CGAL::within_distance(4)) == Pair(1, 2));
}

} // namespace
