// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair on the kernels whose coordinates are not doubles, and on those
// for points of any dimension.

#define BOOST_TEST_MODULE closest_pair_kernels
#include "support/check_closest_pair.h"
#include "support/data_facts.h"
#include "support/mpfr_kernel_number.h"

#include <CGAL/Epick_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Simple_cartesian.h>

using namespace test_support;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Integer_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;
using Mpfr_kernel = CGAL::Simple_cartesian<Mpfr_number<30>>; // decimal digits: 53 bits fit

template <int Dimension>
using Static_points = Points_d<CGAL::Epick_d<CGAL::Dimension_tag<Dimension>>>;
using Dynamic_points = Points_d<CGAL::Epick_d<CGAL::Dynamic_dimension_tag>>;

// Where addresses are watched, numbers with memory of their own take ten times as long.
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t max_size = 150;
#else
constexpr std::size_t max_size = 100000;
#endif

template <class Maker>
void check_scenes(int dimension)
{
  for(Point_scene scene : closest_pair_scenes(dimension)) {
    scene.points.resize((std::min)(scene.points.size(), max_size));
    check_closest_scene<Maker>(scene);
  }
}

BOOST_AUTO_TEST_CASE(epeck_2) { check_scenes<Cartesian_points<Epeck, 2>>(2); }
BOOST_AUTO_TEST_CASE(epeck_3) { check_scenes<Cartesian_points<Epeck, 3>>(3); }
BOOST_AUTO_TEST_CASE(rational_2) { check_scenes<Cartesian_points<Rational_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(rational_3) { check_scenes<Cartesian_points<Rational_kernel, 3>>(3); }
BOOST_AUTO_TEST_CASE(mpfr_2) { check_scenes<Cartesian_points<Mpfr_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(mpfr_3) { check_scenes<Cartesian_points<Mpfr_kernel, 3>>(3); }
BOOST_AUTO_TEST_CASE(homogeneous_2) { check_scenes<Homogeneous_points<Integer_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(homogeneous_3) { check_scenes<Homogeneous_points<Integer_kernel, 3>>(3); }
BOOST_AUTO_TEST_CASE(epick_d_2) { check_scenes<Static_points<2>>(2); }
BOOST_AUTO_TEST_CASE(epick_d_3) { check_scenes<Static_points<3>>(3); }
BOOST_AUTO_TEST_CASE(epick_d_5) { check_scenes<Static_points<5>>(5); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_1) { check_scenes<Dynamic_points>(1); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_2) { check_scenes<Dynamic_points>(2); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_3) { check_scenes<Dynamic_points>(3); }
BOOST_AUTO_TEST_CASE(epick_d_dynamic_4) { check_scenes<Dynamic_points>(4); }

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

BOOST_AUTO_TEST_CASE(dimension_40)
{
  Points points = uniform_points(40, 200, 0, 1, 71);
  points.push_back(points.front());
  points.back()[39] += 0.25;
  const auto made = make_points<Dynamic_points>(points);
  check_pair("default", known_closest(points).pair, CGAL::closest_pair(made));
  BOOST_CHECK(CGAL::find_close_pair(made, CGAL::within_distance(0.25)) == Pair(0, 200));
  BOOST_CHECK(!CGAL::has_close_pair(made, CGAL::within_distance(0.25).open()));
}

BOOST_AUTO_TEST_CASE(points_of_different_dimension_are_refused)
{
  const auto points = make_points<Dynamic_points>({{0, 0}, {0, 0, 0}});
  BOOST_CHECK_THROW(CGAL::closest_pair(points), std::invalid_argument);
  BOOST_CHECK_THROW(CGAL::has_close_pair(points, CGAL::within_distance(1)),
                    std::invalid_argument);
}

// ---- coordinates that are no doubles ------------------------------------------------------------

namespace {

template <class Kernel>
std::vector<typename Kernel::Point_2> divided_by_three(const Points& points)
{
  using FT = typename Kernel::FT;
  std::vector<typename Kernel::Point_2> result;
  for(const Coordinates& c : points)
    result.emplace_back(FT(c[0]) / FT(3), FT(c[1]) / FT(3));
  return result;
}

// Enough points for a join; with ties, with one closest pair, with a point whose coordinates are
// known to an eighth only, and with points that differ by less than a double tells.
template <class Kernel>
void check_thirds()
{
  using Point = typename Kernel::Point_2;
  using FT = typename Kernel::FT;
  const Points lattice = shuffled(lattice_points(2, 40, 1), 1);
  const Points uniform = uniform_points(2, 1500, 0, 1, 2);
  for(const Points& scene : {lattice, uniform}) {
    std::vector<Point> points = divided_by_three<Kernel>(scene);
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

} // namespace

BOOST_AUTO_TEST_CASE(coordinates_between_the_doubles)
{
  check_thirds<Epeck>();
  check_thirds<Rational_kernel>();
}

BOOST_AUTO_TEST_CASE(coordinates_beyond_the_doubles)
{
  CGAL::Exact_rational huge(1e300);
  huge *= huge;
  std::vector<Rational_kernel::Point_2> points
    = {{huge, 0}, {huge + 3, 4}, {huge + 3, 8}, {-huge, 0}};
  BOOST_CHECK(CGAL::closest_pair(points) == Pair(1, 2));
  BOOST_CHECK(CGAL::find_close_pair(points, CGAL::within_distance(4)) == Pair(1, 2));
  BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(4).open()));
  for(int i = 0; i < 2000; ++i)
    points.emplace_back(huge + 100 + 5 * i, 5 * i);
  BOOST_CHECK(CGAL::closest_pair(points) == Pair(1, 2));
  BOOST_CHECK(CGAL::find_close_pair(points, CGAL::within_distance(4)) == Pair(1, 2));
}

// ---- real data ----------------------------------------------------------------------------------

// Files with more digits than a double has.
BOOST_AUTO_TEST_CASE(files_have_the_closest_pair_of_their_decimals)
{
  std::size_t checked = 0;
  for(const Fact& fact : facts()) {
    const auto path = find_data_file(fact.file, data_folders());
    if(!path || fact.dimension != 2)
      continue;
    const Decimal_points decimals = read_view(*path, fact.view);
    if(as_exact_doubles(decimals))
      continue;
    std::vector<Rational_kernel::Point_2> points;
    for(const auto& c : decimals.coordinates)
      points.emplace_back(exact_rational(c[0].str()), exact_rational(c[1].str()));
    BOOST_TEST_CONTEXT(fact)
    {
      check_pair("rationals", closest_of_integers(decimals.coordinates).pair,
                 CGAL::closest_pair(points));
    }
    ++checked;
  }
  BOOST_CHECK_GE(checked, 1u);
}
