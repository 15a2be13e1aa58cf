// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The lanes against all pairs, and the lanes of all processors against each other. Coordinates are
// small integers, so that distances are exact and many pairs lie exactly at the reach.

#include "support/pairs.h"
#include "support/point_generators.h"
#include "support/run_of_points.h"

#include <CGAL/Thick_intersection_d/internal/slabs/lanes/near_points.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>

BOOST_AUTO_TEST_SUITE(near_points)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

Points integer_points(int dimension, std::size_t size, std::size_t side, Random& random)
{
  Points points(size, Coordinates(static_cast<std::size_t>(dimension)));
  for(Coordinates& c : points)
    for(double& x : c)
      x = static_cast<double>(random.below(side));
  return points;
}

// The filter decides all but the pairs at distance r.
internal::Near_question question(double r)
{
  internal::Distance_filter filter;
  filter.inside = r * r - 0.5;
  filter.outside = r * r;
  return {r, filter};
}

double squared_distance(const Coordinates& p, const Coordinates& q)
{
  double sum = 0;
  for(std::size_t axis = 0; axis < p.size(); ++axis)
    sum += (p[axis] - q[axis]) * (p[axis] - q[axis]);
  return sum;
}

// What lanes collect: the places of candidates in order, and whether one of them is undecided.
struct Collected
{
  Pairs pairs;
  bool is_any_undecided = false;

  bool operator==(const Collected& other) const
  {
    return pairs == other.pairs && is_any_undecided == other.is_any_undecided;
  }
};

// Calls collect(candidates, flush), and empties the candidates whenever there are many.
template <class Collect>
Collected collected(const Collect& collect)
{
  Collected all;
  internal::Found_pairs candidates;
  const auto flush = [&] {
    for(internal::Place c = 0; c < candidates.count; ++c)
      all.pairs.emplace_back(candidates.pairs[c].i, candidates.pairs[c].j);
    all.is_any_undecided = all.is_any_undecided || candidates.is_any_undecided;
    candidates.count = 0;
    candidates.is_any_undecided = false;
    return true;
  };
  collect(candidates, flush);
  flush();
  return all;
}

template <class Lanes, int Dimension>
Collected within(const Run_of_points<Dimension>& a, double r)
{
  return collected([&](internal::Found_pairs& candidates, const auto& flush) {
    Lanes::collect_within(a.run(), question(r), candidates, flush);
  });
}

template <class Lanes, int Dimension>
Collected between(const Run_of_points<Dimension>& a, const Run_of_points<Dimension>& b, double r)
{
  return collected([&](internal::Found_pairs& candidates, const auto& flush) {
    Lanes::collect_between(a.run(), b.run(), question(r), candidates, flush);
  });
}

// All pairs of a place of `a` and a place of `b` behind it, at most r apart.
Collected by_brute_force(const Points& a, const Points& b, double r, bool is_one_set)
{
  Collected near;
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t j = is_one_set ? i + 1 : 0; j < b.size(); ++j)
      if(const double square = squared_distance(a[i], b[j]); square <= r * r) {
        near.pairs.emplace_back(i, j);
        near.is_any_undecided = near.is_any_undecided || square == r * r;
      }
  return near;
}

void check_collected(const Collected& expected, const Collected& found)
{
  const Pairs_difference difference = compare(expected.pairs, found.pairs);
  BOOST_CHECK_MESSAGE(difference.empty(), difference);
  BOOST_CHECK_EQUAL(expected.is_any_undecided, found.is_any_undecided);
}

template <class Lanes, int Dimension>
void check_lanes(std::size_t size, std::size_t other_size, double r, std::size_t side)
{
  Random random(size);
  const Run_of_points<Dimension> a(integer_points(Dimension, size, side, random));
  const Run_of_points<Dimension> b(integer_points(Dimension, other_size, side, random));
  BOOST_TEST_CONTEXT(size << " and " << other_size << " points, r = " << r)
  {
    const Collected of_a = within<Lanes>(a, r), of_both = between<Lanes>(a, b, r);
    check_collected(by_brute_force(a.points(), a.points(), r, true), of_a);
    check_collected(by_brute_force(a.points(), b.points(), r, false), of_both);
    BOOST_CHECK(of_a == within<internal::Near_points_plain>(a, r)); // in the same order
    BOOST_CHECK(of_both == between<internal::Near_points_plain>(a, b, r));
  }
}

// Runs of no, one and several rows of lanes; and long ones, whose candidates are flushed.
template <class Lanes>
void check_all_lanes()
{
  if(!Lanes::is_supported())
    return;
  for(std::size_t size = 0; size <= 40; ++size)
    for(const double r : {0., 1., 5., 100.}) {
      check_lanes<Lanes, 2>(size, (7 * size) % 41, r, 12);
      check_lanes<Lanes, 3>(size, (7 * size) % 41, r, 12);
      check_lanes<Lanes, 2>(size, 3, r, 100);
    }
  check_lanes<Lanes, 2>(300, 500, 5, 30);
  check_lanes<Lanes, 3>(300, 500, 5, 12);
}

