// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the searches for the closest pair and for a close pair, to the end and cancelled.

#include "support/check_closest_pair.h"
#include "support/counted_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

BOOST_AUTO_TEST_SUITE(Closest_pair_search)

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Maker = Cartesian_points<Epick, Dimension>;
using Point = Epick::Point_2;

// Squared distances overflow for the first pair only.
BOOST_AUTO_TEST_CASE(first_point_may_be_far_out)
{
  auto points = make_points<Maker<2>>(uniform_points(2, 20000, 0, 1, 26));
  points[0] = Point(1e200, 0);
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Scene scene = scene_of(counted);
  internal::Unwatched_progress progress;
  const Pair pair = internal::Closest_pair_search<CGAL::Sequential_tag, Counted_points<Point>,
                                                  internal::Unwatched_progress>(counted, scene, 1,
                                                                         progress).find();
  BOOST_CHECK(pair == closest_by_division(points));
  BOOST_CHECK_LE(looks, 20 * points.size());
}

// Once it is cancelled, a search ends with the block of points that it is in.
BOOST_AUTO_TEST_CASE(cancelled_search_looks_at_few_points_more)
{
  const auto points = make_points<Maker<2>>(uniform_points(2, 20000, 0, 1, 25));
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Squared_bound<Exact_of<Point>> zero(CGAL::within_distance(0));
  const internal::Scene scene = scene_of(counted);
  for(const double share : {0., 0.1, 0.3, 0.6, 0.9}) {
    std::size_t before = 0;
    const auto cancel = [&](double done) {
      before = looks;
      return done < share;
    };
    using Progress = internal::Watched_progress<decltype(cancel)>;
    using Counted = Counted_points<Point>;
    Progress progress(cancel, points.size());
    internal::Closest_pair_search<CGAL::Sequential_tag, Counted, Progress>(counted, scene, 1,
                                                                           progress).find();
    BOOST_CHECK_LE(looks - before, 4000u);
    Progress other(cancel, points.size());
    internal::Close_pair_search<CGAL::Sequential_tag, Counted, Progress>(counted, zero, scene,
                                                                         other).find();
    BOOST_CHECK_LE(looks - before, 4000u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
