// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair in exact integers: every double is a multiple of 2^-1074. Points are gone
// through in order along axis 0, and each is compared with all before it that are not farther along
// that axis than the least distance so far. Nothing is rounded.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CLOSEST_PAIR_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_CLOSEST_PAIR_ORACLE_H

#include "pairs.h"
#include "point_scene.h"

#include <boost/multiprecision/gmp.hpp>

namespace test_support {

using Scaled_integer = boost::multiprecision::mpz_int;
using Scaled_points = std::vector<std::vector<Scaled_integer>>;

struct Closest
{
  Pair pair; // the lexicographically smallest of those at least distance
  Scaled_integer square;
};

inline Scaled_points scaled_points(const Points& points)
{
  using Rational = boost::multiprecision::mpq_rational;
  const Rational scale(Scaled_integer(1) << 1074);
  Scaled_points scaled;
  for(const Coordinates& c : points) {
    scaled.emplace_back();
    for(const double x : c)
      scaled.back().push_back(numerator(Rational(Rational(x) * scale)));
  }
  return scaled;
}

inline Scaled_integer squared_distance(const std::vector<Scaled_integer>& p,
                                       const std::vector<Scaled_integer>& q)
{
  Scaled_integer sum = 0;
  for(std::size_t axis = 0; axis < p.size(); ++axis)
    sum += (p[axis] - q[axis]) * (p[axis] - q[axis]);
  return sum;
}

// Of two points or more.
inline Closest closest_of_integers(const Scaled_points& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return points[i][0] < points[j][0];
  });
  std::optional<Closest> closest;
  for(std::size_t a = 0; a < order.size(); ++a)
    for(std::size_t b = a; b-- > 0;) {
      const Scaled_integer difference = points[order[a]][0] - points[order[b]][0];
      if(closest && difference * difference > closest->square)
        break;
      const Scaled_integer square = squared_distance(points[order[a]], points[order[b]]);
      const Pair pair = std::minmax(order[a], order[b]);
      if(!closest || square < closest->square
         || (square == closest->square && pair < closest->pair))
        closest = Closest{pair, square};
    }
  return *closest;
}

inline Closest closest_of_doubles(const Points& points)
{
  return closest_of_integers(scaled_points(points));
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CLOSEST_PAIR_ORACLE_H
