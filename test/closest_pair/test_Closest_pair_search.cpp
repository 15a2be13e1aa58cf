// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the searches for the closest pair and for a close pair, to the end and cancelled.

#include "support/check_closest_pair.h"
#include "support/counted_points.h"

BOOST_AUTO_TEST_SUITE(Closest_pair_search)

using namespace test_support;

using Point = Epick::Point_2;

// Squared distances overflow for the first pair only.
BOOST_AUTO_TEST_CASE(first_point_may_be_far_out)
{
  auto points = make_points<Epick_points<2>>(uniform_points(2, 20000, 0, 1, 26));
  points[0] = Point(1e200, 0);
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Scene scene = scene_of(counted);
  internal::Unwatched_progress progress;
  const Pair pair = closest_of_many(counted, scene, progress);
  BOOST_CHECK(pair == closest_by_division(points));
  BOOST_CHECK_LE(looks, 20 * points.size());
}

// Once it is cancelled, a search ends with the block of points that it is in.
BOOST_AUTO_TEST_CASE(cancelled_search_looks_at_few_points_more)
{
  const auto points = make_points<Epick_points<2>>(uniform_points(2, 20000, 0, 1, 25));
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Squared_bound<Exact_of<Point>> zero(CGAL::within_distance(0));
  const internal::Squared_bound<Exact_of<Point>> tiny(CGAL::within_distance(1e-9));
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
    closest_of_many(counted, scene, progress);
    BOOST_CHECK_LE(looks - before, 4000u);
    for(const auto& bound : {zero, tiny}) {
      Progress other(cancel, points.size());
      internal::Close_pair_search<Counted, Progress>(counted, bound, scene, other,
                                                     internal::Threads()).find();
      BOOST_CHECK_LE(looks - before, 4000u);
    }
  }
}

// Returns how many searches for near pairs the search for the closest pair needs.
template <int Dimension>
std::size_t near_searches_of_closest_pair(const Points& scene)
{
  const auto points = make_points<Epick_points<Dimension>>(scene);
  const Elements_of<typename Epick_points<Dimension>::Point> elements(points);
  Counting_progress progress(points.size());
  check_pair("search", closest_by_division(points),
             closest_of_many(elements, scene_of(elements), progress));
  return progress.near_searches();
}

std::size_t near_searches_of_closest_pair(const Points& scene)
{
  return scene.front().size() == 2 ? near_searches_of_closest_pair<2>(scene)
                                   : near_searches_of_closest_pair<3>(scene);
}

// A lattice whose points have moved by up to a share of its step.
Points moved_lattice(int dimension, double share)
{
  Points points = shuffled(lattice_points(dimension, dimension == 2 ? 60 : 15, 1), 3);
  Random random(4);
  for(Coordinates& c : points)
    for(double& x : c)
      x += share * random.uniform();
  return points;
}

BOOST_AUTO_TEST_CASE(near_pairs_of_crowded_points_are_reported)
{
  for(const int dimension : {2, 3}) {
    for(const double share : {1e-300, 1e-15, 1e-3, 0.1})
      BOOST_CHECK_GT(near_searches_of_closest_pair(moved_lattice(dimension, share)), 0u);
    const Points lattice = moved_lattice(dimension, 0);
    for(const double scale : {0.1, 1e-318, 1e-165, 1e170, 1e300})
      BOOST_CHECK_GT(near_searches_of_closest_pair(moved(lattice, scale, 0)), 0u);
  }
}

// Among pairs at the same distance the first one is the closest, unless there is a closer one.
BOOST_AUTO_TEST_CASE(wide_scenes_of_ties_are_searched_once)
{
  for(const double shift : {0., 0.5}) {
    Points points = shuffled(lattice_points(2, 60, 1), 3);
    points[1000][0] += shift;
    const std::size_t searches = near_searches_of_closest_pair(points);
    points.push_back({0x1p40, 0});
    BOOST_CHECK_EQUAL(near_searches_of_closest_pair(points), 1u);
    BOOST_CHECK_EQUAL(searches, shift == 0 ? 2u : 1u);
  }
}

// The points that a search with a seed looks at first are far apart, and the others are not.
Points made_for_a_seed(int dimension, std::size_t size, std::uint64_t seed, double scale)
{
  const internal::Some_positions drawn(internal::Threads(), internal::Some_positions(size), seed);
  Points points = moved(uniform_points(dimension, size, 0, 1, 8), scale, 0);
  for(std::size_t i = 0; i < drawn.size(); ++i)
    points[drawn[i]] = Coordinates(static_cast<std::size_t>(dimension),
                                   1 + static_cast<double>(i) / 100);
  return points;
}

