// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The buckets of [L]: no pair is lost, even where a cell ends, and a heavy cell ends the search.

#include "support/check_closest_pair.h"
#include "support/counted_points.h"
#include "support/plain_points.h"

BOOST_AUTO_TEST_SUITE(Close_pair_buckets)

using namespace test_support;

using Point = Epick::Point_2;

// The division has the same cells, and its orders of points.
BOOST_AUTO_TEST_CASE(buckets_and_the_division_find_the_pairs_of_scenes)
{
  for(const int dimension : {1, 2, 3, 4})
    for(const Point_scene& scene : small_scenes(dimension))
      BOOST_TEST_CONTEXT(scene)
      {
        const auto points = plain_points(scene.points);
        const Truth& truth = truth_of(scene);
        with_bound(scene.radius, [&](const auto& bound) {
          check_close_pair("closed", truth.pairs, close_by_buckets(points, bound));
          check_close_pair("open", truth.open_pairs, close_by_buckets(points, bound.open()));
        });
        if(points.size() >= 2)
          check_pair("division", known_closest(scene.points).pair, closest_by_division(points));
      }
}

// Cells of side r: rounded numbers of cells near the end of a cell.
BOOST_AUTO_TEST_CASE(cells_lose_no_pair_at_the_bound)
{
  for(int i = -50; i < 50; ++i) {
    const double x = 2 + std::ldexp(i, -18);
    const std::vector<Point> points = {{0, 0}, {x, 0}, {x + 1, 0}};
    BOOST_CHECK(close_by_buckets(points, CGAL::within_distance(1)) == Pair(1, 2));
  }
}

// The points lie just below the ends of cells of side r: one product is rounded down, and the other
// one up, so cells of exactly this side would not be adjacent.
BOOST_AUTO_TEST_CASE(rounding_at_the_ends_of_cells_loses_no_pair)
{
  const double cases[][3] = {{0x1.53e0472022b4ep+0, 0x1.53e0472022b4dp+1, 0x1.fdd06ab0340f4p+1},
                             {0x1.9e4cd601dd2b4p+0, 0x1.9e4cd601dd2b3p+2, 0x1.02f005c12a3b0p+3},
                             {0x1.991ba3cfcbb26p+0, 0x1.991ba3cfcbb25p+4, 0x1.b2ad5e0cc86d7p+4}};
  for(const auto& [r, x, y] : cases) {
    const std::vector<Point> points = {{0, 0}, {x, 0}, {y, 0}};
    BOOST_CHECK(close_by_buckets(points, CGAL::within_distance(r)) == Pair(1, 2));
  }
}

// Points in cells of their own, before them the corners of a cell, which are not closer than 1, and
// behind them five points in a cell, two of which are, but not two of the first four.
std::vector<Point> points_before_a_heavy_cell()
{
  const double side = 1 + std::ldexp(1., -16);
  const double low = 64 * side + std::ldexp(1., -18);
  std::vector<Point> points;
  for(const double x : {0., low})
    for(const Coordinates& c : lattice_points(2, 2, 1))
      points.emplace_back(x + c[0], x + c[1]);
  points.emplace_back(low + 0.5, low + 0.5);
  for(const Coordinates& c : lattice_points(2, 20, 3, 3))
    points.emplace_back(c[0], c[1]);
  return points;
}

// Each point for its cell along each axis, and the pairs of the five.
BOOST_AUTO_TEST_CASE(heavy_cell_ends_the_search)
{
  const std::vector<Point> points = points_before_a_heavy_cell();
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Scene scene = scene_of(Elements_of<Point>(points));
  const internal::Is_within_distance<Point> is_within(
    internal::Squared_bound<Exact_of<Point>>(CGAL::within_distance(1).open()), 2);
  const internal::Close_pair_buckets<Counted_points<Point>> buckets(
    counted, points.size(), scene, is_within);
  internal::Unwatched_progress progress;
  BOOST_CHECK(buckets.find(progress));
  BOOST_CHECK_LE(looks, 2 * points.size() + 20);
}

// The corners of a cube with edges as long as the bound, and its centre: 2^d points that are not
// closer, and in dimension 4 one more. All of them are in one cell, as its side is a little longer.
BOOST_AUTO_TEST_CASE(as_many_points_as_a_cell_holds)
{
  const auto corners = make_points<Epick_points<2>>(lattice_points(2, 2, 3, 1));
  BOOST_CHECK(CGAL::has_close_pair(corners, CGAL::within_distance(3)));
  BOOST_CHECK(!CGAL::has_close_pair(corners, CGAL::within_distance(3).open()));
  const auto corners_3 = make_points<Epick_points<3>>(lattice_points(3, 2, 3, 1));
  BOOST_CHECK(CGAL::has_close_pair(corners_3, CGAL::within_distance(3)));
  BOOST_CHECK(!CGAL::has_close_pair(corners_3, CGAL::within_distance(3).open()));
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(1), 2u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(2), 4u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(3), 8u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(4), 81u); // 17 are possible
}

BOOST_AUTO_TEST_SUITE_END()
