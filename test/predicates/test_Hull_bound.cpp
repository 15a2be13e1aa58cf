// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What doubles know of a bound on a distance, and the integers that decide about hulls on a grid,
// against the oracle.

#include "support/distance_oracle.h"
#include "support/lattice_hulls.h"
#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Hull_bound.h>

BOOST_AUTO_TEST_SUITE(Hull_bound)

using namespace test_support;

// ---- bounds in doubles --------------------------------------------------------------------------

template <class NT>
internal::Hull_bound hull_bound(const CGAL::Distance_bound<NT>& bound)
{
  internal::Hull_bound result;
  const internal::Squared_bound<internal::Exact_number_t<NT>> squared(bound);
  internal::set_hull_bound(result, bound, squared);
  return result;
}

BOOST_AUTO_TEST_CASE(a_double_is_its_bound)
{
  const internal::Hull_bound bound = hull_bound(CGAL::within_distance(.1));
  BOOST_CHECK(bound.is_exact_radius && !bound.is_open);
  BOOST_CHECK_EQUAL(bound.radius.low, .1);
  BOOST_CHECK_GE(bound.radius.high, .1);
  BOOST_CHECK(hull_bound(CGAL::within_distance(.1).open()).is_open);
}

// Whether the radius encloses the root of x, closely.
void check_root(const internal::Hull_bound& bound, const Rational& x)
{
  const Rational low(bound.radius.low), high(bound.radius.high);
  BOOST_CHECK(!bound.is_exact_radius);
  BOOST_CHECK(low * low < x && x < high * high);
  BOOST_CHECK_LT(bound.radius.high - bound.radius.low, 1e-15 * bound.radius.high);
}

BOOST_AUTO_TEST_CASE(roots_and_fractions_are_enclosed)
{
  for(const double x : {2., 3., 5e-9, 1e30})
    check_root(hull_bound(CGAL::within_squared_distance(x)), Rational(x));
  for(const int x : {3, 7, 11, 1000003})
    check_root(hull_bound(CGAL::within_distance(CGAL::Exact_rational(1) / x)),
               Rational(1) / Rational(x) / Rational(x));
}

BOOST_AUTO_TEST_CASE(sums_are_enclosed_in_every_rounding_mode)
{
  Random random(1);
  for(int i = 0; i < 2000; ++i) {
    const double x[] = {random.uniform(), random.uniform() * 0x1p-30, random.uniform() * 0x1p3};
    internal::Hull_bound bound;
    bound.radius = {x[0], x[0]};
    internal::Interval reach;
    {
      const Rounding_mode rounding(rounding_modes[i % 4]);
      reach = internal::reach_of_hulls(bound, {x[1], x[1]}, {x[2], x[2]});
    }
    const Rational sum = Rational(x[0]) + Rational(x[1]) + Rational(x[2]);
    BOOST_CHECK(Rational(reach.low) <= sum && sum <= Rational(reach.high));
    BOOST_CHECK_LT(reach.high - reach.low, 1e-14 * reach.high);
  }
}

// ---- integers -----------------------------------------------------------------------------------

template <int Dimension>
std::optional<bool> answer(const Integers& a, const Integers& b, const std::array<double, 3>& radii,
                           double unit, double offset, bool is_open)
{
  const auto moved = [&](const Integers& vertices) {
    std::vector<std::array<double, Dimension>> result;
    for(const auto& p : vertices) {
      result.push_back(as_doubles<Dimension>(p, unit));
      for(double& x : result.back())
        x += offset * unit;
    }
    return result;
  };
  return internal::Integer_hulls<Dimension>(moved(a), moved(b), radii[0] * unit, radii[1] * unit,
                                            radii[2] * unit)
    .are_near(is_open);
}

// With a bound at the distance, or next to it, in integers as long as they may be.
template <int Dimension>
void check_hulls(std::int64_t limit)
{
  Random random(Dimension);
  std::size_t wrong = 0, unknown = 0, ties = 0;
  for(int i = 0; i < 4000; ++i) {
    Lattice lattice = {Dimension, 2 + random.below(8)};
    if(random.below(2) == 0) // its places are far apart
      lattice.step = (limit - 1) / static_cast<int>(lattice.side);
    const Integers a = lattice_hull(random, lattice, 1 + random.below(4));
    const Integers b = lattice_hull(random, lattice, 1 + random.below(4));
    const Rational square = squared_distance_of_long_hulls(a, b);
    if(square == 0)
      continue;
    const double root = std::floor(std::sqrt(static_cast<double>(square)));
    const double reach = (std::max)(0., root + static_cast<double>(random.below(3)) - 1);
    const double first = std::floor(reach * random.uniform());
    const double second = std::floor((reach - first) * random.uniform());
    const double unit = random.below(2) == 0 ? 1 : 0x1p-20;
    const double offset = random.below(2) == 0 ? 0 : 0x1p24;
    const int sign = square.compare(Rational(reach) * Rational(reach));
    for(const bool is_open : {false, true}) {
      const auto found = answer<Dimension>(a, b, {first, second, reach - first - second}, unit,
                                           offset, is_open);
      unknown += !found;
      wrong += found && *found != (is_open ? sign < 0 : sign <= 0);
    }
    ties += sign == 0;
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_EQUAL(unknown, 0u);
  BOOST_CHECK_GT(ties, 100u);
}

BOOST_AUTO_TEST_CASE(hulls_on_a_grid)
{
  check_hulls<2>(std::int64_t(1) << 27);
  check_hulls<3>(std::int64_t(1) << 17);
}

template <int Dimension>
void check_limit(std::int64_t limit)
{
  const auto is_known = [](std::int64_t x, double radius) {
    return answer<Dimension>({{0, 0, 0}, {x, 0, 0}}, {{1, 1, 0}}, {0, 0, radius}, 1, 0, false)
      .has_value();
  };
  BOOST_CHECK(is_known(limit - 1, 1) && is_known(1 - limit, 1));
  BOOST_CHECK(!is_known(limit, 1) && !is_known(-limit, 1));
  BOOST_CHECK(is_known(5, static_cast<double>(limit - 1)));
  BOOST_CHECK(!is_known(5, static_cast<double>(limit)));
  BOOST_CHECK(!is_known(5, 0x1p-30));
}

// In some rounding modes, a difference that overflows is the largest double.
BOOST_AUTO_TEST_CASE(differences_that_overflow_are_too_long_in_every_rounding_mode)
{
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    BOOST_CHECK(!answer<2>({{-3, 0, 0}}, {{3, 0, 0}}, {0, 0, 1}, 0x1p1022, 0, false));
    BOOST_CHECK(!answer<3>({{3, 0, 0}}, {{-3, 0, 0}}, {0, 0, 1}, 0x1p1022, 0, false));
  }
}

BOOST_AUTO_TEST_CASE(integers_that_are_too_long)
{
  check_limit<2>(std::int64_t(1) << 28);
  check_limit<3>(std::int64_t(1) << 18);
}

BOOST_AUTO_TEST_SUITE_END()
