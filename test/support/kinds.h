// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects of all kinds, made of integers times one unit, and their distances.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_KINDS_H
#define THICK_INTERSECTION_TEST_SUPPORT_KINDS_H

#include "distance_oracle.h"

namespace test_support {

// Boxes of exact numbers and boxes of doubles are two kinds.
enum class Kind { POINT, SEGMENT, TRIANGLE, BOX, BBOX, BALL, TETRAHEDRON };
constexpr std::size_t number_of_kinds(int dimension) { return dimension == 2 ? 6 : 7; }

inline bool is_box(Kind kind) { return kind == Kind::BOX || kind == Kind::BBOX; }

// The points that an object is made of. A box is made of two opposite corners.
inline std::size_t points_of(Kind kind)
{
  return kind == Kind::TETRAHEDRON               ? 4
         : kind == Kind::TRIANGLE                ? 3
         : kind == Kind::SEGMENT || is_box(kind) ? 2
                                                 : 1;
}

// In the plane, the last coordinate is zero.
using Place = Hull_vector<std::int64_t>;

struct Kind_object
{
  Kind kind;
  std::vector<Place> points;
  std::int64_t radius; // by which it is thickened
};

struct Kind_scene
{
  int dimension;
  int exponent; // the unit is 2^exponent
  std::vector<Kind_object> objects;
  Rational_bound bound;
};

inline std::ostream& operator<<(std::ostream& out, const Kind_object& object)
{
  const char* names[] = {"point", "segment", "triangle", "box", "bbox", "ball", "tetrahedron"};
  out << names[static_cast<std::size_t>(object.kind)];
  for(const Place& p : object.points)
    out << " (" << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return out << " radius " << object.radius;
}

inline std::ostream& operator<<(std::ostream& out, const Rational_bound& bound)
{
  return out << (bound.is_open ? "open " : "") << (bound.is_squared ? "square of " : "")
             << "distance " << bound.value;
}

template <class Integer>
Hull_vectors<Integer> hull_of(const Kind_object& object)
{
  Hull_vectors<Integer> hull;
  if(!is_box(object.kind))
    for(const Place& p : object.points)
      hull.push_back({Integer(p[0]), Integer(p[1]), Integer(p[2])});
  else
    for(std::size_t k = 0; k < 8; ++k)
      hull.push_back({Integer(object.points[k & 1][0]), Integer(object.points[k >> 1 & 1][1]),
                      Integer(object.points[k >> 2 & 1][2])});
  std::sort(hull.begin(), hull.end());
  hull.erase(std::unique(hull.begin(), hull.end()), hull.end());
  return hull;
}

// Without the radii.
inline Rational squared_distance(const Kind_object& a, const Kind_object& b)
{
  const std::int64_t limit = 1 << 7; // for differences up to 2^8
  const auto is_small = [=](const Kind_object& object) {
    return std::all_of(object.points.begin(), object.points.end(), [=](const Place& p) {
      return std::all_of(p.begin(), p.end(), [=](auto x) { return -limit < x && x < limit; });
    });
  };
  if(is_small(a) && is_small(b))
    return squared_distance_of_hulls(hull_of<std::int64_t>(a), hull_of<std::int64_t>(b));
  using boost::multiprecision::mpz_int;
  return squared_distance_of_hulls(hull_of<mpz_int>(a), hull_of<mpz_int>(b));
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_KINDS_H
