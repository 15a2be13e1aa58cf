// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Comparisons of distances that are equal or nearly so, against integers of any length, in every
// rounding mode.

#include "support/exact_points.h"
#include "support/rounding_mode.h"
#include "support/squared_distance.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Twofold_distance.h>

#include <CGAL/boost_mp.h>

BOOST_AUTO_TEST_SUITE(Twofold_distance)

using namespace test_support;

using Numbers = std::array<double, 3>; // integers
struct Two_points
{
  Numbers p, q;
};

internal::Twofold_distance distance(const Two_points& points, int exponent)
{
  return internal::Twofold_distance([&](int i) { return std::ldexp(points.p[i], exponent); },
                                    [&](int i) { return std::ldexp(points.q[i], exponent); }, 3);
}

// Two pairs of points with the same differences along the axes, in some order, but for one that
// may be a step longer.
std::array<Two_points, 2> same_gaps(int bits, Random& random)
{
  Numbers gaps;
  for(double& gap : gaps)
    gap = static_cast<double>(random.below(std::uint64_t(1) << bits));
  std::array<Two_points, 2> pairs;
  for(Two_points& points : pairs) {
    std::rotate(gaps.begin(), gaps.begin() + random.below(3), gaps.end());
    for(std::size_t i = 0; i < 3; ++i) {
      points.p[i] = static_cast<double>(random.below(std::uint64_t(1) << 52));
      points.q[i] = points.p[i] + (random.below(2) == 0 ? gaps[i] : -gaps[i]);
    }
  }
  pairs[1].q[0] += static_cast<double>(random.below(2));
  return pairs;
}

// Two pairs of points whose differences are not the same, but have equal squares in the plane:
// (ac - bd)^2 + (ad + bc)^2 = (ac + bd)^2 + (ad - bc)^2. Along the last axis one may have a step.
std::array<Two_points, 2> same_squares(int bits, Random& random)
{
  const auto number = [&] {
    return static_cast<double>(random.below(std::uint64_t(1) << (bits / 2)));
  };
  const double a = number(), b = number(), c = number(), d = number();
  std::array<Two_points, 2> pairs = {};
  pairs[0].q = {a * c - b * d, a * d + b * c, 0};
  pairs[1].q = {a * c + b * d, a * d - b * c, static_cast<double>(random.below(2))};
  return pairs;
}

// Returns how many comparisons are decided, and how many of these are ties.
template <class Make>
std::pair<int, int> check_near_ties(const Make& make, int bits, int exponent)
{
  std::pair<int, int> counts = {0, 0};
  Random random(static_cast<unsigned int>(bits));
  for(int k = 0; k < 1000; ++k) {
    const auto [a, b] = make(bits, random);
    const int expected = CGAL::compare(squared_distance<Integer>(a.p, a.q),
                                       squared_distance<Integer>(b.p, b.q));
    for(const int mode : rounding_modes) {
      const Rounding_mode rounding(mode);
      const std::optional<int> found = distance(a, exponent).compare(distance(b, exponent));
      if(found && *found != expected)
        BOOST_ERROR(bits << " bits, grid 2^" << exponent << ": " << *found << " instead of "
                         << expected);
      counts.first += found.has_value();
      counts.second += found == 0;
    }
  }
  return counts;
}

BOOST_AUTO_TEST_CASE(near_ties_are_right_or_undecided)
{
  for(const int bits : {2, 20, 26, 30, 46, 48, 50, 51})
    for(const int exponent : {-340, 0, 400}) {
      check_near_ties(same_gaps, bits, exponent);
      check_near_ties(same_squares, bits, exponent);
    }
}

BOOST_AUTO_TEST_CASE(ties_of_near_coordinates_are_decided)
{
  const std::pair<int, int> counts = check_near_ties(same_gaps, 20, 0);
  BOOST_CHECK_GE(counts.first, 3990);
  BOOST_CHECK_GE(counts.second, 1500);
}

// Sums of the same three squares, in another order. The differences are no doubles, so the parts of
// the sums that are rounded off depend on the order.
BOOST_AUTO_TEST_CASE(the_order_of_the_axes_decides_nothing)
{
  Random random(1);
  for(int k = 0; k < 1000; ++k) {
    Two_points a;
    for(std::size_t i = 0; i < 3; ++i) {
      a.p[i] = std::ldexp(static_cast<double>(random.below(std::uint64_t(1) << 52)), 40);
      a.q[i] = static_cast<double>(random.below(std::uint64_t(1) << 52));
    }
    Two_points b = a;
    std::rotate(b.p.begin(), b.p.begin() + 1, b.p.end());
    std::rotate(b.q.begin(), b.q.begin() + 1, b.q.end());
    for(const int mode : rounding_modes) {
      const Rounding_mode rounding(mode);
      BOOST_CHECK_EQUAL(distance(a, 0).compare(distance(b, 0)).value_or(0), 0);
    }
  }
}

// The square of the short gap is no double, or is lost beside that of the long one.
BOOST_AUTO_TEST_CASE(short_gaps_decide_if_long_gaps_are_the_same)
{
  for(const double gap : {1e-20, 1e-235}) {
    const Two_points a = {{2, 5 * gap, 0}, {3, 8 * gap, 0}}, b = {{7, 5 * gap, 0}, {6, 9 * gap, 0}};
    BOOST_CHECK(distance(a, 0).compare(distance(b, 0)) == -1);
    BOOST_CHECK(distance(b, 0).compare(distance(a, 0)) == 1);
  }
}

// Differences of tiny coordinates are multiplied by a power of two before they are squared.
BOOST_AUTO_TEST_CASE(distances_are_compared_at_a_scale)
{
  const auto scaled = [](double x, double y) {
    return internal::Twofold_distance([&](int i) { return i == 0 ? x : 0; },
                                      [&](int i) { return i == 0 ? 0 : y; }, 2, 0x1p1000);
  };
  const double unit = 0x1p-1000;
  BOOST_CHECK(scaled(3 * unit, 4 * unit).compare(scaled(5 * unit, 0)) == std::nullopt);
  BOOST_CHECK(scaled(3 * unit, 4 * unit).compare(scaled(4 * unit, 3 * unit)) == 0);
  BOOST_CHECK(scaled(3 * unit, 4 * unit).compare(scaled(5.0000001 * unit, 0)) == -1);
}

// Both differences are 2^100 in doubles.
BOOST_AUTO_TEST_CASE(differences_that_are_rounded_are_no_tie)
{
  const Two_points longer = {{0x1p100, 0, 0}, {0, 0, 0}}, shorter = {{0x1p100, 0, 0}, {1, 0, 0}};
  const std::optional<int> found = distance(shorter, 0).compare(distance(longer, 0));
  BOOST_CHECK(!found || *found == -1);
}

// Some rounding modes make the largest double of them. These two distances are the same.
BOOST_AUTO_TEST_CASE(differences_that_overflow_are_left_to_exact_numbers)
{
  const auto distance_to = [](double x, double y) {
    return internal::Twofold_distance([](int i) { return (i == 0 ? -12.5 : -12) * 0x1p1020; },
                                      [&](int i) { return (i == 0 ? x : y) * 0x1p1020; }, 2,
                                      0x1p-1022);
  };
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    BOOST_CHECK(distance_to(12.5, -12).compare(distance_to(-5.5, 12)) == std::nullopt);
  }
}

BOOST_AUTO_TEST_SUITE_END()
