// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Strips have all points of a slab, follow each other along axis 1, and are sorted along axis 0.

#include "support/point_source.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Strips_maker.h>

BOOST_AUTO_TEST_SUITE(Strips_maker)

using namespace test_support;

template <int Dimension>
void check_strips(const internal::Strips<internal::Slab_point<Dimension, double>>& strips,
                  const Points& points)
{
  std::vector<int> times(points.size(), 0);
  double below = -std::numeric_limits<double>::infinity();
  for(const auto& strip : strips.strips()) {
    const internal::Run<Dimension, double> run = strips.run(strip);
    BOOST_CHECK(std::is_sorted(run.x[0], run.x[0] + run.size));
    if(Dimension == 3) {
      BOOST_CHECK_GE(strip.box[1].low, below);
      below = strip.box[1].high;
    }
    for(internal::Place i = 0; i < run.size; ++i) {
      ++times[run.positions[i]];
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        BOOST_CHECK_EQUAL(run.x[axis][i], points[run.positions[i]][axis]);
    }
  }
  BOOST_CHECK(Dimension == 3 || strips.strips().size() == 1);
  BOOST_CHECK_EQUAL(strips.size(), points.size());
  BOOST_CHECK(times == std::vector<int>(points.size(), 1));
}

// Returns how many scenes were crowded.
template <int Dimension>
int check_scenes(std::size_t n)
{
  using Point = internal::Slab_point<Dimension, double>;
  int crowded = 0;
  for(const double reach : {1e-9, 1e-3, 0.1, 10.}) {
    internal::Strips_maker<Point> maker(reach, internal::Point_sets(), tuning_for_few_points());
    internal::Strips<Point> strips; // both are used again
    for(const auto& [name, points] : scenes_to_cut(Dimension, n)) {
      BOOST_TEST_CONTEXT(name << ", reach " << reach)
      {
        const std::vector<Point> slab = slab_points<Dimension>(points);
        maker.count(slab.data(), slab.data() + slab.size());
        crowded += maker.is_crowded();
        maker.make(strips);
        check_strips<Dimension>(strips, points);
        for(int axis = 0; axis < Dimension; ++axis)
          BOOST_CHECK_EQUAL(maker.interval(axis).length(), strips.interval(axis).length());
        BOOST_CHECK_LE(strips.candidates(), static_cast<double>(points.size())
                                              * static_cast<double>(points.size()));
      }
    }
  }
  return crowded;
}

BOOST_AUTO_TEST_CASE(strips_are_complete_and_sorted_2)
{
  check_scenes<2>(1);
  check_scenes<2>(17);
  BOOST_CHECK_GT(check_scenes<2>(1500), 5);
}

// Many scenes are crowded, so strips are cut where the points are.
BOOST_AUTO_TEST_CASE(strips_are_complete_and_sorted_3)
{
  check_scenes<3>(1);
  check_scenes<3>(17);
  BOOST_CHECK_GT(check_scenes<3>(1500), 5);
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
