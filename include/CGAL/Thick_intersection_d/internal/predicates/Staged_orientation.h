// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_STAGED_ORIENTATION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_STAGED_ORIENTATION_H

// The orientation of points whose coordinates are doubles, exact in stages: a filter in doubles,
// equal points, integers on a grid of the few points asked about, exact numbers.
//
// The filter computes a determinant of differences, and the sum of the absolute values of its
// terms. Let u = 2^-52, which bounds the relative error of an operation in every rounding mode. In
// the plane, a term has the error of two differences and a product, and the determinant that of
// one more difference: together 4u of the sum, to first order. In space it is three differences,
// two products, the difference of a minor and two sums: 8u. The factors below have room for the
// error of the sum itself, and for fused operations. A product that underflows is off by at most
// 2^-1074. The least sums make up for that: a minor that has lost bits is multiplied by a
// difference, and so is its least sum. What overflows leaves the filter undecided, as comparisons
// with NaN and with infinity are false.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/determinant_signs.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/grid_steps.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Dimension` is that of the points, 2 or 3. An object of this class is for one question about two
// objects: it remembers which arithmetic was needed.
template <int Dimension>
class Staged_orientation
{
public:
  using Point = std::array<double, Dimension>;
  static constexpr int dimension = Dimension;

  // The first arithmetic after the filter. It is exact for the differences of the points that will
  // be asked about: DOUBLE if doubles compute their determinants without rounding. Where nothing is
  // known about the points, it is INT64, because wider integers follow where they are needed.
  explicit Staged_orientation(Arithmetic_tier least_tier = Arithmetic_tier::INT64)
    : least_tier_(least_tier)
  {}

  // The arithmetic that the hardest question so far has needed.
  Arithmetic_tier needed_tier() const { return needed_tier_; }

  static Sign compare(const Point& p, const Point& q, int axis)
  {
    return sign_of_number(p[axis] - q[axis]); // zero for equal numbers only
  }

  // Returns whether p, q, r make a left turn, a right turn or none along the axes i and j.
  Sign turn(const Point& p, const Point& q, const Point& r, int i, int j)
  {
    const double left = (q[i] - p[i]) * (r[j] - p[j]);
    const double right = (q[j] - p[j]) * (r[i] - p[i]);
    const double determinant = left - right;
    const double bound = planar_factor * (std::fabs(left) + std::fabs(right)) + least_bound;
    return determinant > bound ? POSITIVE
           : -determinant > bound ? NEGATIVE
                                  : decide_turn(p, q, r, i, j, determinant);
  }

  // The plane of three points, for questions about several others.
  struct Plane
  {
    const Point& p;
    const Point& q;
    const Point& r;
    std::array<double, 3> normal;
    std::array<double, 3> sums; // of the absolute values of the terms of the normal
  };

  static Plane plane(const Point& p, const Point& q, const Point& r)
  {
    Plane plane = {p, q, r, {}, {}};
    for(int i = 0; i < 3; ++i) {
      const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
      const double left = (q[j] - p[j]) * (r[k] - p[k]);
      const double right = (q[k] - p[k]) * (r[j] - p[j]);
      plane.normal[i] = left - right;
      plane.sums[i] = std::fabs(left) + std::fabs(right) + least_bound;
    }
    return plane;
  }

  // Returns on which side of a plane s is: the orientation of p, q, r and s.
  Sign side(const Plane& plane, const Point& s)
  {
    double determinant = 0, sum = 0;
    for(int i = 0; i < 3; ++i) {
      const double difference = s[i] - plane.p[i];
      determinant += plane.normal[i] * difference;
      sum += plane.sums[i] * std::fabs(difference);
    }
    const double bound = spatial_factor * sum + least_bound;
    return determinant > bound ? POSITIVE
           : -determinant > bound ? NEGATIVE
                                  : decide_side(plane.p, plane.q, plane.r, s, determinant);
  }

private:
  static constexpr double planar_factor = 0x1p-49, spatial_factor = 0x1p-48;
  static constexpr double least_bound = 0x1p-1000;

  CGAL_RARELY_CALLED Sign decide_turn(const Point& p, const Point& q, const Point& r, int i, int j,
                                      double determinant)
  {
    if(least_tier_ == Arithmetic_tier::DOUBLE)
      return sign_of_number(determinant);
    if(is_flat(i, p, q, r) || is_flat(j, p, q, r))
      return ZERO;
    return decide<3>({&p, &q, &r}, std::array<int, 2>{i, j});
  }

