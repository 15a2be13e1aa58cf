// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the lanes make of narrow coordinates is true of the points, which is checked with exact
// numbers: no pair is certainly near or far that is not so, and few pairs are left.

#include "support/rounding_mode.h"
#include "support/squared_distance.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Narrow_scale.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Point_reader.h>

BOOST_AUTO_TEST_SUITE(Narrow_scale)

using namespace test_support;
using Rational = CGAL::Exact_rational;

template <int Dimension>
using Box = std::array<internal::Interval, Dimension>;
template <int Dimension>
using Coordinates_of = std::array<double, Dimension>;

template <int Dimension>
Box<Dimension> cube(double low, double high)
{
  Box<Dimension> box;
  box.fill({low, high});
  return box;
}

// The narrow coordinate of a double along an axis.
template <int Dimension>
std::int32_t narrow(const internal::Narrow_scale<Dimension>& scale, double x, std::size_t axis)
{
  const internal::To_number<Dimension, std::int32_t> to_number = {1, scale.low(), scale.steps()};
  return to_number(x, static_cast<int>(axis));
}

// What lanes make of two points: certainly near, certainly not, or undecided.
enum class Answer { NEAR, FAR, UNDECIDED };

template <int Dimension>
Answer answer_of(const internal::Narrow_scale<Dimension>& scale,
                 const Coordinates_of<Dimension>& p, const Coordinates_of<Dimension>& q)
{
  float sum = 0;
  for(std::size_t axis = 0; axis < Dimension; ++axis) {
    const std::int32_t gap = narrow(scale, p[axis], axis) - narrow(scale, q[axis], axis);
    if(axis == 0 && std::abs(gap) > scale.question().reach)
      return Answer::FAR;
    sum += static_cast<float>(gap) * static_cast<float>(gap);
  }
  return sum <= scale.question().inside    ? Answer::NEAR
         : sum <= scale.question().outside ? Answer::UNDECIDED
                                           : Answer::FAR;
}

template <int Dimension>
void check_question(const internal::Narrow_scale<Dimension>& scale, const Box<Dimension>& box)
{
  BOOST_CHECK_LE(scale.question().reach, internal::max_narrow_reach);
  BOOST_CHECK_LE(scale.question().inside, scale.question().outside);
  for(std::size_t axis = 0; axis < Dimension; ++axis) {
    BOOST_CHECK_EQUAL(narrow(scale, box[axis].low, axis), 0);
    BOOST_CHECK_LE(narrow(scale, box[axis].high, axis), internal::max_narrow_coordinate);
  }
}

// A number of a box, next to one that the scale rounds, on either side of it.
double number_near(const internal::Interval& box, double unit, Random& random)
{
  const double x = box.low + std::floor(random.uniform() * box.length() / unit) * unit;
  const double bit = std::ldexp(1., std::ilogb((std::max)(std::fabs(x), unit)) - 52);
  const double near = x + (static_cast<double>(random.below(3)) - 1) * bit;
  return (std::min)((std::max)(near, box.low), box.high);
}

// Returns a point about `length` from p, in the direction of the other half of the box.
template <int Dimension>
Coordinates_of<Dimension> point_at(double length, const Coordinates_of<Dimension>& p,
                                   const Box<Dimension>& box, Random& random)
{
  Coordinates_of<Dimension> q;
  double square = 0;
  for(std::size_t axis = 0; axis < Dimension; ++axis) {
    q[axis] = axis > 0 && random.below(3) == 0 ? 0 : 1 - random.uniform();
    square += q[axis] * q[axis];
  }
  for(std::size_t axis = 0; axis < Dimension; ++axis) {
    const double step = q[axis] * length / std::sqrt(square);
    q[axis] = p[axis] - box[axis].low > box[axis].length() / 2 ? p[axis] - step : p[axis] + step;
    q[axis] = (std::min)((std::max)(q[axis], box[axis].low), box[axis].high);
  }
  return q;
}

