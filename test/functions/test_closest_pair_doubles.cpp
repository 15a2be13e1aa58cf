// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair of doubles: larger scenes with ties, crowds and extremes. The
// scenes of all kernels are in test_kernels_*.

#include "support/check_closest_pair.h"
#include "support/check_pairs.h"
#include "support/rounding_mode.h"

using namespace test_support;

using Point = Epick::Point_2;

// ---- scenes that are large enough for a join ----------------------------------------------------

namespace {

template <int Dimension>
void check_large(const std::string& name, const Points& scene)
{
  BOOST_TEST_CONTEXT(name << ' ' << Dimension << 'D')
  check_closest_and_close_pair<Epick_points<Dimension>>(scene);
}

template <int Dimension>
void check_large_scenes()
{
  const std::size_t n = 2500;
  const Points uniform = uniform_points(Dimension, n, -0.3, 1, 1);
  const Points lattice
    = shuffled(lattice_points(Dimension, Dimension == 2 ? 40 : 12, 1, -6), 2);
  check_large<Dimension>("uniform", uniform);
  check_large<Dimension>("clusters", clustered_points(Dimension, n, 9, 1. / 4096, 3));
  check_large<Dimension>("lattice", lattice);
  check_large<Dimension>("lattice of tenths", moved(lattice, 0.1, 0));
  check_large<Dimension>("lattice far away", moved(lattice, 1, 1e15));
  check_large<Dimension>("huge", moved(uniform, 1e200, 0));
  check_large<Dimension>("huge lattice", moved(lattice, 1e200, 0));
  check_large<Dimension>("tiny", moved(uniform, 1e-200, 0));
  check_large<Dimension>("denormal", moved(lattice, 5e-324, 0));
  check_large<Dimension>("small lattice", moved(lattice, 0x1p-1030, 0));
  check_large<Dimension>("large lattice", moved(lattice, 0x1p600, 0));
  check_large<Dimension>("as large as doubles are", moved(uniform, 1e308, 0));

  Points outlier = uniform;
  outlier[n / 2] = Coordinates(Dimension, 1e15);
  check_large<Dimension>("outlier", outlier);
  Points pair_far_out = outlier; // beyond 2^63 cells of their distance
  pair_far_out[1] = Coordinates(Dimension, 1e15);
  pair_far_out[1][0] = std::nextafter(1e15, 0);
  check_large<Dimension>("pair far out", moved(pair_far_out, 1, 0));

  Points steps; // ever smaller: half of the points are in a cell of any size
  for(int i = 0; i < 1200; ++i)
    steps.push_back(Coordinates(Dimension, std::ldexp(1., -i % 1000) * (1 + i / 1000)));
  check_large<Dimension>("steps to zero", shuffled(steps, 4));

  Points twins = uniform; // neighbours in the input, so that a sample has no twins
  for(std::size_t i = 0; i + 1 < n; i += 2) {
    twins[i + 1] = twins[i];
    twins[i + 1][0] += 1e-9 * (1 + static_cast<double>((i * 7919) % n));
  }
  check_large<Dimension>("twins", twins);
  for(int axis = 0; axis < Dimension; ++axis)
    check_large<Dimension>("line", shuffled(axis_points(Dimension, 1200, axis, -9.9, 0.1), 5));
}

} // namespace

BOOST_AUTO_TEST_CASE(large_scenes_2) { check_large_scenes<2>(); }
BOOST_AUTO_TEST_CASE(large_scenes_3) { check_large_scenes<3>(); }

BOOST_AUTO_TEST_CASE(the_first_two_of_equal_points)
{
  const Points uniform = uniform_points(2, 3000, 0, 1, 6);
  for(const std::size_t copies : {2, 3})
    check_large<2>("copies", shuffled(repeated(uniform, copies), 7));
  Points points = uniform; // two sets of equal points; the second set starts first
  points[2000] = points[2500] = points[1500];
  points[2999] = points[1000];
  check_large<2>("a few copies", points);
  BOOST_CHECK(CGAL::closest_pair(make_points<Epick_points<2>>(points)) == Pair(1000, 2999));
  points[5] = {0., 1.};
  points[6] = {-0., 1.};
  check_large<2>("plus and minus zero", points);

  const std::vector<Point> same(1000000, Point(1, 2)); // not quadratic
  BOOST_CHECK(CGAL::closest_pair(same) == Pair(0, 1));
  BOOST_CHECK(CGAL::has_close_pair(same, CGAL::within_distance(0)));
  BOOST_CHECK(!CGAL::has_close_pair(same, CGAL::within_distance(0).open()));
  BOOST_CHECK(closest_by_division(same) == Pair(0, 1));
}

// The leaves of the recursion, and what is just above them.
BOOST_AUTO_TEST_CASE(a_few_points_of_a_small_lattice)
{
  std::mt19937_64 random(21);
  for(std::size_t n = 2; n <= 7; ++n)
    for(int repetition = 0; repetition < 100; ++repetition) {
      Points points;
      for(std::size_t i = 0; i < n; ++i)
        points.push_back({static_cast<double>(random() % 12), static_cast<double>(random() % 12)});
      BOOST_TEST_CONTEXT(n << " points, repetition " << repetition)
      check_closest_and_close_pair<Epick_points<2>>(points);
    }
}

