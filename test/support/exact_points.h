// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The points of a scene as integers: all coordinates are multiples of one power of two, so after
// scaling by it a comparison of a distance with the radius is a comparison of integers. Nothing is
// rounded anywhere, whatever the exponents.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_EXACT_POINTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_EXACT_POINTS_H

#include "point_scene.h"

#include <boost/multiprecision/gmp.hpp>

namespace test_support {

using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;

inline Rational exact_square(const Radius& radius)
{
  if(!radius.length())
    return Rational(radius.square_text());
  const Rational length(*radius.length());
  return length * length;
}

// A double not below the radius, and at most a few units in the last place above it.
inline double upper_bound(const Radius& radius)
{
  if(radius.length())
    return *radius.length();
  const Rational square = exact_square(radius);
  double bound = std::sqrt(static_cast<double>(square));
  while(Rational(bound) * Rational(bound) < square)
    bound = std::nextafter(bound, std::numeric_limits<double>::infinity());
  return bound;
}

class Exact_points
{
public:
  Exact_points(const Points& points, const Radius& radius)
  {
    const int exponent = common_exponent(points);
    for(const Coordinates& p : points) {
      coordinates_.emplace_back();
      for(double x : p)
        coordinates_.back().push_back(scaled(x, exponent));
    }
    const Rational square = exact_square(radius) * power_of_two(-2 * exponent);
    threshold_ = numerator(square) / denominator(square);
    threshold_is_exact_ = denominator(square) == 1;
  }

  std::size_t size() const { return coordinates_.size(); }

  // Negative, zero or positive as points i and j are closer than, at or beyond the radius.
  int compare_distance_with_radius(std::size_t i, std::size_t j) const
  {
    const std::vector<Integer>& p = coordinates_[i];
    const std::vector<Integer>& q = coordinates_[j];
    Integer sum = 0, difference;
    for(std::size_t axis = 0; axis < p.size(); ++axis) {
      difference = p[axis] - q[axis];
      sum += difference * difference;
    }
    const int sign = sum.compare(threshold_);
    return sign == 0 && !threshold_is_exact_ ? -1 : sign;
  }

  bool are_within_radius(std::size_t i, std::size_t j) const
  {
    return compare_distance_with_radius(i, j) <= 0;
  }

private:
  // The exponent of the last bit of a 53-bit significand of x; it may be above the lowest bit set.
  static int last_bit_exponent(double x)
  {
    int exponent;
    std::frexp(x, &exponent);
    return exponent - std::numeric_limits<double>::digits;
  }

  static int common_exponent(const Points& points)
  {
    int exponent = std::numeric_limits<double>::max_exponent;
    for(const Coordinates& p : points)
      for(double x : p)
        if(x != 0)
          exponent = (std::min)(exponent, last_bit_exponent(x));
    return exponent;
  }

  static Integer scaled(double x, int exponent)
  {
    if(x == 0)
      return 0;
    int own_exponent;
    const double fraction = std::frexp(x, &own_exponent);
    const int digits = std::numeric_limits<double>::digits;
    const Integer significand(std::ldexp(fraction, digits));
    const Integer magnitude = abs(significand) << (own_exponent - digits - exponent);
    return x < 0 ? Integer(-magnitude) : magnitude;
  }

  static Rational power_of_two(int exponent)
  {
    const Integer power = Integer(1) << std::abs(exponent);
    return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
  }

  std::vector<std::vector<Integer>> coordinates_;
  Integer threshold_;       // the squared radius in scaled units, rounded down
  bool threshold_is_exact_; // otherwise no distance can equal the radius
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_EXACT_POINTS_H
