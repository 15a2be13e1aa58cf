// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// How close the points of two legs come: in doubles, in integers and in rationals, against tracks
// of one leg each.

#include "support/rounding_mode.h"
#include "support/track_oracle.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Leg.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Relative_motion.h>

using namespace test_support;

namespace {

// A lattice in other units, at other places.
struct Units
{
  double place = 1;
  double place_origin = 0;
  double time = 1;
  double time_origin = 0;
};

const std::vector<Units> all_units
  = {{}, {0x1p-52, 1, 0x1p-52, 1}, {1, 0x1p52, 1, -0x1p52}, {0x1p-1074, 0, 1, 0},
     {0x1p990, 0, 1, 0}, {1, 0, 0x1p-1074, 0}, {1, 0, 0x1.8p1020, -0x9p1020},
     {0x1p300, 0, 0x1p-300, 0}, {3, -7, 5, -11}};

Lattice_track random_leg(Random& random, int side, int longest, int dimension)
{
  const auto below = [&](int n) { return static_cast<int>(random.below(std::uint64_t(n))); };
  const auto place = [&] {
    return std::array<int, 3>{below(side), below(side), dimension == 3 ? below(side) : 0};
  };
  const int time = below(longest);
  const Lattice_fix first = {time, place()};
  if(below(8) == 0)
    return {first, first};
  return {first, {time + 1 + below(longest), below(4) == 0 ? first.place : place()}};
}

template <std::size_t N>
internal::Leg<N> leg_of(const Lattice_track& track, const Units& units)
{
  internal::Leg<N> leg;
  for(std::size_t k = 0; k < 2; ++k) {
    leg.times[k] = units.time_origin + units.time * track[k].time;
    for(std::size_t axis = 0; axis < N; ++axis)
      leg.ends[k][axis] = units.place_origin + units.place * track[k].place[axis];
  }
  return leg;
}

template <std::size_t N>
internal::Exact_leg<Exact_rational, N> exact_leg_of(const Lattice_track& track)
{
  internal::Exact_leg<Exact_rational, N> leg;
  for(std::size_t k = 0; k < 2; ++k) {
    leg.times[k] = track[k].time;
    for(std::size_t axis = 0; axis < N; ++axis)
      leg.ends[k][axis] = track[k].place[axis];
  }
  return leg;
}

// The doubles enclose the distance, and if numbers are moderate, they are close to each other.
void check_enclosure(const internal::Interval& distance, const std::optional<Approach>& approach,
                     const Units& units)
{
  if(!approach) {
    BOOST_CHECK_EQUAL(distance.low, infinity);
    return;
  }
  const Exact_rational unit(units.place), square(approach->square * unit * unit);
  BOOST_CHECK(distance.low <= 0 || Exact_rational(distance.low) * Exact_rational(distance.low)
                                     <= square);
  if(distance.high != infinity)
    BOOST_CHECK(Exact_rational(distance.high) * Exact_rational(distance.high) >= square);
  const bool are_moderate = 0x1p-380 < units.place && units.place < 0x1p380
                            && units.time * 100 < 0x1p1000;
  if(are_moderate)
    BOOST_CHECK_LT(distance.high - (std::max)(distance.low, 0.), units.place * 1e-9);
}

// Whether the distance is at most r, or less than r, in lattice units.
bool is_near(const std::optional<Approach>& approach, int r, bool is_open)
{
  return approach && (is_open ? approach->square < r * r : approach->square <= r * r);
}

template <std::size_t N>
void check_integers(const Lattice_track& a, const Lattice_track& b,
                    const std::optional<Approach>& approach, const Units& units)
{
  for(const int r : {0, 1, 2, 5})
    for(const bool is_open : {false, true}) {
      const internal::Integer_legs<N> legs(leg_of<N>(a, units), leg_of<N>(b, units),
                                           units.place * r);
      const std::optional<bool> answer = legs.are_near(is_open);
      BOOST_CHECK(answer.has_value() || units.time > 0x1p1000); // differences may overflow
      BOOST_CHECK_EQUAL(answer.value_or(is_near(approach, r, is_open)),
                        is_near(approach, r, is_open));
    }
}

template <std::size_t N>
void check_rationals(const Lattice_track& a, const Lattice_track& b,
                     const std::optional<Approach>& approach)
{
  const internal::Relative_motion<Exact_rational, N> motion(exact_leg_of<N>(a),
                                                            exact_leg_of<N>(b));
  BOOST_REQUIRE_EQUAL(motion.has_time(), approach.has_value());
  if(!approach)
    return;
  BOOST_CHECK(motion.time_of_least() == approach->time);
  BOOST_CHECK(motion.least_square().first == motion.least_square().second * approach->square);
}

template <std::size_t N>
void check_legs(std::uint64_t count, bool are_times_common)
{
  Random random(N);
  std::size_t ties = 0;
  for(std::uint64_t k = 0; k < count; ++k) {
    const int side = 2 + static_cast<int>(random.below(8));
    const Lattice_track a = random_leg(random, side, 6, N);
    Lattice_track b = random_leg(random, side, 6, N);
    for(std::size_t end = 0; are_times_common && end < 2; ++end)
      b[end].time = a[end].time;
    if(a[0].time == a[1].time && are_times_common)
      b[1] = b[0];
    const std::optional<Approach> approach = approach_of(a, b);
    ties += approach && approach->square == 1;
    check_rationals<N>(a, b, approach);
    for(std::size_t place = 0; place < all_units.size(); ++place)
      BOOST_TEST_CONTEXT("legs " << k << ", units " << place) {
        const Units& units = all_units[place];
        check_enclosure(internal::distance_of(leg_of<N>(a, units), leg_of<N>(b, units)), approach,
                        units);
        check_integers<N>(a, b, approach, units);
      }
  }
  BOOST_CHECK_GT(ties, count / 100);
}

} // namespace