// Squares that are rounded to one double, or that differ by less than their errors.
BOOST_AUTO_TEST_CASE(the_closest_of_near_ties)
{
  for(const double scale : {1., 0x1p-600, 0x1p600, 0x1p-1020})
    for(const double tiny : {0x1p-30, 0x1p-40, 0x1p-51}) {
      const Points far = {{0, 0, 0}, {scale, scale * tiny, 0}}, near = {{0, 0, 9}, {scale, 0, 9}};
      for(const bool is_first : {false, true}) {
        Points scene_points = is_first ? concatenated(near, far) : concatenated(far, near);
        for(Coordinates& c : scene_points)
          c[2] *= 1e3 * scale;
        const auto points = make_points<Epick_points<3>>(scene_points);
        const Pair closest = is_first || scale * tiny == 0 ? Pair(0, 1) : Pair(2, 3);
        BOOST_CHECK(CGAL::closest_pair(points) == closest);
      }
    }
}

// Squares whose order is another one as they are rounded. Two points have almost the same distance
// from the origin, because they have almost the same coordinates, in another order.
BOOST_AUTO_TEST_CASE(the_closest_of_rounded_squares)
{
  Random random(5);
  const auto square = [](const Coordinates& c) { return c[0] * c[0] + c[1] * c[1] + c[2] * c[2]; };
  int count = 0;
  for(int i = 0; i < 1000; ++i) {
    const Coordinates v = {random.uniform(), random.uniform(), random.uniform()};
    const Coordinates w = {v[2], v[0], std::nextafter(v[1], 0.)};
    count += square(v) < square(w);
    const auto points = make_points<Epick_points<3>>({{0, 0, 0}, v, {-w[0], -w[1], -w[2]}});
    BOOST_CHECK(CGAL::closest_pair(points) == Pair(0, 2));
  }
  BOOST_CHECK_GT(count, 10);

  // Squares that underflow: of .4 and .6 of the smallest number, and .8 is more than .6.
  const double x = 0x1p-537 * std::sqrt(.4), y = 0x1p-537 * std::sqrt(.6);
  const auto points = make_points<Epick_points<3>>({{0, 0, 0}, {x, x, 0}, {0, 0, 1}, {y, 0, 1}});
  BOOST_CHECK(CGAL::closest_pair(points) == Pair(2, 3));
}

// Some rounding modes make the largest double of differences that overflow. In the second scene,
// the distances from the first point are the same.
BOOST_AUTO_TEST_CASE(the_closest_of_points_whose_differences_overflow)
{
  const double unit = 0x1p1020, shift = 0x1p971;
  for(const int mode : rounding_modes)
    for(const double sign : {1., -1.}) {
      const double u = sign * unit;
      const auto points = make_points<Epick_points<2>>({{-11 * u, 0}, {11 * u, 0}, {0, 15 * u}});
      const auto ties = make_points<Epick_points<2>>({{-12.5 * u, -12 * u + shift},
                                                      {-5.5 * u, 12 * u + shift},
                                                      {12.5 * u, -12 * u + shift}});
      const Rounding_mode rounding(mode);
      BOOST_CHECK(CGAL::closest_pair(points) == Pair(0, 2));
      BOOST_CHECK(CGAL::closest_pair(ties) == Pair(0, 1));
    }
}

// Nearly all points are in the strip, so that it is cut into cells; the closest pair is often in
// two of them.
BOOST_AUTO_TEST_CASE(closest_pair_of_a_wall)
{
  for(std::uint64_t seed = 0; seed < 20; ++seed) {
    Points wall = uniform_points(3, 200, 0, 1, seed);
    for(Coordinates& c : wall)
      c[0] /= 1048576;
    BOOST_TEST_CONTEXT("seed " << seed)
    check_closest_pair<Epick_points<3>>(wall);
  }
}

// ---- bounds of any size -------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(bounds_of_any_size)
{
  const double least = std::numeric_limits<double>::denorm_min();
  const double greatest = (std::numeric_limits<double>::max)();
  Points scene = uniform_points(2, 3000, 0, 1, 8);
  scene[10] = {greatest, greatest};
  scene[20] = {-greatest, -greatest};
  scene[30] = {-least, least};
  const auto points = make_points<Epick_points<2>>(scene);
  for(const double r : {0., least, 1e-300, 1e-20})
    BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(r)));
  for(const double r : {1e-2, 1., 1e100, greatest, infinity})
    BOOST_CHECK(CGAL::has_close_pair(points, CGAL::within_distance(r)));

  scene[40] = {0, least}; // one step to the right
  const auto pair = CGAL::find_close_pair(make_points<Epick_points<2>>(scene),
                                          CGAL::within_distance(least));
  BOOST_CHECK(pair == Pair(30, 40));
  BOOST_CHECK(!CGAL::has_close_pair(make_points<Epick_points<2>>(scene),
                                    CGAL::within_distance(least).open()));
}

BOOST_AUTO_TEST_CASE(close_pair_is_a_function_of_the_input)
{
  const auto points = make_points<Epick_points<2>>(uniform_points(2, 5000, 0, 1, 16));
  for(const double r : {0.5, 0.01, 0.001})
    BOOST_CHECK(CGAL::find_close_pair(points, CGAL::within_distance(r))
                == CGAL::find_close_pair(points, CGAL::within_distance(r)));
}