// Pairs of points whose distance is the bound, up to a few units of the scale.
template <int Dimension>
void check_bound(double low, double extent, double r, Random& random)
{
  const Box<Dimension> box = cube<Dimension>(low, low + extent);
  const internal::Narrow_scale<Dimension> scale(
    box, internal::make_distance_filter(r * r * (1 - 0x1p-52), r * r * (1 + 0x1p-52), Dimension));
  BOOST_REQUIRE(scale.is_usable() && !scale.is_exact());
  check_question<Dimension>(scale, box);
  const double unit = r / scale.question().reach; // about that
  const Rational bound(r), most(r + 8 * unit + r * 0x1p-18), least(r - 8 * unit - r * 0x1p-18);
  for(int repetition = 0; repetition < 100; ++repetition) {
    Coordinates_of<Dimension> p;
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      p[axis] = number_near(box[axis], unit, random);
    const double length = r + (random.uniform() - 0.5) * (random.below(2) ? 4 : 100) * unit;
    const Coordinates_of<Dimension> q = point_at<Dimension>(length, p, box, random);
    const Rational square = squared_distance<Rational>(p, q);
    const Answer answer = answer_of<Dimension>(scale, p, q);
    if(square <= bound * bound)
      BOOST_CHECK(answer != Answer::FAR);
    else
      BOOST_CHECK(answer != Answer::NEAR);
    if(square > most * most || square < least * least)
      BOOST_CHECK(answer != Answer::UNDECIDED);
  }
}

// From the longest reach to the shortest one, and with offsets beyond which coordinates have hardly
// more bits than the scale.
template <int Dimension>
void check_bounds()
{
  Random random(Dimension);
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    for(const double r : {1., 0.1, 0x1p-470 / 3, 0x1p450})
      for(const double reaches : {0.9, 1.5, 4., 31.99, 32.01, 1000., 0x1p18, 0x1.fffep20})
        for(const double offset : {0., -0.5, 7.3, 0x1p20})
          BOOST_TEST_CONTEXT("mode " << mode << ", r = " << r << ", extent " << reaches
                                     << " r, offset " << offset << " extents")
          {
            check_bound<Dimension>(offset * reaches * r, reaches * r, r, random);
          }
  }
}

BOOST_AUTO_TEST_CASE(rounded_coordinates_decide_all_but_near_ties_2) { check_bounds<2>(); }
BOOST_AUTO_TEST_CASE(rounded_coordinates_decide_all_but_near_ties_3) { check_bounds<3>(); }

template <int Dimension>
bool is_usable(double extent, double square)
{
  const internal::Narrow_scale<Dimension> scale(
    cube<Dimension>(0, extent), internal::make_distance_filter(square, square, Dimension));
  return scale.is_usable();
}

BOOST_AUTO_TEST_CASE(rounded_coordinates_have_limits)
{
  BOOST_CHECK(!internal::Narrow_scale<2>().is_usable());
  BOOST_CHECK(is_usable<2>(0x1p21 * (1 - 0x1p-16), 1)); // in reaches, of which 512 units are left
  BOOST_CHECK(!is_usable<2>(0x1p21, 1));
  BOOST_CHECK(is_usable<3>(0x1p21 * (1 - 0x1p-16) * 0x1p-470, 0x1p-940));
  BOOST_CHECK(!is_usable<3>(0x1p21 * 0x1p-470, 0x1p-940));
  for(const double extent : {0., 5e-324, 1e-310, infinity}) // the scale is no normal number
    BOOST_CHECK(!is_usable<2>(extent, 1));
  BOOST_CHECK(is_usable<2>(0x1p-1022, 1)); // shorter than the bound
  for(const double square : {0., 5e-324, 0x1p-970, 0x1p1021, infinity}) // the filter is too weak
    BOOST_CHECK(!is_usable<2>(1, square));
  BOOST_CHECK(!internal::Narrow_scale<2>(cube<2>(0, 1), internal::Distance_filter()).is_usable());
  BOOST_CHECK(
    !internal::Narrow_scale<2>(cube<2>(0, 1), internal::Distance_filter{infinity, infinity})
       .is_usable());
}

