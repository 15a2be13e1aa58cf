// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Near ties in the arithmetic of each tier, against integers of any length.

#include "support/exact_points.h"
#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Near_tie_predicate.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

BOOST_AUTO_TEST_SUITE(Near_tie_predicate)

using namespace test_support;
using CGAL::Arithmetic_tier;
namespace internal = CGAL::Thick_intersection_d::internal;

using Bound = internal::Squared_bound<internal::Exact_number_t<double>>;

constexpr Arithmetic_tier all_tiers[] = {Arithmetic_tier::DOUBLE, Arithmetic_tier::INT64,
                                         Arithmetic_tier::INT128, Arithmetic_tier::FILTERED_EXACT};

std::uint64_t total(const internal::Decision_counts& counts)
{
  std::uint64_t sum = 0;
  for(const Arithmetic_tier tier : all_tiers)
    sum += counts[tier];
  return sum;
}

// The points of the plane on the grid of the integers.
internal::Scene integer_scene()
{
  internal::Scene scene;
  scene.size = 2;
  scene.box = {{0, 1}, {0, 1}};
  scene.grid_exponent = 0;
  return scene;
}

// What a test says of the origin and (x, y). It counts one decision, or none if it says nothing.
std::optional<bool> decision(const internal::Near_tie_predicate& test, double x, double y,
                             Arithmetic_tier counted_as)
{
  const double q[] = {x, y};
  internal::Decision_counts counts;
  const std::optional<bool> is_within
    = test.decide([](int) { return 0.; }, [&](int i) { return q[i]; }, 2, counts);
  BOOST_CHECK_EQUAL(total(counts), is_within ? 1u : 0u);
  BOOST_CHECK_EQUAL(counts[counted_as], is_within ? 1u : 0u);
  return is_within;
}

// The lattice points next to the circle of radius r.
std::vector<std::pair<double, double>> points_near_circle(double r)
{
  std::vector<std::pair<double, double>> points = {{r, 0}, {0, -r}};
  Random random(1);
  for(int i = 0; i < 500; ++i) {
    const double x = std::floor(r * random.uniform());
    const Integer root = sqrt(Integer(Integer(r) * Integer(r) - Integer(x) * Integer(x)));
    points.emplace_back(x, static_cast<double>(root) + static_cast<double>(random.below(3)) - 1);
  }
  return points;
}

void check_tiers(double r, bool is_open)
{
  const auto closed = CGAL::within_distance(r);
  const Bound bound(is_open ? closed.open() : closed);
  const internal::Scene scene = integer_scene();
  const bool fits_64_bits = internal::fits_int64(r, 2);
  const internal::Near_tie_predicate in_64_bits(
    bound, scene, fits_64_bits ? Arithmetic_tier::INT64 : Arithmetic_tier::INT128);
  const internal::Near_tie_predicate in_128_bits(bound, scene, Arithmetic_tier::INT128);
  const internal::Near_tie_predicate twofold(bound, scene, Arithmetic_tier::FILTERED_EXACT);
  for(const auto& [x, y] : points_near_circle(r)) {
    const Integer excess = Integer(x) * Integer(x) + Integer(y) * Integer(y)
                           - Integer(r) * Integer(r);
    const bool expected = is_open ? excess < 0 : excess <= 0;
    if(fits_64_bits)
      BOOST_CHECK(decision(in_64_bits, x, y, Arithmetic_tier::INT64) == expected);
    BOOST_CHECK(decision(in_128_bits, x, y, Arithmetic_tier::INT128) == expected);
    const std::optional<bool> in_doubles = decision(twofold, x, y, Arithmetic_tier::DOUBLE);
    BOOST_CHECK(excess == 0 ? !in_doubles : in_doubles == expected); // no tie, and all others
  }
}

BOOST_AUTO_TEST_CASE(tiers_agree_with_exact_numbers)
{
  for(const double r : {5., 1e6, 1234567890., 1e12})
    for(const bool is_open : {false, true})
      check_tiers(r, is_open);
}

BOOST_AUTO_TEST_CASE(nothing_is_decided_without_a_grid_or_by_plain_doubles)
{
  const Bound bound(CGAL::within_distance(5));
  internal::Scene scene = integer_scene();
  BOOST_CHECK(!decision(internal::Near_tie_predicate(), 3, 3, Arithmetic_tier::DOUBLE));
  BOOST_CHECK(!decision(internal::Near_tie_predicate(bound, scene, Arithmetic_tier::DOUBLE), 3, 3,
                        Arithmetic_tier::DOUBLE));
  scene.grid_exponent.reset();
  for(const Arithmetic_tier tier : all_tiers)
    BOOST_CHECK(!decision(internal::Near_tie_predicate(bound, scene, tier), 3, 3, tier));
}

BOOST_AUTO_TEST_SUITE_END()
