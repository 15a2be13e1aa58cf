// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The squared distance of two convex sets, given by their vertices, as a rational number: points,
// segments, triangles, boxes and tetrahedra, degenerate or not.
//
// It is that of the origin to the convex hull of the differences of their vertices. If the origin
// is not in the hull, the nearest point x of the hull is on its boundary, so it is the foot of the
// origin on a simplex of at most three differences. A point x of the hull is the nearest one iff
// <x, d> >= <x, x> for each difference d. So each answer is proven here, whatever led to it.
//
// A ball is the set of its center, and has a radius besides.
//
// This shares nothing with the predicates of the package. `Integer` has to hold 600 times
// the sixth power of a difference: std::int64_t up to 2^8, otherwise a type without limits.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DISTANCE_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_DISTANCE_ORACLE_H

#include "hull_oracle.h"

#include <boost/multiprecision/gmp.hpp>

namespace test_support {

// The point `multiple` / `factor`, which is the foot of the origin on a line or plane, or a point.
template <class Integer>
struct Foot
{
  Hull_vector<Integer> multiple;
  Integer factor; // positive
};

// Returns nothing if the foot is not in the segment, or if there is no line.
template <class Integer>
std::optional<Foot<Integer>> foot_on_segment(const Hull_vector<Integer>& p,
                                             const Hull_vector<Integer>& q)
{
  const Hull_vector<Integer> edge = difference(q, p);
  const Integer square = dot(edge, edge), along = -dot(p, edge);
  if(square == 0 || along < 0 || along > square)
    return std::nullopt;
  Foot<Integer> foot = {{}, square};
  for(std::size_t axis = 0; axis < 3; ++axis)
    foot.multiple[axis] = square * p[axis] + along * edge[axis];
  return foot;
}

// Returns nothing if the foot is not in the triangle, or if there is no plane.
template <class Integer>
std::optional<Foot<Integer>> foot_on_triangle(const Hull_vector<Integer>& p,
                                              const Hull_vector<Integer>& q,
                                              const Hull_vector<Integer>& r)
{
  const Hull_vector<Integer> normal = cross(difference(q, p), difference(r, p));
  if(is_null(normal) || dot(normal, cross(p, q)) < 0 || dot(normal, cross(q, r)) < 0
     || dot(normal, cross(r, p)) < 0)
    return std::nullopt;
  const Integer height = dot(normal, p);
  Foot<Integer> foot = {{}, dot(normal, normal)};
  for(std::size_t axis = 0; axis < 3; ++axis)
    foot.multiple[axis] = height * normal[axis];
  return foot;
}

// Whether no point of the hull of `vectors` is closer to the origin than a point of it, which is a
// foot on a simplex that has the vertex p.
template <class Integer>
bool is_nearest(const Foot<Integer>& foot, const Hull_vector<Integer>& p,
                const Hull_vectors<Integer>& vectors)
{
  const Integer at_foot = dot(foot.multiple, p);
  return std::all_of(vectors.begin(), vectors.end(), [&](const Hull_vector<Integer>& d) {
    return dot(foot.multiple, d) >= at_foot;
  });
}

// Calls f(foot, p) for the feet of the origin on all simplices, each with a vertex p of it, until
// f returns true.
template <class Integer, class Function>
bool is_any_foot(const Hull_vectors<Integer>& vectors, const Function& f)
{
  for(auto p = vectors.begin(); p != vectors.end(); ++p)
    if(f(Foot<Integer>{*p, 1}, *p))
      return true;
  for(auto p = vectors.begin(); p != vectors.end(); ++p)
    for(auto q = vectors.begin(); q != p; ++q)
      if(const auto foot = foot_on_segment(*p, *q); foot && f(*foot, *p))
        return true;
  for(auto p = vectors.begin(); p != vectors.end(); ++p)
    for(auto q = vectors.begin(); q != p; ++q)
      for(auto r = vectors.begin(); r != q; ++r)
        if(const auto foot = foot_on_triangle(*p, *q, *r); foot && f(*foot, *p))
          return true;
  return false;
}

using Rational = boost::multiprecision::mpq_rational;

template <class Integer>
Rational squared_distance_of_hulls(const Hull_vectors<Integer>& a,
                                   const Hull_vectors<Integer>& b)
{
  using boost::multiprecision::mpz_int;
  Rational square = 0;
  const Hull_vectors<Integer> differences = differences_of(a, b);
  if(is_origin_in_hull(differences))
    return square;
  const bool is_found
    = is_any_foot(differences, [&](const Foot<Integer>& foot, const Hull_vector<Integer>& p) {
        if(!is_nearest(foot, p, differences))
          return false;
        square.assign(mpz_int(dot(foot.multiple, p)));
        square /= mpz_int(foot.factor);
        return true;
      });
  if(!is_found || square == 0)
    throw std::logic_error("The oracles of intersections and of distances contradict each other.");
  return square;
}

// The same of hulls whose products 64 bits do not hold.
inline Rational squared_distance_of_long_hulls(const Hull_vectors<std::int64_t>& a,
                                               const Hull_vectors<std::int64_t>& b)
{
  using boost::multiprecision::mpz_int;
  const auto lengthened = [](const Hull_vectors<std::int64_t>& vertices) {
    Hull_vectors<mpz_int> result;
    for(const auto& p : vertices)
      result.push_back({mpz_int(p[0]), mpz_int(p[1]), mpz_int(p[2])});
    return result;
  };
  return squared_distance_of_hulls(lengthened(a), lengthened(b));
}

// What "near" means: a distance, or a squared one.
struct Rational_bound
{
  Rational value;
  bool is_squared;
  bool is_open;
};

// The sign of the distance of two sets minus the sum of a bound and of radii, where `square` is the
// squared distance. Squares are compared, so no root is taken.
inline int compare_distance(const Rational& square, const Rational_bound& bound,
                            const Rational& radii)
{
  if(!bound.is_squared) {
    const Rational sum = bound.value + radii;
    return square.compare(Rational(sum * sum));
  }
  // (root of the bound + radii)^2 is the bound, the square of the radii, and twice a product.
  const Rational rest = square - bound.value - radii * radii;
  return rest < 0 ? -1 : Rational(rest * rest).compare(Rational(4 * bound.value * radii * radii));
}

// Whether two sets are near that have the squared distance `square` without their radii. If they
// intersect, their distance is zero, which is not less than zero.
inline bool are_near(const Rational& square, const Rational& radii, const Rational_bound& bound)
{
  const int sign = compare_distance(square, bound, radii);
  return bound.is_open ? sign < 0 && bound.value > 0 : sign <= 0;
}

// Whether two sets intersect, of which balls have these radii.
inline bool do_intersect(const Rational& square, const Rational& radii)
{
  return are_near(square, radii, {0, false, false});
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DISTANCE_ORACLE_H