// Too many pairs are within the distance of the first sample.
BOOST_AUTO_TEST_CASE(points_that_are_made_for_a_seed_take_a_few_searches)
{
  for(const double scale : {1e-3, 1e-20, 1e-200, 1e-310}) {
    const std::size_t searches = near_searches_of_closest_pair(made_for_a_seed(2, 4000, 1, scale));
    BOOST_CHECK_GT(searches, 0u);
    BOOST_CHECK_LE(searches, 13u);
    BOOST_CHECK_GT(near_searches_of_closest_pair(made_for_a_seed(3, 4000, 1, scale)), 0u);
  }
}

// The eighth of an eighth that the search draws is far apart; another one is not. The distance of
// the former would have nearly all pairs reported.
BOOST_AUTO_TEST_CASE(crowded_sample_is_drawn_from_again)
{
  for(const std::size_t dimension : {2, 3}) {
    std::uint64_t seed = 1;
    const internal::Some_positions all(32000);
    const internal::Some_positions eighth(internal::Threads(), all, seed);
    const internal::Some_positions drawn(internal::Threads(), eighth, seed);
    Points points = moved(uniform_points(static_cast<int>(dimension), 32000, 0, 1, 8), 1e-3, 0);
    for(std::size_t i = 0; i < drawn.size(); ++i)
      points[drawn[i]] = Coordinates(dimension, 1 + static_cast<double>(i) / 100);
    BOOST_CHECK_EQUAL(near_searches_of_closest_pair(points), 0u);
  }
}

// The points that the search does not look at first are in two crowds. The join gives up in the
// wide one, so too many pairs of the narrow one are nearer than all that it has seen.
Points two_crowds()
{
  Points points = made_for_a_seed(2, 4000, 1, 1e-3);
  for(std::size_t i = points.size() / 2; i < points.size(); ++i)
    if(points[i][0] < 1)
      points[i] = {1e-7 * points[i][0] - 1, 1e-7 * points[i][1]};
  return points;
}

// Bisection finds a distance that some pairs are within, at either end of the doubles.
BOOST_AUTO_TEST_CASE(closest_pairs_of_crowds_are_found_at_all_scales)
{
  for(const double scale : {1., 1e-298, 1e-18, 1e300}) {
    const std::size_t searches = near_searches_of_closest_pair(moved(two_crowds(), scale, 0));
    BOOST_CHECK_GT(searches, 2u);
    BOOST_CHECK_LE(searches, 13u);
  }
}

// They are more than 2^1023 apart: every other point of a lattice.
BOOST_AUTO_TEST_CASE(points_that_are_as_far_apart_as_doubles_are_compared)
{
  Points points;
  for(const Coordinates& c : shuffled(lattice_points(3, 6, 1), 9))
    if(std::fmod(c[0] + c[1] + c[2], 2) == 0)
      points.push_back(c);
  points = moved(moved(points, 0.4, -1), (std::numeric_limits<double>::max)(), 0);
  BOOST_CHECK_GT(near_searches_of_closest_pair(points), 1u);
  points.back() = points.front();
  points.back()[0] /= 2;
  near_searches_of_closest_pair(points);
}

// Neither are their samples crowded, nor samples of these.
BOOST_AUTO_TEST_CASE(uniform_points_are_not_crowded)
{
  for(const std::size_t size : {4000, 20000, 100000})
    for(const int dimension : {2, 3})
      BOOST_CHECK_EQUAL(near_searches_of_closest_pair(uniform_points(dimension, size, 0, 1, 5)),
                        0u);
}

// Once for each coordinate, and for few others in the same place of the hash table.
BOOST_AUTO_TEST_CASE(equal_points_are_found_by_few_looks)
{
  const auto points = make_points<Epick_points<2>>(uniform_points(2, 20000, 0, 1, 7));
  std::size_t looks = 0;
  const Counted_points<Point> counted = {points, looks};
  const internal::Scene scene = scene_of(Elements_of<Point>(points));
  const internal::Squared_bound<Exact_of<Point>> zero(CGAL::within_distance(0));
  internal::Unwatched_progress progress;
  BOOST_CHECK(!(internal::Close_pair_search<Counted_points<Point>, internal::Unwatched_progress>(
                  counted, zero, scene, progress, internal::Threads()).find()));
  BOOST_CHECK_LE(looks, 3 * points.size());
}

// The distance of the lattice is decided exactly.
BOOST_AUTO_TEST_CASE(close_pairs_of_crowded_points_are_found)
{
  for(const double step : {1., 0.1, 1e-318, 1e200}) {
    const auto points = make_points<Epick_points<2>>(shuffled(lattice_points(2, 60, step), 6));
    const Pair closest = closest_by_division(points);
    const auto bound = CGAL::within_squared_distance(
      internal::exact_squared_distance(points[closest.first], points[closest.second], 2));
    BOOST_CHECK(CGAL::has_close_pair(points, bound));
    BOOST_CHECK(!CGAL::has_close_pair(points, bound.open()));
  }
}

BOOST_AUTO_TEST_SUITE_END()