BOOST_AUTO_TEST_CASE(legs_of_common_times)
{
  check_legs<2>(300, true);
  check_legs<3>(300, true);
}

BOOST_AUTO_TEST_CASE(legs_of_times_of_their_own)
{
  check_legs<2>(600, false);
  check_legs<3>(600, false);
}

// Each number is known up to an error that may move the points past each other.
BOOST_AUTO_TEST_CASE(errors_of_places_and_times_widen_the_enclosure)
{
  const Lattice_track a = {{0, {0, 0, 0}}, {4, {8, 0, 0}}}, b = {{1, {4, 3, 0}}, {5, {4, 3, 0}}};
  for(const double error : {0x1p-40, 0x1p-10, 1.}) {
    internal::Leg<2> first = leg_of<2>(a, {}), second = leg_of<2>(b, {});
    first.error = error;
    const internal::Interval of_places = internal::distance_of(first, second);
    BOOST_CHECK_LE(of_places.low, 3 - error);
    BOOST_CHECK_GE(of_places.high, 3 + error);
    first.error = 0;
    second.time_error = error;
    const internal::Interval of_times = internal::distance_of(first, second);
    BOOST_CHECK_LE(of_times.low, 3 - error);
    BOOST_CHECK_GE(of_times.high, 3 + error);
  }
}

// A vanishing share of an infinite error is NaN.
BOOST_AUTO_TEST_CASE(nothing_is_known_of_places_beyond_the_doubles)
{
  const double largest = (std::numeric_limits<double>::max)();
  for(const double time_error : {0., 0x1p-1074, 1.}) {
    const internal::Leg<2> leg = {{{{largest, 0}, {largest, 0}}}, {0, 4}, infinity, time_error};
    const internal::Interval distance = internal::distance_of(leg, leg);
    BOOST_CHECK_EQUAL(distance.low, -infinity);
    BOOST_CHECK_EQUAL(distance.high, infinity);
  }
}

// The common time may be shorter than the error, or there may be none.
BOOST_AUTO_TEST_CASE(common_times_may_be_unknown)
{
  const auto leg = [](double begin, double end, double error) {
    return internal::Leg<2>{{{{0, 0}, {1, 0}}}, {begin, end}, 0, error};
  };
  const auto distance = [&](double begin, double error) {
    return internal::distance_of(leg(0, 1, 0), leg(begin, 3, error));
  };
  BOOST_CHECK_EQUAL(distance(1.5, .25).low, infinity);
  for(const double begin : {.875, 1., 1.125}) {
    BOOST_CHECK_EQUAL(distance(begin, .25).low, -infinity);
    BOOST_CHECK_EQUAL(distance(begin, .25).high, infinity);
  }
  BOOST_CHECK_GE(distance(1, 0).high, 1);
  BOOST_CHECK_LT(distance(1, 0).high, 1.001);
}

// In some rounding modes, a difference that overflows is the largest double.
BOOST_AUTO_TEST_CASE(integers_refuse_differences_that_overflow_in_every_rounding_mode)
{
  const double unit = 0x1p1022, x = 3 * unit;
  const internal::Leg<2> still = {{{{0, 0}, {0, 0}}}, {0, unit}};
  const internal::Leg<2> across = {{{{-x, 0}, {x, 0}}}, {0, unit}};
  const internal::Leg<2> long_ago = {{{{0, 0}, {unit, 0}}}, {-x, x}};
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    for(const internal::Leg<2>& leg : {across, long_ago}) {
      BOOST_CHECK(!internal::Integer_legs<2>(leg, still, unit).are_near(false));
      BOOST_CHECK_EQUAL(internal::distance_of(leg, still).high, infinity);
    }
  }
}

BOOST_AUTO_TEST_CASE(integers_refuse_what_they_cannot_hold)
{
  internal::Leg<3> a = leg_of<3>({{0, {0, 0, 0}}, {1, {1, 2, 3}}}, {});
  const internal::Leg<3> b = leg_of<3>({{0, {5, 5, 5}}, {1, {1, 1, 1}}}, {});
  BOOST_CHECK(internal::Integer_legs<3>(a, b, 1).are_near(false).has_value());
  BOOST_CHECK(!internal::Integer_legs<3>(a, b, 1 + 0x1p-40).are_near(false));
  BOOST_CHECK(!internal::Integer_legs<3>(a, b, 0x1p61).are_near(false));
  a.ends[0][1] = 0x1p-33;
  BOOST_CHECK(!internal::Integer_legs<3>(a, b, 0).are_near(false));
  a.ends[0][1] = 0;
  a.times[1] = 1 + 0x1p-20;
  BOOST_CHECK(!internal::Integer_legs<3>(a, b, 1).are_near(false));
}
