// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The join against brute force: it visits all pairs within the distance.

#include "support/check_closest_pair.h"
#include "support/plain_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <set>

BOOST_AUTO_TEST_SUITE(Cell_join)

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Maker = Cartesian_points<Epick, Dimension>;
using Point = Epick::Point_2;

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

// What a join promises: all close pairs are visited, in the order of the input or not.
BOOST_AUTO_TEST_CASE(joins_visit_all_close_pairs)
{
  struct Visitor
  {
    Pairs& visited;
    bool operator()(std::size_t i, std::size_t j)
    {
      visited.push_back(std::minmax(i, j));
      return true;
    }
  };
  using Elements = Elements_of<Point>;
  std::size_t joined = 0;
  for(const Point_scene& scene : closest_pair_scenes(2)) {
    const double reach = upper_bound(scene.radius);
    if(!internal::Hashed_cells<2>::fits(reach, 0))
      continue;
    ++joined;
    const auto points = make_points<Maker<2>>(scene.points);
    const Elements elements(points);
    for(const double factor : {2., 16.}) {
      Pairs visited;
      const internal::Cell_join<CGAL::Sequential_tag, 2, Elements> join(elements, reach,
                                                                        factor * reach, 1);
      internal::Unwatched_progress progress;
      join(internal::Some_positions(points.size()), no_limit, [&] { return Visitor{visited}; },
           progress);
      std::sort(visited.begin(), visited.end());
      const Pairs& pairs = truth_of(scene).pairs;
      BOOST_CHECK_MESSAGE(std::includes(visited.begin(), visited.end(), pairs.begin(),
                                        pairs.end()), scene << ", factor " << factor);
    }
  }
  BOOST_CHECK_GT(joined, 30u);
}

// Writes down the visited pairs.
struct Set_visitor
{
  std::set<Pair>& visited;
  bool operator()(std::size_t i, std::size_t j)
  {
    visited.insert(std::minmax(i, j));
    return true;
  }
};

// In space, with entries in several lists; distances of small integers are exact.
template <class ConcurrencyTag>
void check_join_of_many_lists()
{
  Points points = uniform_points(3, 6000, -40, 80, 1);
  for(Coordinates& c : points)
    for(double& x : c)
      x = std::floor(x);
  const Plain_points<double> elements = plain_points(points);
  std::set<Pair> visited;
  std::mutex mutex;
  const auto visit = [&](std::size_t i, std::size_t j) {
    const std::lock_guard<std::mutex> lock(mutex);
    return Set_visitor{visited}(i, j);
  };
  const internal::Cell_join<ConcurrencyTag, 3, Plain_points<double>> join(elements, 3, 10, 1);
  internal::Unwatched_progress progress;
  join(internal::Some_positions(points.size()), no_limit, [&] { return visit; }, progress);
  std::size_t close = 0, missing = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = i + 1; j < points.size(); ++j) {
      double square = 0;
      for(std::size_t axis = 0; axis < 3; ++axis)
        square += (points[i][axis] - points[j][axis]) * (points[i][axis] - points[j][axis]);
      if(square <= 9) {
        ++close;
        missing += visited.count({i, j}) == 0;
      }
    }
  BOOST_CHECK_EQUAL(missing, 0u);
  BOOST_CHECK_GT(close, 1000u);
}

BOOST_AUTO_TEST_CASE(joins_of_many_lists_visit_all_close_pairs)
{
  check_join_of_many_lists<CGAL::Sequential_tag>();
}
BOOST_AUTO_TEST_CASE(parallel_joins_of_many_lists_visit_all_close_pairs)
{
  check_join_of_many_lists<CGAL::Parallel_tag>();
}

// The border of two cells is in the middle of each pair.
BOOST_AUTO_TEST_CASE(joins_visit_pairs_at_the_distance_across_borders_of_cells)
{
  Points points;
  for(const double border : {16., 32., 48.})
    for(const int axis : {0, 1})
      for(const double side : {-1., 1.}) {
        points.push_back({4, 4});
        points.back()[static_cast<std::size_t>(axis)] = border + side;
      }
  const Plain_points<double> elements = plain_points(points);
  const internal::Cell_join<CGAL::Sequential_tag, 2, Plain_points<double>> join(elements, 2, 16,
                                                                                    1);
  internal::Unwatched_progress progress;
  std::set<Pair> visited;
  join(internal::Some_positions(points.size()), no_limit, [&] { return Set_visitor{visited}; },
       progress);
  for(std::size_t i = 0; i < points.size(); i += 2)
    BOOST_CHECK_EQUAL(visited.count({i, i + 1}), 1u);
}

// Each list has pairs of twins.
BOOST_AUTO_TEST_CASE(joins_end_when_the_visitor_says_so)
{
  struct Visitor
  {
    int& calls;
    bool operator()(std::size_t, std::size_t) { return ++calls < 5; }
  };
  const auto elements = plain_points(repeated(axis_points(2, 5000, 0, 0, 10), 2));
  const internal::Cell_join<CGAL::Sequential_tag, 2, Plain_points<double>> join(elements, 1, 2, 1);
  internal::Unwatched_progress progress;
  int calls = 0;
  join(internal::Some_positions(elements.size()), no_limit, [&] { return Visitor{calls}; },
       progress);
  BOOST_CHECK_EQUAL(calls, 5);
}

BOOST_AUTO_TEST_SUITE_END()
