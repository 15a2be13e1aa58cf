// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Strips follow each other along axis 1, however crowded a slab is. That they have all points,
// sorted along axis 0, is left to test_Slab_route.cpp.

#include "support/point_source.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Strips_maker.h>

BOOST_AUTO_TEST_SUITE(Strips_maker)

using namespace test_support;

using Point = internal::Slab_point<3, double>;

void check_strips(const std::vector<Point>& slab, internal::Strips_maker<Point>& maker,
                  internal::Strips<Point>& strips)
{
  maker.make(strips);
  double below = -infinity;
  for(const auto& strip : strips.strips()) {
    BOOST_CHECK_GE(strip.box[1].low, below);
    below = strip.box[1].high;
  }
  const double size = static_cast<double>(slab.size());
  BOOST_CHECK_EQUAL(static_cast<double>(strips.size()), size);
  BOOST_CHECK_LE(strips.candidates(), size * size);
  for(int axis = 0; axis < 3; ++axis)
    BOOST_CHECK_EQUAL(maker.interval(axis).length(), strips.interval(axis).length());
}

BOOST_AUTO_TEST_CASE(each_strip_is_above_the_one_before_it)
{
  int crowded = 0;
  for(const std::size_t n : {1, 17, 1500})
    for(const double reach : {1e-9, 1e-3, 0.1, 10.}) {
      internal::Strips_maker<Point> maker(reach, internal::Point_sets(), tuning_for_few_points());
      internal::Strips<Point> strips; // both are used again
      for(const auto& [name, points] : scenes_to_cut(3, n))
        BOOST_TEST_CONTEXT(name << ", " << n << " points, reach " << reach)
        {
          const std::vector<Point> slab = slab_points<3>(points);
          maker.count(slab.data(), slab.data() + slab.size());
          crowded += maker.is_crowded();
          check_strips(slab, maker, strips);
        }
    }
  BOOST_CHECK_GT(crowded, 5);
}

BOOST_AUTO_TEST_CASE(sorted_pieces_are_short_or_few)
{
  using Point = internal::Slab_point<2, double>;
  Random random(1);
  std::vector<Point> points;
  for(internal::Place i = 0; i < 500; ++i)
    points.push_back({{std::floor(100 * random.uniform()), 0}, i});
  std::sort(points.begin(), points.end(),
            [](const Point& p, const Point& q) { return p.x[0] < q.x[0]; });
  for(const double length : {0., 1., 7.5, 1000.})
    for(const internal::Place few : {1u, 3u, 40u, 1000u}) {
      const Point* end = points.data();
      internal::for_each_sorted_piece(
        points.data(), points.data() + points.size(), 0, length, few,
        [&](const Point* first, const Point* last) {
          BOOST_CHECK(first == end && first < last);
          BOOST_CHECK(last[-1].x[0] - first->x[0] <= length || last - first <= few);
          end = last;
        });
      BOOST_CHECK(end == points.data() + points.size());
    }
}

BOOST_AUTO_TEST_SUITE_END()
