// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether two convex sets intersect, given by their vertices: points, segments, triangles, boxes
// and tetrahedra, degenerate or not. They do iff the origin is in the convex hull of the
// differences of their vertices. It is not iff all differences are in an open half-space at the
// origin. If they are, one such half-space is next to a plane that two of them span, or next to a
// line.
//
// This shares nothing with the predicates of the package. `Integer` has to hold products of three
// differences: std::int64_t up to 2^19, and otherwise an integer type without limits.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_HULL_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_HULL_ORACLE_H

#include "standard_library.h"

namespace test_support {

// A point or vector. In the plane, the last coordinate is zero.
template <class Integer>
using Hull_vector = std::array<Integer, 3>;
template <class Integer>
using Hull_vectors = std::vector<Hull_vector<Integer>>;

template <class Integer>
Hull_vector<Integer> difference(const Hull_vector<Integer>& a, const Hull_vector<Integer>& b)
{
  return {Integer(a[0] - b[0]), Integer(a[1] - b[1]), Integer(a[2] - b[2])};
}

template <class Integer>
Integer dot(const Hull_vector<Integer>& a, const Hull_vector<Integer>& b)
{
  return Integer(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class Integer>
Hull_vector<Integer> cross(const Hull_vector<Integer>& a, const Hull_vector<Integer>& b)
{
  return {Integer(a[1] * b[2] - a[2] * b[1]), Integer(a[2] * b[0] - a[0] * b[2]),
          Integer(a[0] * b[1] - a[1] * b[0])};
}

template <class Integer>
bool is_null(const Hull_vector<Integer>& a)
{
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

// Whether all points are in a hyperplane of the objects that as many points span: two are equal,
// three are on a line, and four are in a plane.
template <class Integer>
bool is_flat(const Hull_vectors<Integer>& points)
{
  const auto from_first = [&](std::size_t k) { return difference(points[k], points[0]); };
  return points.size() == 2   ? is_null(from_first(1))
         : points.size() == 3 ? is_null(cross(from_first(1), from_first(2)))
         : points.size() == 4 ? dot(cross(from_first(1), from_first(2)), from_first(3)) == 0
                              : false;
}

// Whether vectors that are not null are in an open half-plane at the origin. They are in the plane
// with the given normal. Then one of them has all others less than half a turn to its left.
template <class Integer>
bool are_in_half_plane(const Hull_vectors<Integer>& vectors, const Hull_vector<Integer>& normal)
{
  return std::any_of(vectors.begin(), vectors.end(), [&](const auto& u) {
    return std::all_of(vectors.begin(), vectors.end(), [&](const auto& v) {
      const Integer turn = dot(normal, cross(u, v));
      return turn > 0 || (turn == 0 && dot(u, v) > 0);
    });
  });
}

// Whether all vectors are on one side of the plane with the given normal, and those in the plane in
// an open half-plane of it.
template <class Integer>
bool are_beside_plane(const Hull_vectors<Integer>& vectors, const Hull_vector<Integer>& normal)
{
  Hull_vectors<Integer> in_plane;
  for(const Hull_vector<Integer>& v : vectors) {
    const Integer height = dot(normal, v);
    if(height < 0)
      return false;
    if(height == 0)
      in_plane.push_back(v);
  }
  return are_in_half_plane(in_plane, normal);
}

template <class Integer>
bool is_origin_in_hull(const Hull_vectors<Integer>& vectors)
{
  if(std::any_of(vectors.begin(), vectors.end(), is_null<Integer>))
    return true;
  bool are_on_line = true;
  for(const Hull_vector<Integer>& u : vectors)
    for(const Hull_vector<Integer>& v : vectors) {
      const Hull_vector<Integer> normal = cross(u, v);
      if(is_null(normal))
        continue;
      are_on_line = false;
      if(are_beside_plane(vectors, normal))
        return false;
    }
  return !are_on_line || std::any_of(vectors.begin(), vectors.end(), [&](const auto& v) {
    return dot(vectors.front(), v) < 0;
  });
}

// The differences of each vertex of one set and each vertex of another one.
template <class Integer>
Hull_vectors<Integer> differences_of(const Hull_vectors<Integer>& a, const Hull_vectors<Integer>& b)
{
  Hull_vectors<Integer> differences;
  for(const Hull_vector<Integer>& p : a)
    for(const Hull_vector<Integer>& q : b)
      differences.push_back(difference(p, q));
  return differences;
}

template <class Integer>
bool do_hulls_intersect(const Hull_vectors<Integer>& a, const Hull_vectors<Integer>& b)
{
  return is_origin_in_hull(differences_of(a, b));
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_HULL_ORACLE_H
