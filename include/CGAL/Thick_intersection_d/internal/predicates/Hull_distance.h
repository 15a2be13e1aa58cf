// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_DISTANCE_H

// A filter in doubles for the distance of two hulls: the algorithm of Gilbert, Johnson and Keerthi
// (IEEE Journal of Robotics and Automation 4, 1988), which stops as soon as it knows the answer.
//
// The distance is that of the origin from C, which is all differences of a point of the second hull
// and a point of the first. For any vector v, the least product of v and a vertex of C, over |v|,
// is at most the distance. If v is in C, |v| is at least the distance. So two numbers certify an
// answer, however v was found: the algorithm may lose its way by rounding, but not lie.
//
// Let M be the largest absolute value of a coordinate, after the first vertex was subtracted from
// all, and w = 2^-52, which bounds the error of an operation in every rounding mode. Coordinates
// are off by 2wM then, those of C by 5wM, and a product of v and one of them by less than 24wM|v|:
// 3 coordinates, each with the errors of the difference, of the product and of two sums. A point of
// C is computed as a mean of up to four vertices with weights that are not negative: four products,
// four sums and a quotient of numbers up to 2M make less than 32wM along each axis, and less than
// 56wM in all. A root and the sum of a bound and the slack add less than 8wM. The slack is 128wM.

#include <CGAL/Uncertain.h>

#include <CGAL/Thick_intersection_d/internal/predicates/Hull.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_simplex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension, std::size_t Size_a, std::size_t Size_b>
class Hull_distance
{
  using Vector = std::array<double, Dimension>;

public:
  Hull_distance(const Hull<Dimension, Size_a>& a, const Hull<Dimension, Size_b>& b)
  {
    Vector extents = {};
    const auto move = [&, origin = a.vertices[0]](const auto& from, auto& to) {
      for(std::size_t k = 0; k < from.size(); ++k) {
        to[k] = vector_difference(from[k], origin);
        for(std::size_t axis = 0; axis < Dimension; ++axis)
          extents[axis] = (std::max)(extents[axis], std::fabs(to[k][axis]));
      }
    };
    move(a.vertices, a_);
    move(b.vertices, b_);
    largest_ = *std::max_element(extents.begin(), extents.end()) + a.error + b.error;
    slack_ = 0x1p-45 * largest_ + 4 * (a.error + b.error);
  }

  // Returns whether the distance is within a bound that is between two doubles, or nothing if that
  // is not known.
  Uncertain<bool> is_within(double low, double high)
  {
    if(!(largest_ >= 0x1p-100 && largest_ <= 0x1p200))
      return Uncertain<bool>::indeterminate();
    const Squares squares = {low > slack_ ? squared(low - slack_) * (1 - 0x1p-48) : -1,
                             squared(high + slack_) * (1 + 0x1p-48)};
    return search(squares);
  }

  // After is_within() has not known: which vertices of the hulls may be in the faces that are next
  // to each other, if the hulls are apart.
  //
  // Let v* be the point of C next to the origin, and m the least product with v, a point of C. Then
  // |v - v*|^2 <= |v|^2 - v v* <= |v|^2 - m, because |v*|^2 <= v v*. The vertices of the nearest
  // faces have the least or the largest product with v* in their hulls, so their products with v
  // differ from that by at most twice |v - v*| times the length of a vertex.
  bool may_be_nearest_of_a(std::size_t k) const
  {
    return !(levels_of_a_[k] < most_ - tolerance());
  }
  bool may_be_nearest_of_b(std::size_t k) const
  {
    return !(levels_of_b_[k] > least_ + tolerance());
  }

private:
  static constexpr int max_steps = 32;

  // The answer is yes for a point of C whose square is at most `near`, and no if the least product
  // with a vector is positive, and its square more than `far` times that of the vector.
  struct Squares
  {
    double near;
    double far;
  };

  static double squared(double x) { return x * x; }

