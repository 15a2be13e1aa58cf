// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Distances whose squares overflow or underflow, against integers of any length: near ties, in
// every rounding mode.

#include "support/exact_points.h"
#include "support/rounding_mode.h"
#include "support/squared_distance.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Scaled_filter.h>

BOOST_AUTO_TEST_SUITE(Scaled_filter)

using namespace test_support;

using Bound = internal::Squared_bound<internal::Exact_number_t<double>>;

using Filter = internal::Scaled_filter;

constexpr Filter none = {1, 0, {-1, std::numeric_limits<double>::infinity()}}; // decides nothing

// A scene of coordinates up to `largest`, on the grid of 2^grid_exponent if that is known.
internal::Scene scene_up_to(std::size_t dimension, double largest,
                            std::optional<int> grid_exponent = std::nullopt)
{
  internal::Scene scene;
  scene.box.assign(dimension, {-largest, largest});
  scene.grid_exponent = grid_exponent;
  return scene;
}

// Whether p and q are within the bound, if this is certain.
template <std::size_t Dimension>
std::optional<bool> decision(const Filter& filter, const std::array<double, Dimension>& p,
                             const std::array<double, Dimension>& q)
{
  double s = 0;
  for(std::size_t i = 0; i < Dimension; ++i) {
    const double gap = p[i] * filter.scale - q[i] * filter.scale;
    s += gap * gap;
  }
  if(s <= filter.filter.inside)
    return true;
  if(s > filter.filter.outside)
    return false;
  return std::nullopt;
}

// Points on the grid of 2^exponent with coordinates of 40 bits, and a bound whose quotient by their
// distance is 1 + 2^-closeness or 1 - 2^-closeness, up to a step. Returns the share of the answers
// that are certain.
double check_near_ties(int exponent, int closeness)
{
  const int count = 200;
  int certain = 0;
  Random random(static_cast<unsigned int>(closeness));
  for(int k = 0; k < count; ++k) {
    std::array<double, 3> p, q;
    for(std::size_t i = 0; i < 3; ++i) {
      p[i] = static_cast<double>(random.below(std::uint64_t(1) << 40));
      q[i] = -static_cast<double>(random.below(std::uint64_t(1) << 40));
    }
    const Integer square = squared_distance<Integer>(p, q);
    const double sign = random.below(2) == 0 ? 1 : -1;
    const double steps = std::floor(std::sqrt(static_cast<double>(square))
                                    * (1 + sign * std::ldexp(1., -closeness)));
    const bool expected = square <= Integer(steps) * Integer(steps);
    double largest = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      p[i] = std::ldexp(p[i], exponent);
      q[i] = std::ldexp(q[i], exponent);
      largest = (std::max)({largest, p[i], -q[i]});
    }
    const Filter filter = internal::scaled_filter(
      Bound(CGAL::within_distance(std::ldexp(steps, exponent))), scene_up_to(3, largest), none);
    for(const int mode : rounding_modes) {
      const Rounding_mode rounding(mode);
      const std::optional<bool> found = decision(filter, p, q);
      if(found && *found != expected)
        BOOST_ERROR("grid 2^" << exponent << ", closeness " << closeness << ": a distance that is "
                              << (expected ? "within the bound" : "beyond the bound"));
      certain += found.has_value();
    }
  }
  return certain / (4. * count);
}

BOOST_AUTO_TEST_CASE(near_ties_are_right_or_undecided)
{
  for(const int exponent : {-1074, -1040, -900, -530, 480, 600, 900, 970, 982})
    for(const int closeness : {1, 20, 38, 44, 46, 48, 49, 50, 52})
      check_near_ties(exponent, closeness);
}

BOOST_AUTO_TEST_CASE(distances_that_are_no_near_tie_are_certain)
{
  for(const int exponent : {-1074, -900, -530, 480, 600, 900, 982})
    BOOST_CHECK_EQUAL(check_near_ties(exponent, 30), 1);
}

BOOST_AUTO_TEST_CASE(bounds_in_the_range_of_the_other_filter_are_left_to_it)
{
  for(const int exponent : {-300, 0, 300})
    BOOST_CHECK_EQUAL(check_near_ties(exponent, 30), 0);
}

