// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_DISTANCE_H

// The distance of two hulls in doubles: the algorithm of Gilbert, Johnson and Keerthi (IEEE Journal
// of Robotics and Automation 4, 1988), which stops as soon as it knows the answer. The first steps
// are in are_hulls_near.h, which says what C is, what certifies an answer, and why the slack is
// enough.

#include <CGAL/Uncertain.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_simplex.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_hulls_near.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Hull_distance
{
public:
  using Vector = std::array<double, static_cast<std::size_t>(Dimension)>;

  // `v` is a point of C. If numbers are too large or too small for products of four, no point is
  // known: all levels are zero, and no vertex is left out.
  Hull_distance(const Hull<Dimension>& a, const Hull<Dimension>& b, const Vector& v)
    : a_(a), b_(b), largest_(a.error + b.error)
  {
    const Vector origin = a.vertices[0];
    for(Hull<Dimension>* hull : {&a_, &b_})
      for(std::size_t k = 0; k < hull->size; ++k) {
        Vector& vertex = hull->vertices[k];
        vertex = vector_difference(vertex, origin);
        largest_ = larger(largest_, largest_absolute_value(vertex));
      }
    slack_ = 0x1p-45 * largest_ + 4 * (a.error + b.error);
    look_along(is_moderate() ? v : Vector());
  }

  // Returns whether the distance is within a bound that is between two doubles, or nothing if that
  // is not known. Of two segments, `v` has told it.
  Uncertain<bool> is_within(const Interval& reach)
  {
    Uncertain<bool> answer = Uncertain<bool>::indeterminate();
    if((a_.size <= 2 && b_.size <= 2) || !is_moderate())
      return answer;
    Hull_simplex<Dimension> simplex;
    for(int step = 0; step < max_steps && !is_certain(answer); ++step) {
      const bool has_origin = simplex.size() > Dimension;
      if(has_origin || simplex.has(next_vertex_))
        break;
      simplex.add(next_vertex_);
      look_along(simplex.nearest());
      answer = answer_of_point(square_, least_ - most_, largest_, slack_, reach);
    }
    return answer;
  }

  // After is_within() has not known: which vertices of the hulls may be in the faces that are next
  // to each other, if the hulls are apart. Side 0 is hull a, side 1 is hull b.
  //
  // Let v* be the point of C next to the origin, and m the least product with v, a point of C. Then
  // |v - v*|^2 <= |v|^2 - v v* <= |v|^2 - m, because |v*|^2 <= v v*. The vertices of the nearest
  // faces have the least or the largest product with v* in their hulls, so their products with v
  // differ from that by at most twice |v - v*| times the length of a vertex.
  bool may_be_nearest(int side, std::size_t k) const
  {
    return side == 0 ? !(levels_of_a_[k] < most_ - tolerance())
                     : !(levels_of_b_[k] > least_ + tolerance());
  }

  // Returns vertex(k) for the places k of these vertices.
  template <class Vertex_at>
  auto nearest_of(int side, const Vertex_at& vertex) const
  {
    const std::size_t size = side == 0 ? a_.size : b_.size;
    std::vector<std::decay_t<decltype(vertex(size))>> vertices;
    for(std::size_t k = 0; k < size; ++k)
      if(may_be_nearest(side, k))
        vertices.push_back(vertex(k));
    return vertices;
  }

private:
  static constexpr int max_steps = 32;
  using Levels = std::array<double, std::size_t(1) << Dimension>;

  bool is_moderate() const { return largest_ >= 0x1p-100 && largest_ <= 0x1p200; }

  double tolerance() const
  {
    const double length = std::sqrt(square_);
    const double gap = (std::max)(square_ - (least_ - most_), 0.) + 8 * slack_ * length;
    return 4 * largest_ * (std::sqrt(gap) + 2 * slack_) + slack_ * length;
  }

  // Finds the vertex of C with the least product with v.
  void look_along(const Vector& v)
  {
    square_ = dot_product(v, v);
    std::size_t of_a = 0, of_b = 0;
    for(std::size_t k = 0; k < a_.size; ++k) {
      levels_of_a_[k] = dot_product(a_.vertices[k], v);
      of_a = levels_of_a_[k] > levels_of_a_[of_a] ? k : of_a;
    }
    for(std::size_t k = 0; k < b_.size; ++k) {
      levels_of_b_[k] = dot_product(b_.vertices[k], v);
      of_b = levels_of_b_[k] < levels_of_b_[of_b] ? k : of_b;
    }
    most_ = levels_of_a_[of_a];
    least_ = levels_of_b_[of_b];
    next_vertex_ = vector_difference(b_.vertices[of_b], a_.vertices[of_a]);
  }

  Hull<Dimension> a_, b_; // with the first vertex of a at the origin
  double largest_; // absolute value of a coordinate
  double slack_;
  Vector next_vertex_;
  double square_; // of the last v
  Levels levels_of_a_, levels_of_b_; // products with v
  double most_, least_; // of them
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_DISTANCE_H