  CGAL_RARELY_CALLED Sign decide_side(const Point& p, const Point& q, const Point& r,
                                      const Point& s, double determinant)
  {
    if(least_tier_ == Arithmetic_tier::DOUBLE)
      return sign_of_number(determinant);
    for(int i = 0; i < 3; ++i)
      if(is_flat(i, p, q, r, s))
        return ZERO;
    return decide<4>({&p, &q, &r, &s}, std::array<int, 3>{0, 1, 2});
  }

  // Whether all points have one coordinate along an axis.
  template <class... Others>
  static bool is_flat(int axis, const Point& p, const Others&... others)
  {
    return ((others[axis] == p[axis]) && ...);
  }

  template <std::size_t Count>
  using Points = std::array<const Point*, Count>;

  template <std::size_t Count, class Axes>
  Sign decide(const Points<Count>& points, const Axes& axes)
  {
    if(are_any_equal(points, axes))
      return ZERO;
    if(least_tier_ < Arithmetic_tier::FILTERED_EXACT)
      return decide_in_integers(points, axes);
    return decide_exactly(points, axes);
  }

  template <std::size_t Count, class Axes>
  static bool are_any_equal(const Points<Count>& points, const Axes& axes)
  {
    for(std::size_t a = 0; a < Count; ++a)
      for(std::size_t b = 0; b < a; ++b)
        if(std::all_of(axes.begin(), axes.end(), [&](int axis) {
             return (*points[a])[axis] == (*points[b])[axis];
           }))
          return true;
    return false;
  }

  // The rows of the matrix are the axes, each in steps of a grid of its own: to scale a row changes
  // the size of the determinant, not its sign.
  template <std::size_t Count, class Axes>
  Sign decide_in_integers(const Points<Count>& points, const Axes& axes)
  {
    Square_matrix<std::int64_t, Count - 1> matrix;
    int bits = 0;
    for(std::size_t row = 0; row < Count - 1; ++row) {
      std::array<double, Count> x;
      for(std::size_t k = 0; k < Count; ++k)
        x[k] = (*points[k])[axes[row]];
      const Grid_steps<Count - 1> steps = grid_steps(x);
      if(steps.bits > max_step_bits)
        return decide_exactly(points, axes);
      matrix[row] = steps.steps;
      bits += steps.bits;
    }
    return sign_in_integers(matrix, bits);
  }

  // A determinant has two terms of up to 2^bits in the plane, and six in space.
  template <std::size_t N>
  Sign sign_in_integers(const Square_matrix<std::int64_t, N>& matrix, int bits)
  {
    const int all_bits = bits + (N == 2 ? 1 : 3);
    if(all_bits < 64 && least_tier_ <= Arithmetic_tier::INT64) {
      need(Arithmetic_tier::INT64);
      return sign_of_determinant<std::int64_t>(matrix);
    }
    if(N == 2 || (all_bits < 128 && least_tier_ <= Arithmetic_tier::INT128)) {
      need(Arithmetic_tier::INT128);
      return sign_of_determinant<Int128>(matrix);
    }
    need(Arithmetic_tier::INT192);
    if constexpr(N == 3)
      return sign_of_long_determinant(matrix);
    return ZERO;
  }

  template <std::size_t Count, class Axes>
  Sign decide_exactly(const Points<Count>& points, const Axes& axes)
  {
    using Exact = Exact_number_t<double>;
    need(Arithmetic_tier::FILTERED_EXACT);
    Square_matrix<Exact, Count - 1> matrix;
    for(std::size_t row = 0; row < Count - 1; ++row)
      for(std::size_t k = 1; k < Count; ++k)
        matrix[row][k - 1]
          = Exact((*points[k])[axes[row]]) - Exact((*points[0])[axes[row]]);
    return sign_of_determinant<Exact>(matrix);
  }

  void need(Arithmetic_tier tier) { needed_tier_ = (std::max)(needed_tier_, tier); }

  Arithmetic_tier least_tier_;
  Arithmetic_tier needed_tier_ = Arithmetic_tier::DOUBLE;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_STAGED_ORIENTATION_H
