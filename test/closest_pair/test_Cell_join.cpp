// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The join against brute force: it visits all pairs within the distance.

#include "support/check_closest_pair.h"
#include "support/plain_points.h"
#include "support/squared_distance.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_join.h>

BOOST_AUTO_TEST_SUITE(Cell_join)

using namespace test_support;

using Point = Epick::Point_2;

constexpr std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();

// Writes down the pairs that are given, up to a number of pairs.
class Set_taker final : public internal::Pair_taker
{
public:
  explicit Set_taker(std::size_t max_count = no_limit) : max_count_(max_count) {}

  bool take(const internal::Found_pair* pairs, std::size_t count) override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for(; count > 0 && taken_ < max_count_; --count, ++pairs, ++taken_)
      this->pairs.insert(std::minmax(std::size_t(pairs->i), std::size_t(pairs->j)));
    return taken_ < max_count_;
  }

  std::size_t taken() const { return taken_; }

  std::set<Pair> pairs;

private:
  std::mutex mutex_;
  std::size_t max_count_;
  std::size_t taken_ = 0;
};

// Joins all points within a distance.
template <int Dimension, class ConcurrencyTag = CGAL::Sequential_tag, class Elements>
internal::Joined join_all(const Elements& elements, double distance, double cell_side,
                          Set_taker& taker, std::size_t max_steps = no_limit,
                          std::uint64_t seed = 1)
{
  internal::Join_task<Dimension> task;
  const internal::Scene scene = scene_of(elements);
  std::copy_n(scene.box.begin(), Dimension, task.box.begin());
  task.error = scene.error;
  task.threads = internal::Threads(ConcurrencyTag());
  internal::Unwatched_progress progress;
  internal::Element_points<Dimension, Elements, internal::Unwatched_progress> points(elements,
                                                                                     progress);
  internal::Cell_join<Dimension> join(points, task, distance, cell_side, seed);
  return join(internal::Some_positions(elements.size()), max_steps, taker);
}

// What a join promises: all close pairs are visited, in the order of the input or not.
BOOST_AUTO_TEST_CASE(joins_visit_all_close_pairs)
{
  std::size_t joined = 0;
  for(const Point_scene& scene : all_scenes(2)) {
    const double reach = upper_bound(scene.radius);
    if(scene.points.empty() || !internal::do_cells_fit(reach, 0))
      continue;
    ++joined;
    const auto points = make_points<Epick_points<2>>(scene.points);
    const Elements_of<Point> elements(points);
    for(const double factor : {2., 16.}) {
      Set_taker taker;
      BOOST_CHECK(join_all<2>(elements, reach, factor * reach, taker) == internal::Joined::ALL);
      const Pairs& pairs = truth_of(scene).pairs;
      BOOST_CHECK_MESSAGE(std::includes(taker.pairs.begin(), taker.pairs.end(), pairs.begin(),
                                        pairs.end()), scene << ", factor " << factor);
    }
  }
  BOOST_CHECK_GT(joined, 30u);
}

// In space, with entries in several lists; distances of small integers are exact.
template <class ConcurrencyTag>
void check_join_of_many_lists()
{
  Points points = uniform_points(3, 6000, -40, 80, 1);
  for(Coordinates& c : points)
    for(double& x : c)
      x = std::floor(x);
  const Plain_points<double> elements = plain_points(points);
  Set_taker taker;
  join_all<3, ConcurrencyTag>(elements, 3, 10, taker);
  std::size_t close = 0, missing = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = i + 1; j < points.size(); ++j)
      if(squared_distance<double>(points[i], points[j]) <= 9) {
        ++close;
        missing += taker.pairs.count({i, j}) == 0;
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
  Set_taker taker;
  join_all<2>(plain_points(points), 2, 16, taker);
  for(std::size_t i = 0; i < points.size(); i += 2)
    BOOST_CHECK_EQUAL(taker.pairs.count({i, i + 1}), 1u);
}

// Each point is in four cells, three times as many as are expected of points anywhere.
BOOST_AUTO_TEST_CASE(parallel_joins_have_room_for_points_at_corners_of_cells)
{
  Points points;
  for(int i = 0; i < 50; ++i)
    for(int j = 0; j < 50; ++j)
      for(const double side : {-.5, .5})
        points.push_back({16. * (i + 1) + side, 16. * (j + 1)});
  Set_taker taker;
  join_all<2, CGAL::Parallel_tag>(plain_points(points), 2, 16, taker);
  std::size_t missing = 0;
  for(std::size_t i = 0; i < points.size(); i += 2)
    missing += taker.pairs.count({i, i + 1}) == 0;
  BOOST_CHECK_EQUAL(missing, 0u);
}

// With this seed, the two cells on both sides of the border have one hash.
BOOST_AUTO_TEST_CASE(no_point_is_paired_with_itself)
{
  Set_taker taker;
  join_all<2>(plain_points({{16. * 1004921425, 16. * 704540135.5}}), 2, 16, taker, no_limit,
              0xd9741991032d64b3);
  BOOST_CHECK_EQUAL(taker.taken(), 0u);
}

// Each list has pairs of twins.
BOOST_AUTO_TEST_CASE(joins_end_when_the_taker_says_so)
{
  const auto elements = plain_points(repeated(axis_points(2, 5000, 0, 0, 10), 2));
  Set_taker taker(5);
  BOOST_CHECK(join_all<2>(elements, 1, 2, taker) == internal::Joined::STOPPED);
  BOOST_CHECK_EQUAL(taker.taken(), 5u);
}

// All points are in one cell.
BOOST_AUTO_TEST_CASE(joins_are_given_up_after_their_steps)
{
  const auto elements = plain_points(repeated({{1, 1}}, 1000));
  Set_taker taker;
  BOOST_CHECK(join_all<2>(elements, 1, 2, taker, 5000) == internal::Joined::GIVEN_UP);
  BOOST_CHECK_LE(taker.taken(), 7000u);
}

BOOST_AUTO_TEST_SUITE_END()
