// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_HULLS_NEAR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_HULLS_NEAR_H

// A filter in doubles for the distance of two hulls: one or two good guesses at their nearest
// points. Hull_distance.h goes on where these do not tell.
//
// The distance is that of the origin from C, which is all differences of a point of the second hull
// and a point of the first. For any vector v, the least product of v and a vertex of C, over |v|,
// is at most the distance. If v is in C, |v| is at least the distance. So two numbers certify an
// answer, however v was found: rounding may make v a bad guess, but not a wrong one.
//
// Let M be the largest absolute value of a coordinate, after the first vertex was subtracted from
// all, and w = 2^-52, which bounds the error of an operation in every rounding mode.
// - Coordinates are off by wM then, those of C by 4wM, and the least product by less than 18wM|v|:
//   3 coordinates, each with the errors of the difference, of the product and of two sums, for a
//   vertex of either hull.
// - A mean of up to eight vertices is off by less than 8wM along each axis, and the difference of
//   two means by 18wM: 32wM in all.
// - The nearest points of two edges have weights from 0 to 1 + 2w. Differences of vertices, which
//   are up to 2M, are off by 4wM. Products, weights and sums make this less than 34wM along each
//   axis: 59wM in all.
// - The mean of up to four vertices of C in Hull_distance.h is off by less than 56wM.
// - The length of v, its product with the bound, and the sums of both with the slack are off by
//   less than 16wM.
// The slack is 128wM. For two segments, M may be |v| and twice the largest coordinate of their
// vectors: the vector from one first vertex to the other is not longer. The constants 2^-400 and
// 2^-460 make up for underflow. Products of numbers up to 2^400 do not overflow.

#include <CGAL/Uncertain.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_simplex.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// These take no branch.
inline double larger(double x, double y) { return x > y ? x : y; }
inline double lesser(double x, double y) { return x < y ? x : y; }
inline double positive_part(double x) { return .5 * (x + std::fabs(x)); }

template <std::size_t Dimension>
double largest_absolute_value(const std::array<double, Dimension>& v)
{
  double largest = std::fabs(v[0]);
  for(std::size_t i = 1; i < Dimension; ++i)
    largest = larger(largest, std::fabs(v[i]));
  return largest;
}

// What v tells about the bound `reach` on the distance, if v is a point of C with this square and
// this least product. Which answer it is, takes no branch.
inline Uncertain<bool> answer_of_point(double square, double least_product, double largest,
                                       double slack, const Interval& reach)
{
  const double length = std::sqrt(square);
  const bool is_moderate = largest <= 0x1p400;
  const bool is_near = is_moderate & (length + slack <= reach.low);
  const bool is_beyond = is_moderate
                         & (least_product > (reach.high + slack) * (length + 0x1p-460));
  return Uncertain<bool>(is_near, !is_beyond);
}

// The least of the largest coordinates, which makes up for underflow, and for vertices that are
// off: by less than `error`, of either hull.
inline double least_extent(double error) { return larger(0x1p-400, 0x1p48 * error); }

// Hulls of one or two vertices.
template <std::size_t Dimension>
BOOST_FORCEINLINE Uncertain<bool>
are_segments_near(const std::array<double, Dimension>& pq, const std::array<double, Dimension>& rs,
                  const std::array<double, Dimension>& pr, double error, const Interval& reach,
                  std::array<double, Dimension>& v)
{
  v = nearest_of_segments(pq, rs, pr);
  const double square = dot_product(v, v);
  const double least_product = dot_product(v, pr) - (positive_part(-dot_product(v, rs))
                                                     + positive_part(dot_product(v, pq)));
  const double extent = larger(largest_absolute_value(pq), largest_absolute_value(rs));
  const double largest = larger(least_extent(error), 2 * extent) + std::sqrt(square);
  return answer_of_point(square, least_product, largest, 0x1p-45 * largest, reach);
}

// Hulls of which one has three vertices or more.
template <int Dimension, std::size_t Size_a, std::size_t Size_b>
class Hulls_apart
{
  using Vector = std::array<double, Dimension>;

public:
  BOOST_FORCEINLINE Hulls_apart(const Hull<Dimension>& a, const Hull<Dimension>& b)
    : largest_(least_extent(a.error + b.error))
  {
    const Vector origin = a.vertices[0];
    a_[0] = {};
    for_places<Size_a - 1>([&](auto k) { add(a_[k + 1], a.vertices[k + 1], origin); });
    for_places<Size_b>([&](auto k) { add(b_[k], b.vertices[k], origin); });
  }

