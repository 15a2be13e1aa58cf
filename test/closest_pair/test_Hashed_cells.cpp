// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The law of hashed cells: points within the width of a point are in the cells around it.

#include "support/plain_points.h"
#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(Hashed_cells)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

using Point = Plain_point<double>;

template <int Dimension>
std::vector<std::uint64_t> cells_around(const internal::Hashed_cells<Dimension>& cells,
                                        const Point& p)
{
  std::vector<std::uint64_t> around;
  cells.for_each_cell_around(p, [&](std::uint64_t hash) { around.push_back(hash); });
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

// Some offsets are far out, where cells are larger than their side.
template <int Dimension>
void check_law()
{
  Random random(1);
  for(const double offset : {0., 1., -1., 1e6, -1e15, 1e19, 1e300})
    for(const double width : {0.5, 0.1, 1e-9, 1e-290, 1e-322, 1e200, 1e306, 1e308})
      for(const double factor : {1., 2., 16.}) {
        const internal::Hashed_cells<Dimension> cells(width, factor * width, 3);
        const internal::Hashed_cells<Dimension> home(0, factor * width, 3);
        for(int i = 0; i < 50; ++i) {
          Point p;
          for(int axis = 0; axis < Dimension; ++axis)
            p.coordinates.push_back(offset + 10 * width * (random.uniform() - 0.5));
          const std::vector<std::uint64_t> around = cells_around(cells, p);
          const std::uint64_t cell = home.first_cell_around(point_within(p, width, random)).first;
          BOOST_CHECK(std::find(around.begin(), around.end(), cell) != around.end());
        }
      }
}

BOOST_AUTO_TEST_CASE(near_points_are_in_the_cells_around)
{
  check_law<1>();
  check_law<2>();
  check_law<3>();
  check_law<4>();
}

BOOST_AUTO_TEST_CASE(the_first_cell_around_is_told_with_whether_there_are_others)
{
  const internal::Hashed_cells<3> cells(0.1, 0.7, 5);
  std::size_t alone = 0;
  for(const Point& p : plain_points(uniform_points(3, 500, -2, 4, 3))) {
    const std::vector<std::uint64_t> around = cells_around(cells, p);
    const auto [first, has_others] = cells.first_cell_around(p);
    BOOST_CHECK_EQUAL(first, around.front());
    BOOST_CHECK_EQUAL(has_others, around.size() > 1);
    alone += !has_others;
  }
  BOOST_CHECK_GT(alone, 100u);
  BOOST_CHECK_LT(alone, 400u);
}

BOOST_AUTO_TEST_CASE(cells_fit_all_distances_beyond_the_errors)
{
  const auto fits = [](double reach, double error) {
    return internal::Hashed_cells<2>::fits(reach, error);
  };
  BOOST_CHECK(fits(1, 0) && fits(1, 0.5) && fits(0x1p-1074, 0) && fits(0x1p1023, 0));
  BOOST_CHECK(fits(std::numeric_limits<double>::infinity(), 0));
  BOOST_CHECK(!fits(1, 0.6) && !fits(0, 0));
}

BOOST_AUTO_TEST_SUITE_END()
