// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The lanes of each instruction set against all pairs, and against the plain lanes. Coordinates are
// small integers, as doubles and as 32-bit integers, so that distances are exact and many pairs lie
// exactly at the reach.

#include "support/instruction_sets.h"
#include "support/pairs.h"
#include "support/run_of_points.h"
#include "support/squared_distance.h"

BOOST_AUTO_TEST_SUITE(near_points)

using namespace test_support;

// This comes first, before another one has been forced.
BOOST_AUTO_TEST_CASE(best_instruction_set_is_taken_unless_another_is_forced)
{
  const internal::Instruction_set best = internal::best_instruction_set();
  BOOST_CHECK(internal::instruction_set() == best);
  for(const internal::Instruction_set set : instruction_sets()) {
    const Forced_instruction_set forced(set);
    BOOST_CHECK(internal::instruction_set() == set);
  }
  BOOST_CHECK(internal::instruction_set() == best);
}

// Lanes decide all but the pairs at distance r.
template <class Number>
internal::Near_question<Number> question(double r)
{
  using Real = internal::Real_of<Number>;
  return {static_cast<Number>(r), static_cast<Real>(r * r - 0.5), static_cast<Real>(r * r)};
}

// What lanes collect: the positions of points that are certainly near, and the places of others,
// both in order.
struct Collected
{
  Pairs near;
  Pairs undecided;

  bool operator==(const Collected& other) const
  {
    return near == other.near && undecided == other.undecided;
  }
};

// Calls collect(found, flush), and empties what was found whenever there is much.
template <class Collect>
Collected collected(const Collect& collect)
{
  Collected all;
  internal::Near_pairs found;
  const auto empty = [&] {
    for(internal::Place c = 0; c < found.count; ++c)
      all.near.emplace_back(found.pairs[c].i, found.pairs[c].j);
    for(internal::Place c = 0; c < found.undecided_count; ++c)
      all.undecided.emplace_back(found.undecided[c].i, found.undecided[c].j);
    found.count = 0;
    found.undecided_count = 0;
    return true;
  };
  collect(found, internal::Flush(empty));
  empty();
  return all;
}

template <class Lanes, int Dimension, class Number>
Collected within(Lanes, const Run_of_points<Dimension, Number>& a,
                 const internal::Near_question<Number>& near)
{
  return collected([&](internal::Near_pairs& found, const internal::Flush& flush) {
    Lanes::collect_within(a.run(), near, found, flush);
  });
}

template <class Lanes, int Dimension, class Number>
Collected between(Lanes, const Run_of_points<Dimension, Number>& a,
                  const Run_of_points<Dimension, Number>& b,
                  const internal::Near_question<Number>& near)
{
  return collected([&](internal::Near_pairs& found, const internal::Flush& flush) {
    Lanes::collect_between(a.run(), b.run(), near, found, flush);
  });
}

// All pairs of a place of `a` and a place of `b`, behind it if they are one run, at most r apart.
template <class Run_of>
Collected by_brute_force(const Run_of& a, const Run_of& b, double r)
{
  Collected all;
  for(std::size_t i = 0; i < a.points().size(); ++i)
    for(std::size_t j = &a == &b ? i + 1 : 0; j < b.points().size(); ++j) {
      const double square = squared_distance<double>(a.points()[i], b.points()[j]);
      const std::size_t p = a.run().positions[i], q = b.run().positions[j];
      if(square == r * r)
        all.undecided.emplace_back(i, j);
      else if(square < r * r)
        all.near.push_back(std::minmax(p, q));
    }
  return all;
}

void check_collected(const Collected& expected, const Collected& found)
{
  const Pairs_difference near = compare(expected.near, found.near);
  BOOST_CHECK_MESSAGE(near.empty(), "near: " << near);
  const Pairs_difference undecided = compare(expected.undecided, found.undecided);
  BOOST_CHECK_MESSAGE(undecided.empty(), "undecided: " << undecided);
}

// Positions of b are the smaller ones if `is_b_first`.
template <int Dimension, class Number>
void check_lanes(std::size_t size, std::size_t other_size, double r, std::size_t side,
                 bool is_b_first = false)
{
  Random random(size);
  using Run_of = Run_of_points<Dimension, Number>;
  const Run_of a(integer_points(Dimension, size, side, random), is_b_first ? 1000 : 0);
  const Run_of b(integer_points(Dimension, other_size, side, random), is_b_first ? 0 : 1000);
  const internal::Near_question<Number> near = question<Number>(r);
  const Collected expected_of_a = by_brute_force(a, a, r);
  const Collected expected_of_both = by_brute_force(a, b, r);
  const internal::lanes_plain::Lanes plain;
  with_all_lanes([&](auto set) {
    BOOST_TEST_CONTEXT(size << " and " << other_size << " points, r = " << r)
    {
      const Collected of_a = within(set, a, near), of_both = between(set, a, b, near);
      check_collected(expected_of_a, of_a);
      check_collected(expected_of_both, of_both);
      BOOST_CHECK(of_a == within(plain, a, near)); // in the same order
      BOOST_CHECK(of_both == between(plain, a, b, near));
    }
  });
}

