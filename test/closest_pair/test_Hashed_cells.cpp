// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The law of hashed cells: points within the width of a point are in the cells around it.

#include "support/plain_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Join_task.h>

BOOST_AUTO_TEST_SUITE(Hashed_cells)

using namespace test_support;

using Point = Plain_point<double>;

template <int Dimension>
std::vector<std::uint64_t> cells_around(const internal::Hashed_cells<Dimension>& cells,
                                        const Point& p)
{
  std::vector<std::uint64_t> around;
  cells.for_each_cell_around(p.coordinates.data(),
                             [&](std::uint64_t hash) { around.push_back(hash); });
  return around;
}

// Moves p along each axis by the width, rounded towards p, or by less.
Point point_within(const Point& p, double width, Random& random)
{
  Point q = p;
  for(double& x : q.coordinates) {
    const double moved[] = {x - width, x + width, x + width * (random.uniform() - 0.5), x};
    double y = moved[random.below(4)];
    while(std::fabs(y - x) > width) // rounded away
      y = std::nextafter(y, x);
    x = y;
  }
  return q;
}

// The box of points within a distance of the origin.
template <int Dimension>
std::array<internal::Interval, Dimension> box_of(double size)
{
  std::array<internal::Interval, Dimension> box;
  box.fill({-size, size});
  return box;
}

// Some offsets are far out, where cells are larger than their side.
template <int Dimension>
void check_law()
{
  Random random(1);
  std::size_t are_near = 0;
  for(const double offset : {0., 1., -1., 1e6, -1e15, 1e19, 1e300})
    for(const double width : {0.5, 0.1, 1e-9, 1e-290, 1e-322, 1e200, 1e306, 1e308})
      for(const double factor : {1., 2., 16.}) {
        const auto box = box_of<Dimension>(std::fabs(offset) + 6 * width);
        const internal::Hashed_cells<Dimension> cells(box, 0, width, factor * width, 3);
        const internal::Hashed_cells<Dimension> home(box, 0, 0, factor * width, 3);
        are_near += cells.are_near();
        for(int i = 0; i < 50; ++i) {
          Point p;
          for(int axis = 0; axis < Dimension; ++axis)
            p.coordinates.push_back(offset + 10 * width * (random.uniform() - 0.5));
          const std::vector<std::uint64_t> around = cells_around(cells, p);
          const std::uint64_t cell = home.first_cell_around(
            point_within(p, width, random).coordinates.data()).hash;
          BOOST_CHECK(std::find(around.begin(), around.end(), cell) != around.end());
        }
      }
  BOOST_CHECK_GT(are_near, 20u);
  BOOST_CHECK_LT(are_near, 150u);
}

BOOST_AUTO_TEST_CASE(near_points_are_in_the_cells_around)
{
  check_law<1>();
  check_law<2>();
  check_law<3>();
  check_law<4>();
}

// The first cell is the same whether the points are known to be near or not.
BOOST_AUTO_TEST_CASE(the_first_cell_around_is_told_with_whether_there_are_others)
{
  const internal::Hashed_cells<3> near(box_of<3>(4), 0, 0.1, 0.7, 5);
  const internal::Hashed_cells<3> cells(box_of<3>(1e300), 0, 0.1, 0.7, 5);
  BOOST_CHECK(near.are_near() && !cells.are_near());
  std::size_t alone = 0;
  for(const Point& p : plain_points(uniform_points(3, 500, -2, 4, 3))) {
    const std::vector<std::uint64_t> around = cells_around(cells, p);
    BOOST_CHECK(around == cells_around(near, p));
    for(const internal::First_cell& first : {near.first_near_cell_around(p.coordinates.data()),
                                             cells.first_cell_around(p.coordinates.data())}) {
      BOOST_CHECK_EQUAL(first.hash, around.front());
      BOOST_CHECK_EQUAL(first.has_others, around.size() > 1);
      alone += !first.has_others;
    }
  }
  BOOST_CHECK_GT(alone, 200u);
  BOOST_CHECK_LT(alone, 800u);
}

// A coordinate is anywhere between its double and a double that is the error above it.
BOOST_AUTO_TEST_CASE(points_above_their_doubles_are_in_the_cells_around)
{
  Random random(7);
  const double width = 0.1, error = 0.08;
  for(const double size : {2., 1e300}) {
    const internal::Hashed_cells<2> cells(box_of<2>(size), error, width, 0.3, 5);
    const internal::Hashed_cells<2> home(box_of<2>(size), 0, 0, 0.3, 5);
    for(int i = 0; i < 500; ++i) {
      const Point p = {{random.uniform(), random.uniform()}};
      Point q = p;
      for(double& x : q.coordinates)
        x += error * static_cast<double>(random.below(2));
      const std::uint64_t cell
        = home.first_cell_around(point_within(q, width, random).coordinates.data()).hash;
      const std::vector<std::uint64_t> around = cells_around(cells, p);
      BOOST_CHECK(std::find(around.begin(), around.end(), cell) != around.end());
    }
  }
}

BOOST_AUTO_TEST_CASE(points_far_out_on_either_side_are_not_near)
{
  for(const double far : {1e17, -1e17}) {
    std::array<internal::Interval, 2> box = box_of<2>(1);
    box[1].add(internal::Interval{far, far});
    BOOST_CHECK(!internal::Hashed_cells<2>(box, 0, 0.1, 1, 3).are_near());
    BOOST_CHECK(internal::Hashed_cells<2>(box, 0, 0.1, 1e9, 3).are_near());
  }
}

BOOST_AUTO_TEST_CASE(cells_fit_all_distances_beyond_the_errors)
{
  using internal::do_cells_fit;
  BOOST_CHECK(do_cells_fit(1, 0) && do_cells_fit(1, 0.5) && do_cells_fit(0x1p-1074, 0)
              && do_cells_fit(0x1p1023, 0));
  BOOST_CHECK(do_cells_fit(std::numeric_limits<double>::infinity(), 0));
  BOOST_CHECK(!do_cells_fit(1, 0.6) && !do_cells_fit(0, 0));
}

BOOST_AUTO_TEST_SUITE_END()