  // Most hulls are told apart by their means, or found near by the two edges that face each other.
  Uncertain<bool> search(const Squares& squares)
  {
    if constexpr(Size_a > 2 || Size_b > 2) {
      look_along(vector_difference(mean_of(b_), mean_of(a_)));
      if(is_beyond(squares.far))
        return false;
    }
    const auto [p, q] = least_two(levels_of_a_, -1);
    const auto [r, s] = least_two(levels_of_b_, 1);
    Uncertain<bool> answer = ask_point(nearest_of_segments(a_[p], a_[q], b_[r], b_[s]), squares);
    Hull_simplex<Dimension> simplex;
    for(int step = 0; step < max_steps && !is_certain(answer); ++step) {
      const bool has_origin = simplex.size() > Dimension;
      if(has_origin || simplex.has(next_vertex_))
        break;
      simplex.add(next_vertex_);
      answer = ask_point(simplex.nearest(), squares);
    }
    return answer;
  }

  // Returns the places of the two least levels, times a sign. A single one is both.
  template <std::size_t Size>
  static std::pair<std::size_t, std::size_t> least_two(const std::array<double, Size>& levels,
                                                       double sign)
  {
    if constexpr(Size <= 2)
      return {0, Size - 1};
    std::size_t first = 0, second = 1;
    if(sign * levels[1] < sign * levels[0])
      std::swap(first, second);
    for(std::size_t k = 2; k < Size; ++k) {
      const bool is_least = sign * levels[k] < sign * levels[first];
      const bool is_less = sign * levels[k] < sign * levels[second];
      second = is_least ? first : is_less ? k : second;
      first = is_least ? k : first;
    }
    return {first, second};
  }

  // The answer that a point of C tells, or nothing.
  Uncertain<bool> ask_point(const Vector& v, const Squares& squares)
  {
    if(dot_product(v, v) <= squares.near)
      return true;
    next_vertex_ = look_along(v);
    if(is_beyond(squares.far))
      return false;
    return Uncertain<bool>::indeterminate();
  }

  // The constant makes up for underflow, where |v| is far less than the slack.
  bool is_beyond(double far) const
  {
    return least_product_ > 0 && squared(least_product_) > far * square_ + 0x1p-900;
  }

  template <std::size_t Size>
  static Vector mean_of(const std::array<Vector, Size>& vertices)
  {
    Vector mean = {};
    for(const Vector& vertex : vertices)
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        mean[axis] += vertex[axis] * (1. / Size);
    return mean;
  }

  // If no point of C is known, all levels are zero: the tolerance leaves out none.
  double tolerance() const
  {
    const double length = std::sqrt(square_);
    const double gap = (std::max)(square_ - least_product_, 0.) + 8 * slack_ * length;
    return 4 * largest_ * (std::sqrt(gap) + 2 * slack_) + slack_ * length;
  }

  // Finds the vertex of C with the least product with v.
  Vector look_along(const Vector& v)
  {
    square_ = dot_product(v, v);
    std::size_t of_a = 0, of_b = 0;
    for(std::size_t k = 0; k < Size_a; ++k) {
      levels_of_a_[k] = dot_product(a_[k], v);
      of_a = levels_of_a_[k] > levels_of_a_[of_a] ? k : of_a;
    }
    for(std::size_t k = 0; k < Size_b; ++k) {
      levels_of_b_[k] = dot_product(b_[k], v);
      of_b = levels_of_b_[k] < levels_of_b_[of_b] ? k : of_b;
    }
    most_ = levels_of_a_[of_a];
    least_ = levels_of_b_[of_b];
    least_product_ = least_ - most_;
    return vector_difference(b_[of_b], a_[of_a]);
  }

  std::array<Vector, Size_a> a_; // with the first vertex at the origin
  std::array<Vector, Size_b> b_;
  double largest_; // absolute value of a coordinate
  double slack_;
  Vector next_vertex_;
  double square_ = 0, least_product_ = 0; // of the last v
  std::array<double, Size_a> levels_of_a_ = {}; // products with v
  std::array<double, Size_b> levels_of_b_ = {};
  double most_ = 0, least_ = 0; // of them
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_DISTANCE_H