// Runs of no, one and several rows of lanes; and long ones, whose pairs are flushed.
template <class Number>
void check_all_runs()
{
  for(std::size_t size = 0; size <= 40; ++size)
    for(const double r : {0., 1., 5., 100.}) {
      check_lanes<2, Number>(size, (7 * size) % 41, r, 12);
      check_lanes<3, Number>(size, (7 * size) % 41, r, 12, size % 2 != 0);
      check_lanes<2, Number>(size, 3, r, 100, size % 2 != 0);
    }
  check_lanes<2, Number>(300, 500, 5, 30);
  check_lanes<3, Number>(300, 500, 5, 12);
}

BOOST_AUTO_TEST_CASE(all_lanes_collect_the_near_pairs_of_doubles_in_the_same_order)
{
  check_all_runs<double>();
}
BOOST_AUTO_TEST_CASE(all_lanes_collect_the_near_pairs_of_integers_in_the_same_order)
{
  check_all_runs<std::int32_t>();
}

// If doubles decide nothing, the pairs within reach along axis 0 are left, or more of them.
BOOST_AUTO_TEST_CASE(what_lanes_do_not_decide_is_left_once)
{
  Random random(2);
  const Run_of_points<2> a(integer_points(2, 40, 30, random));
  with_all_lanes([&](auto set) {
    const Collected found = within(set, a, {3, -1, infinity});
    const Pairs pairs = sorted(found.undecided);
    std::size_t missing = 0;
    for(std::size_t i = 0; i < 40; ++i)
      for(std::size_t j = i + 1; j < 40; ++j)
        if(a.points()[j][0] - a.points()[i][0] <= 3)
          missing += !std::binary_search(pairs.begin(), pairs.end(), Pair(i, j));
    BOOST_CHECK_EQUAL(missing, 0u);
    BOOST_CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
    BOOST_CHECK(found.near.empty());
  });
}

// Lanes that decide everything leave no ties.
template <class Number>
void check_ties()
{
  const Run_of_points<2, Number> a(Points{{0, 0}, {3, 4}});
  with_all_lanes([&](auto set) {
    const Collected of_one = within(set, a, {5, 25, 25});
    const Collected of_two = between(set, a, a, {5, 25, 25});
    BOOST_CHECK_EQUAL(of_one.near.size(), 1u);
    BOOST_CHECK_EQUAL(of_two.near.size(), 4u);
    BOOST_CHECK(of_one.undecided.empty() && of_two.undecided.empty());
  });
}

BOOST_AUTO_TEST_CASE(ties_are_decided_if_lanes_decide_everything)
{
  check_ties<double>();
  check_ties<std::int32_t>();
}

// 19900 pairs, which are certain or undecided.
template <class Number>
void check_stop(double r)
{
  const Run_of_points<2, Number> a(identical_points(2, 200, 1));
  with_all_lanes([&](auto set) {
    internal::Near_pairs found;
    int calls = 0;
    const auto stop = [&] {
      ++calls;
      BOOST_CHECK_GE(r == 0 ? found.undecided_count : found.count, internal::Near_pairs::capacity);
      found.count = 0;
      found.undecided_count = 0;
      return false;
    };
    set.collect_within(a.run(), question<Number>(r), found, internal::Flush(stop));
    BOOST_CHECK_EQUAL(calls, 1);
    set.collect_between(a.run(), a.run(), question<Number>(r), found, internal::Flush(stop));
    BOOST_CHECK_EQUAL(calls, 2);
  });
}

BOOST_AUTO_TEST_CASE(lanes_stop_when_told)
{
  for(const double r : {0., 1.}) {
    check_stop<double>(r);
    check_stop<std::int32_t>(r);
  }
}

// The largest coordinates and reach, and a bound a little below the reach. The points that end a
// run are beyond the reach of all points and of each other, and no difference overflows.
template <int Dimension>
void check_largest_integers(std::size_t size)
{
  constexpr double top = internal::max_narrow_coordinate;
  constexpr double reach = internal::max_narrow_reach;
  constexpr double bound = reach - 0x1p14; // floats hold its square
  const double values[] = {0, bound, reach, top - reach, top - bound, top};
  Random random(size);
  Points points(size, Coordinates(Dimension));
  for(Coordinates& c : points)
    for(double& x : c)
      x = values[random.below(6)];
  using Run_of = Run_of_points<Dimension, std::int32_t>;
  const Run_of a(points), b(points, 1000);
  constexpr float square = bound * bound;
  const internal::Near_question<std::int32_t> near
    = {internal::max_narrow_reach, std::nextafter(square, 0.f), square};
  with_all_lanes([&](auto set) {
    check_collected(by_brute_force(a, a, bound), within(set, a, near));
    check_collected(by_brute_force(a, b, bound), between(set, a, b, near));
  });
}

BOOST_AUTO_TEST_CASE(largest_integers_do_not_overflow)
{
  for(std::size_t size = 0; size <= 40; ++size) {
    check_largest_integers<2>(size);
    check_largest_integers<3>(size);
  }
}

BOOST_AUTO_TEST_SUITE_END()