  BOOST_FORCEINLINE Vector difference_of_means() const
  {
    return vector_difference(mean_of(b_), mean_of(a_));
  }

  // The answer that a point of C tells, or nothing.
  BOOST_FORCEINLINE Uncertain<bool> ask_point(const Vector& v, const Interval& reach)
  {
    for_places<Size_b>([&](auto k) { levels_of_b_[k] = dot_product(b_[k], v); });
    double least = levels_of_b_[0];
    for_places<Size_b>([&](auto k) { least = lesser(least, levels_of_b_[k]); });
    double most = 0;
    levels_of_a_[0] = 0;
    if constexpr(Size_a > 1) {
      for_places<Size_a - 1>([&](auto k) {
        levels_of_a_[k + 1] = dot_product(a_[k + 1], v);
      });
      most = levels_of_a_[1];
      for_places<Size_a - 1>([&](auto k) { most = larger(most, levels_of_a_[k + 1]); });
    }
    return answer_of_point(dot_product(v, v), least - positive_part(most), largest_,
                           0x1p-45 * largest_, reach);
  }

  // Returns the difference of the nearest points of the edges that face each other, as far as the
  // last point tells.
  BOOST_FORCEINLINE Vector difference_of_edges() const
  {
    const auto [p, q] = least_two(levels_of_a_, -1);
    const auto [r, s] = least_two(levels_of_b_, 1);
    return nearest_of_segments(vector_difference(a_[q], a_[p]), vector_difference(b_[s], b_[r]),
                               vector_difference(b_[r], a_[p]));
  }

private:
  BOOST_FORCEINLINE void add(Vector& to, const Vector& vertex, const Vector& origin)
  {
    to = vector_difference(vertex, origin);
    largest_ = larger(largest_, largest_absolute_value(to));
  }

  template <std::size_t Size>
  BOOST_FORCEINLINE static Vector mean_of(const std::array<Vector, Size>& vertices)
  {
    Vector mean = vertices[0];
    for_places<Size - 1>([&](auto k) {
      for_places<Dimension>([&](auto axis) { mean[axis] += vertices[k + 1][axis]; });
    });
    for_places<Dimension>([&](auto axis) { mean[axis] *= 1. / Size; });
    return mean;
  }

  // Returns the places of the two least levels, times a sign. A single one is both. Which places
  // they are, takes no branch.
  template <std::size_t Size>
  static std::pair<std::size_t, std::size_t> least_two(const std::array<double, Size>& levels,
                                                       double sign)
  {
    if constexpr(Size <= 2)
      return {0, Size - 1};
    std::size_t first = sign * levels[1] < sign * levels[0], second = 1 - first;
    double least = lesser(sign * levels[0], sign * levels[1]);
    double next = larger(sign * levels[0], sign * levels[1]);
    for(std::size_t k = 2; k < Size; ++k) {
      const double level = sign * levels[k];
      const std::size_t is_least = level < least, is_less = level < next;
      second += is_less * (k - second);
      second += is_least * (first - second);
      first += is_least * (k - first);
      next = larger(least, lesser(next, level));
      least = lesser(least, level);
    }
    return {first, second};
  }

  std::array<Vector, Size_a> a_; // with the first vertex at the origin
  std::array<Vector, Size_b> b_;
  double largest_; // absolute value of a coordinate
  std::array<double, Size_a> levels_of_a_; // products with the last v
  std::array<double, Size_b> levels_of_b_;
};

// Returns whether two hulls are within a bound on the distance that is between two doubles, or
// nothing if that is not known. The sizes are those of the hulls. `v` becomes a point of C.
template <std::size_t Size_a, std::size_t Size_b, int Dimension>
BOOST_FORCEINLINE Uncertain<bool>
are_hulls_near(const Hull<Dimension>& a, const Hull<Dimension>& b, const Interval& reach,
               std::array<double, static_cast<std::size_t>(Dimension)>& v)
{
  if constexpr(Size_a <= 2 && Size_b <= 2) {
    const auto& p = a.vertices[0];
    const auto& r = b.vertices[0];
    return are_segments_near(vector_difference(a.vertices[Size_a - 1], p),
                             vector_difference(b.vertices[Size_b - 1], r),
                             vector_difference(r, p), a.error + b.error, reach, v);
  }
  else {
    Hulls_apart<Dimension, Size_a, Size_b> hulls(a, b);
    v = hulls.difference_of_means();
    const Uncertain<bool> answer = hulls.ask_point(v, reach);
    if(is_certain(answer))
      return answer;
    v = hulls.difference_of_edges();
    return hulls.ask_point(v, reach);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_HULLS_NEAR_H
