// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_EXACT_HULL_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_EXACT_HULL_DISTANCE_H

// Compares the distance of two hulls with a bound, in exact numbers.
//
// The two points of hulls that are apart and next to each other lie in the interior of a face of
// each: a vertex, an edge or a facet. There, their difference is perpendicular to both faces. So
// the distance is the least one of a vertex and a vertex, an edge or a triangle, and of an edge and
// an edge, where the feet of the perpendicular are inside. Any two vertices make a segment of the
// hull, and any three a triangle, so these may be more than the faces.
//
// Each squared distance is a quotient. In the coordinates, its parts have degree 2 and 0 for two
// vertices; 4 and 2 for an edge; 6 and 4 for a triangle, or for two edges in space. A bound on the
// distance adds degree 2 to the second. Whether a foot is inside has degree 4.

#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Number, std::size_t N>
using Exact_vector = std::array<Number, N>;

template <class Number>
Exact_vector<Number, 3> exact_normal(const Exact_vector<Number, 3>& u,
                                     const Exact_vector<Number, 3>& v)
{
  Exact_vector<Number, 3> n;
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = Number(u[j] * v[k] - u[k] * v[j]);
  }
  return n;
}

// `Within` is asked whether a squared distance n / d, given as n and d > 0, is within the bound.
template <class Number, std::size_t N, class Within>
class Exact_hull_distance
{
  using Vector = Exact_vector<Number, N>;
  using Vertices = std::vector<Vector>;

public:
  explicit Exact_hull_distance(const Within& within) : within_(within) {}

  // Whether hulls that are apart are within the bound. Their vertices may be those of the faces
  // that are next to each other.
  bool operator()(const Vertices& a, const Vertices& b) const
  {
    for(const Vector& p : a)
      for(const Vector& q : b)
        if(within_(square(vector_difference(p, q)), Number(1)))
          return true;
    if(is_any_near_edge(a, b) || is_any_near_edge(b, a))
      return true;
    if constexpr(N == 3)
      return is_any_near_triangle(a, b) || is_any_near_triangle(b, a) || are_any_edges_near(a, b);
    else
      return false;
  }

private:
  static Number square(const Vector& v) { return dot_product(v, v); }

  // Calls task(p, q) for the edges, until it returns true.
  template <class Task>
  static bool is_any_edge(const Vertices& vertices, const Task& task)
  {
    for(std::size_t i = 0; i < vertices.size(); ++i)
      for(std::size_t j = i + 1; j < vertices.size(); ++j)
        if(task(vertices[i], vertices[j]))
          return true;
    return false;
  }

  bool is_any_near_edge(const Vertices& points, const Vertices& vertices) const
  {
    return is_any_edge(vertices, [&](const Vector& q, const Vector& r) {
      for(const Vector& p : points)
        if(is_near_edge(p, q, r))
          return true;
      return false;
    });
  }

  bool is_near_edge(const Vector& p, const Vector& q, const Vector& r) const
  {
    const Vector edge = vector_difference(r, q), to_p = vector_difference(p, q);
    const Number length = square(edge), along = dot_product(edge, to_p);
    return along > Number(0) && along < length
           && within_(Number(square(to_p) * length - along * along), length);
  }

  bool is_any_near_triangle(const Vertices& points, const Vertices& vertices) const
  {
    for(std::size_t k = 2; k < vertices.size(); ++k)
      for(std::size_t j = 1; j < k; ++j)
        for(std::size_t i = 0; i < j; ++i)
          for(const Vector& p : points)
            if(is_near_triangle(p, {vertices[i], vertices[j], vertices[k]}))
              return true;
    return false;
  }

  bool is_near_triangle(const Vector& p, const std::array<Vector, 3>& triangle) const
  {
    const Vector normal = exact_normal(vector_difference(triangle[1], triangle[0]),
                                       vector_difference(triangle[2], triangle[0]));
    const Number length = square(normal);
    if(length == Number(0))
      return false;
    for(std::size_t k = 0; k < 3; ++k) {
      const Vector inwards
        = exact_normal(normal, vector_difference(triangle[(k + 1) % 3], triangle[k]));
      if(dot_product(inwards, vector_difference(p, triangle[k])) < Number(0))
        return false;
    }
    const Number height = dot_product(normal, vector_difference(p, triangle[0]));
    return within_(Number(height * height), length);
  }

  bool are_any_edges_near(const Vertices& a, const Vertices& b) const
  {
    return is_any_edge(a, [&](const Vector& p, const Vector& q) {
      return is_any_edge(b, [&](const Vector& r, const Vector& s) {
        return are_edges_near(p, vector_difference(q, p), r, vector_difference(s, r));
      });
    });
  }

  // The feet are p + x u and q + y v, and their difference is along the normal. So both products
  // below have the factor |normal|^2, of x and of y.
  bool are_edges_near(const Vector& p, const Vector& u, const Vector& q, const Vector& v) const
  {
    const Vector normal = exact_normal(u, v), from_p_to_q = vector_difference(q, p);
    const Number length = square(normal);
    const Number x = dot_product(exact_normal(from_p_to_q, v), normal);
    const Number y = dot_product(exact_normal(from_p_to_q, u), normal);
    if(length == Number(0) || x < Number(0) || x > length || y < Number(0) || y > length)
      return false;
    const Number height = dot_product(normal, from_p_to_q);
    return within_(Number(height * height), length);
  }

  const Within& within_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_EXACT_HULL_DISTANCE_H