// The scale of a grid whose unit is 2^e.
template <int Dimension>
internal::Narrow_scale<Dimension> scale_of_grid(double extent, int exponent, double steps,
                                                std::uint64_t max_square)
{
  return {cube<Dimension>(std::ldexp(-3, exponent), std::ldexp(extent - 3, exponent)), exponent,
          steps, max_square + 1};
}

// Pairs with about the largest number of squared steps. Beyond 2^24, floats do not decide all.
template <int Dimension>
void check_grid(double extent, int exponent, double steps, std::uint64_t max_square, Random& random)
{
  const auto scale = scale_of_grid<Dimension>(extent, exponent, steps, max_square);
  BOOST_REQUIRE(scale.is_usable() && scale.is_exact());
  const Box<Dimension> box
    = cube<Dimension>(std::ldexp(-3, exponent), std::ldexp(extent - 3, exponent));
  check_question<Dimension>(scale, box);
  BOOST_CHECK_EQUAL(narrow(scale, box[0].high, 0), extent);
  for(int repetition = 0; repetition < 100; ++repetition) {
    const auto b = static_cast<double>(random.below(static_cast<std::size_t>(steps) + 1));
    const double more = static_cast<double>(random.below(4)) - 1;
    const double rest = (std::max)(static_cast<double>(max_square) - b * b, 0.);
    const double a = (std::max)(std::floor(std::sqrt(rest)) + more, 0.);
    const Coordinates_of<Dimension> p = {box[0].low, box[1].low};
    Coordinates_of<Dimension> q = p;
    q[0] += std::ldexp(a, exponent);
    q[1] += std::ldexp(b, exponent);
    const auto square = static_cast<std::uint64_t>(a * a + b * b);
    const Answer answer = answer_of<Dimension>(scale, p, q);
    BOOST_CHECK_EQUAL(scale.holds_for(square), square <= max_square);
    BOOST_CHECK(answer != (square <= max_square ? Answer::FAR : Answer::NEAR));
    BOOST_CHECK(answer != Answer::UNDECIDED || max_square >= std::uint64_t(1) << 24);
  }
}

BOOST_AUTO_TEST_CASE(coordinates_of_a_grid_decide_all)
{
  Random random(1);
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    for(const int exponent : {0, -30, 70, -1022, 992})
      for(const double steps : {1., 2., 5., 1000., 4095., 4096., 4097., 0x1p20, 0x1p24 - 1, 0x1p24})
        for(const std::uint64_t less : {0, 1}) {
          const auto square = static_cast<std::uint64_t>(steps * steps) - less;
          BOOST_TEST_CONTEXT("mode " << mode << ", grid 2^" << exponent << ", " << square)
          {
            check_grid<2>(0x1p25, exponent, steps, square, random);
            check_grid<3>(0x1p30, exponent, steps, square, random);
          }
        }
  }
}

BOOST_AUTO_TEST_CASE(coordinates_of_a_grid_have_limits)
{
  BOOST_CHECK(scale_of_grid<2>(0x1p30, 0, 0x1p24, 1).is_usable());
  BOOST_CHECK(!scale_of_grid<2>(0x1p30 + 1, 0, 0x1p24, 1).is_usable());
  BOOST_CHECK(!scale_of_grid<2>(0x1p30, 0, 0x1p24 + 1, 1).is_usable());
  BOOST_CHECK(scale_of_grid<2>(0, 0, 0, 0).is_usable());
  BOOST_CHECK(!scale_of_grid<2>(1, 0, 1, std::uint64_t(0) - 1).is_usable()); // nothing is near
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    for(const int exponent : {-1074, -1024, 1023}) // the scale is no normal number
      BOOST_CHECK(!scale_of_grid<2>(0, exponent, 1, 1).is_usable());
    const Box<2> box = cube<2>(-0x1.8p1023, 0x1.8p1023); // differences overflow
    BOOST_CHECK(!internal::Narrow_scale<2>(box, 1013, 1, 1).is_usable());
  }
}

BOOST_AUTO_TEST_SUITE_END()
