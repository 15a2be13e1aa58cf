// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The certificates: the first tier that is exact, up to its very limits.

#include "support/exact_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>

#include <CGAL/Scene_profile.h>

BOOST_AUTO_TEST_SUITE(exact_tier)

using namespace test_support;

CGAL::Scene_profile profile_of_units(int dimension, double reach, int exponent)
{
  return CGAL::Scene_profile(2, std::vector<std::pair<double, double>>(dimension, {0, reach}),
                             reach, exponent);
}

BOOST_AUTO_TEST_CASE(doubles_are_not_certified_where_squares_vanish_or_overflow)
{
  using Tier = CGAL::Arithmetic_tier;
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., -530), -537).tier() == Tier::DOUBLE);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., -530), -538).tier() == Tier::INT64);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., 500), 490).tier() == Tier::DOUBLE);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., 501), 490).tier() == Tier::INT64);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., 1022), 1010).tier() == Tier::INT64);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1.5, 1022), 1010).tier() == Tier::FILTERED_EXACT);
  BOOST_CHECK(CGAL::Scene_profile(2, {{0, 1}, {0, 1}}, 1, std::nullopt).tier()
              == Tier::FILTERED_EXACT);
}

BOOST_AUTO_TEST_CASE(no_finer_grid_fits_128_bits)
{
  for(const double reach : {0., 5e-324, 1e-320, 1e-300, 0.1, 1., 1.99, 1e300, 0x1p1022})
    for(const int axis_count : {0, 1, 3, 4, 5, 100}) {
      const int e = internal::finest_grid_exponent(reach, axis_count);
      BOOST_CHECK(internal::fits_int128(internal::steps_within(reach, e), axis_count));
      BOOST_CHECK(e == -1074
                  || !internal::fits_int128(internal::steps_within(reach, e - 1), axis_count));
    }
}

// The first tier that holds d U^2, in integers of any length.
CGAL::Arithmetic_tier tier_of(const Integer& units, int axis_count)
{
  const Integer square = units * units;
  if(Integer(square * (std::max)(axis_count, 2)) <= Integer(1) << 53)
    return CGAL::Arithmetic_tier::DOUBLE;
  const Integer sum = square * (std::max)(axis_count, 1);
  if(sum < Integer(1) << 63)
    return CGAL::Arithmetic_tier::INT64;
  if(units < Integer(1) << 63 && sum < Integer(1) << 128)
    return CGAL::Arithmetic_tier::INT128;
  return CGAL::Arithmetic_tier::FILTERED_EXACT;
}

void check_tier(double units, int axis_count)
{
  const CGAL::Arithmetic_tier expected = tier_of(Integer(units), axis_count);
  for(const int exponent : {0, -500, 400}) {
    const double reach = std::ldexp(units, exponent);
    BOOST_CHECK_EQUAL(internal::first_exact_tier(reach, exponent, axis_count), expected);
    BOOST_CHECK_EQUAL(profile_of_units(axis_count, reach, exponent).tier(), expected);
    const double below_next_step = std::nextafter(std::ldexp(units + 1, exponent), 0);
    if(units < 0x1p52)
      BOOST_CHECK_EQUAL(internal::first_exact_tier(below_next_step, exponent, axis_count),
                        expected);
  }
}

// The last U at which d U^2 is within each limit, and its neighbors, in up to 12 dimensions.
BOOST_AUTO_TEST_CASE(tiers_hold_the_sums_of_squares)
{
  for(int axis_count = 0; axis_count <= 12; ++axis_count)
    for(const Integer& limit : {Integer(Integer(1) << 53), Integer((Integer(1) << 63) - 1),
                                Integer((Integer(1) << 128) - 1), Integer(Integer(1) << 126)})
      for(const int terms : {(std::max)(axis_count, 1), (std::max)(axis_count, 2)}) {
        double units = static_cast<double>(Integer(sqrt(Integer(limit / terms))));
        for(int i = 0; i < 3; ++i)
          units = std::ceil((std::min)(std::nextafter(units, 0), units - 1));
        for(int i = 0; i < 6; ++i) {
          check_tier(units, axis_count);
          units = (std::max)(units + 1, std::nextafter(units, 1e300));
        }
      }
}

BOOST_AUTO_TEST_CASE(without_a_grid_or_beyond_all_integers_only_exact_numbers_serve)
{
  const auto last = CGAL::Arithmetic_tier::FILTERED_EXACT;
  BOOST_CHECK_EQUAL(internal::first_exact_tier(1, std::nullopt, 2), last);
  BOOST_CHECK_EQUAL(internal::first_exact_tier(1e300, -1000, 2), last); // the steps are no double
  BOOST_CHECK_EQUAL(internal::first_exact_tier(infinity, 0, 2), last);
}

BOOST_AUTO_TEST_SUITE_END()