BOOST_AUTO_TEST_CASE(plain_lanes_collect_the_near_pairs)
{
  check_all_lanes<internal::Near_points_plain>();
}

BOOST_AUTO_TEST_CASE(avx512_lanes_collect_the_near_pairs_in_the_same_order)
{
  check_all_lanes<internal::Near_points_avx512>();
}

// Lanes that write down who was called.
template <int number, bool supported>
struct Noted_lanes
{
  static bool is_supported() { return supported; }
  static void collect_within(int& called) { called = number; }
  static void collect_between(int& called) { called = -number; }
};

// The last ones are taken without a question: plain loops run everywhere.
BOOST_AUTO_TEST_CASE(first_lanes_that_are_supported_are_chosen)
{
  using Second = internal::First_supported<Noted_lanes<1, false>, Noted_lanes<2, true>,
                                           Noted_lanes<3, true>>;
  using Last = internal::First_supported<Noted_lanes<1, false>, Noted_lanes<2, false>>;
  int called = 0;
  Second::collect_within(called);
  BOOST_CHECK_EQUAL(called, 2);
  Second::collect_between(called);
  BOOST_CHECK_EQUAL(called, -2);
  Last::collect_within(called);
  BOOST_CHECK_EQUAL(called, 2);
}

BOOST_AUTO_TEST_CASE(chosen_lanes_collect_the_pairs_of_plain_lanes)
{
  check_all_lanes<internal::Near_points_plain>();
  Random random(1);
  const Run_of_points<2> a(integer_points(2, 40, 12, random));
  BOOST_CHECK(within<internal::Near_points_lanes>(a, 5)
              == within<internal::Near_points_plain>(a, 5));
  BOOST_CHECK((between<internal::Near_points_lanes>(a, a, 5)
               == between<internal::Near_points_plain>(a, a, 5)));
}

// Without the filter, the pairs within reach along axis 0 are left, or more of them.
template <class Lanes>
void check_undecided()
{
  if(!Lanes::is_supported())
    return;
  Random random(2);
  const Run_of_points<2> a(integer_points(2, 40, 30, random));
  const Collected found = collected([&](internal::Found_pairs& candidates, const auto& flush) {
    Lanes::collect_within(a.run(), {3, internal::Distance_filter()}, candidates, flush);
  });
  const Pairs pairs = sorted(found.pairs);
  std::size_t missing = 0;
  for(std::size_t i = 0; i < 40; ++i)
    for(std::size_t j = i + 1; j < 40; ++j)
      if(a.points()[j][0] - a.points()[i][0] <= 3)
        missing += !std::binary_search(pairs.begin(), pairs.end(), Pair(i, j));
  BOOST_CHECK_EQUAL(missing, 0u);
  BOOST_CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
  BOOST_CHECK(found.is_any_undecided);
}

BOOST_AUTO_TEST_CASE(what_the_filter_does_not_decide_is_left_once)
{
  check_undecided<internal::Near_points_plain>();
  check_undecided<internal::Near_points_avx512>();
}

// With a filter that decides everything, ties are not decided again.
template <class Lanes>
void check_tie()
{
  if(!Lanes::is_supported())
    return;
  const Run_of_points<2> a(Points{{0, 0}, {3, 4}});
  const internal::Near_question tie = {5, {25, 25}};
  const auto flush = [] { return true; };
  internal::Found_pairs of_one, of_two;
  Lanes::collect_within(a.run(), tie, of_one, flush);
  Lanes::collect_between(a.run(), a.run(), tie, of_two, flush);
  BOOST_CHECK_EQUAL(of_one.count, 1u);
  BOOST_CHECK_EQUAL(of_two.count, 4u);
  BOOST_CHECK(!of_one.is_any_undecided && !of_two.is_any_undecided);
}

BOOST_AUTO_TEST_CASE(ties_are_decided_if_the_filter_decides_them)
{
  check_tie<internal::Near_points_plain>();
  check_tie<internal::Near_points_avx512>();
}

template <class Lanes>
void check_stop()
{
  if(!Lanes::is_supported())
    return;
  const Run_of_points<2> a(identical_points(2, 200, 1)); // 19900 pairs
  internal::Found_pairs candidates;
  int calls = 0;
  const auto stop = [&] {
    ++calls;
    BOOST_CHECK_GE(candidates.count, internal::Found_pairs::capacity);
    candidates.count = 0;
    return false;
  };
  Lanes::collect_within(a.run(), question(1), candidates, stop);
  BOOST_CHECK_EQUAL(calls, 1);
  Lanes::collect_between(a.run(), a.run(), question(1), candidates, stop);
  BOOST_CHECK_EQUAL(calls, 2);
}

BOOST_AUTO_TEST_CASE(lanes_stop_when_told)
{
  check_stop<internal::Near_points_plain>();
  check_stop<internal::Near_points_avx512>();
}

BOOST_AUTO_TEST_SUITE_END()