// A bound on the squares of few steps of a grid. A reach of whole steps of 2^-1074 would be too
// long, and an open bound of one step would leave all pairs of neighbors to exact numbers.
void check_few_steps(int exponent, int squared_steps, bool is_open, double largest)
{
  using Exact = internal::Exact_number_t<double>;
  const double step = std::ldexp(1., exponent);
  const auto bound
    = CGAL::within_squared_distance(Exact(Exact(squared_steps) * Exact(step) * Exact(step)));
  const Filter filter = internal::scaled_filter(
    Bound(is_open ? bound.open() : bound), scene_up_to(3, largest, exponent), none);
  BOOST_CHECK(filter.reach < std::sqrt(squared_steps + 1) * (step * filter.scale));
  const std::array<double, 3> p = {16384 * step, 0, -step};
  for(int i = -5; i <= 5; ++i)
    for(int j = -5; j <= 5; ++j)
      for(int k = -5; k <= 5; ++k) {
        const std::array<double, 3> q = {p[0] + i * step, p[1] + j * step, p[2] + k * step};
        const int square = i * i + j * j + k * k;
        const bool expected = is_open ? square < squared_steps : square <= squared_steps;
        BOOST_CHECK(decision(filter, p, q) == std::optional<bool>(expected));
        for(const int gap : {i, j, k})
          BOOST_CHECK(!expected || std::abs(gap) * (step * filter.scale) <= filter.reach);
      }
}

BOOST_AUTO_TEST_CASE(few_steps_of_a_grid_are_certain)
{
  for(const int exponent : {-1074, -1073, -1045, -1000, -700, -500, 600, 1000})
    for(int squared_steps = 1; squared_steps <= 30; ++squared_steps)
      for(const bool is_open : {false, true})
        for(const double factor : {0x1p14, 0x1p20, 0x1p560}) // of the coordinates of the scene
          for(const int mode : rounding_modes) {
            const double largest
              = (std::min)(std::ldexp(factor, exponent), (std::numeric_limits<double>::max)());
            const Rounding_mode rounding(mode);
            check_few_steps(exponent, squared_steps, is_open, largest);
          }
}

BOOST_AUTO_TEST_CASE(a_grid_of_many_steps_is_as_none)
{
  const Bound bound(CGAL::within_distance(std::ldexp(1., 25 - 1040)));
  const Filter filter = internal::scaled_filter(bound, scene_up_to(2, 0x1p-1000, -1040), none);
  BOOST_CHECK(filter.filter.inside < filter.filter.outside);
}

// The grid may be that of points which are all farther apart than the bound.
BOOST_AUTO_TEST_CASE(a_bound_below_a_step_of_the_grid_leaves_equal_points)
{
  for(const int grid_exponent : {-1000, 0, 900}) {
    const double step = std::ldexp(1., grid_exponent);
    const Filter filter = internal::scaled_filter(
      Bound(CGAL::within_distance(0x1p-1030)), scene_up_to(2, 8 * step, grid_exponent), none);
    const std::array<double, 2> p = {step, step}, q = {step, 2 * step};
    BOOST_CHECK(decision(filter, p, p) != std::optional<bool>(false));
    BOOST_CHECK(decision(filter, p, q) == std::optional<bool>(false));
  }
}

// The reach of a squared bound may be a step longer than the bound.
BOOST_AUTO_TEST_CASE(many_denormal_steps_are_certain_unless_they_are_a_near_tie)
{
  using Exact = internal::Exact_number_t<double>;
  const double distance = std::ldexp(1., 30 - 1074);
  const Filter filter = internal::scaled_filter(
    Bound(CGAL::within_squared_distance(Exact(Exact(distance) * Exact(distance)))),
    scene_up_to(2, 1), none);
  const std::array<double, 2> p = {0, 0}, near = {distance * (1 - 0x1p-20), 0},
                              far = {distance * (1 + 0x1p-20), 0};
  BOOST_CHECK(decision(filter, p, near) == std::optional<bool>(true));
  BOOST_CHECK(decision(filter, p, far) == std::optional<bool>(false));
}

// Scaled to keep them in range, denormal numbers would lose the bits that decide.
BOOST_AUTO_TEST_CASE(a_denormal_bound_in_a_huge_scene_is_left_to_the_other_filter)
{
  const Filter filter = internal::scaled_filter(
    Bound(CGAL::within_distance(std::ldexp(10905190, -1074))), scene_up_to(2, 0x1p1023), none);
  BOOST_CHECK_EQUAL(filter.scale, none.scale);
  BOOST_CHECK_EQUAL(filter.filter.inside, none.filter.inside);
}

// The extent of a scene may overflow.
BOOST_AUTO_TEST_CASE(differences_may_be_beyond_the_range_of_doubles)
{
  const Filter filter = internal::scaled_filter(Bound(CGAL::within_distance(0x1p1022)),
                                                scene_up_to(2, 0x1.8p1023), none);
  const std::array<double, 2> far = {0x1.8p1023, 0x1.8p1023}, back = {-0x1.8p1023, -0x1.8p1023};
  BOOST_CHECK(decision(filter, far, back) == std::optional<bool>(false));
  BOOST_CHECK(decision(filter, far, far) == std::optional<bool>(true));
}

BOOST_AUTO_TEST_SUITE_END()
