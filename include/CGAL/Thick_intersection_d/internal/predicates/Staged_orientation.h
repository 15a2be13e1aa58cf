// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_STAGED_ORIENTATION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_STAGED_ORIENTATION_H

// The orientation of points whose coordinates are doubles, exact in stages: a filter in doubles,
// integers on a grid of the points asked about, exact numbers.
//
// The filter computes a determinant of differences, and the sum of the absolute values of its
// terms. Let u = 2^-53, which bounds the relative error of an operation. In the plane, a term has
// the error of two differences and a product, and the determinant that of one more difference:
// together 4u of the sum, to first order. In space it is three differences, two products, the
// difference of a minor and two sums: 8u. The factors below have room for the error of the sum
// itself, and for fused operations. A product that underflows is off by at most 2^-1074. The least
// sums make up for that: a minor that has lost bits is multiplied by a difference, and so is its
// least sum. What overflows leaves the filter undecided, as comparisons with NaN and with infinity
// are false. In other rounding modes than to nearest, it may become the largest double, which looks
// like a number. So the filter decides nothing there.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/determinant_signs.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE, BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether the processor rounds to nearest in the present thread. Takes two additions, where a call
// of std::fegetround() would take as long as a few comparisons of points. Compilers must not
// compute them ahead of time.
inline bool rounds_to_nearest()
{
  const volatile double least = 0x1p-60;
  const double x = least;
  return 1 + x == 1 - x;
}

// `Dimension` is that of the points, 2 or 3. An object of this class is for one question about two
// objects. It remembers which arithmetic was needed.
template <int Dimension>
class Staged_orientation
{
public:
  static constexpr int dimension = Dimension;

  // A vertex, and the same in steps of a grid once these are needed.
  struct Vertex
  {
    std::array<double, Dimension> x;
    std::array<std::int64_t, Dimension> steps;
  };

  // Refers to a vertex.
  class Point
  {
  public:
    Point() = default;
    explicit Point(const Vertex& vertex) : vertex_(&vertex) {}
    double operator[](int axis) const { return vertex_->x[axis]; }
    std::int64_t steps(int axis) const { return vertex_->steps[axis]; }
    bool operator==(const Point& p) const { return vertex_->x == p.vertex_->x; }

  private:
    const Vertex* vertex_;
  };

  template <std::size_t Size>
  using Vertices = std::array<Vertex, Size>;

  // The points asked about are those of the vertices. `least_tier` is the first arithmetic after
  // the filter, and exact for the differences of the points: DOUBLE if doubles compute their
  // determinants without rounding; INT64 if nothing is known, as wider integers follow if needed.
  template <std::size_t Size>
  explicit Staged_orientation(Vertices<Size>& vertices,
                              Arithmetic_tier least_tier = Arithmetic_tier::INT64)
    : vertices_(vertices.data()), find_steps_(&find_steps<Size>), least_tier_(least_tier),
      least_bound_(rounds_to_nearest() ? least_sum : std::numeric_limits<double>::infinity())
  {}

  // The arithmetic that the hardest question so far has needed.
  Arithmetic_tier needed_tier() const { return needed_tier_; }

  // Zero for equal numbers only.
  static Sign compare(const Point& p, const Point& q, int i) { return sign_of_number(p[i] - q[i]); }

  // Returns whether p, q, r make a left turn, a right turn or none along the axes i and j.
  BOOST_FORCEINLINE Sign orientation(const Point& p, const Point& q, const Point& r, int i, int j)
  {
    const Sign sign = orientation_by_filter(p, q, r, i, j);
    return sign != ZERO ? sign : decide_orientation(p, q, r, i, j);
  }

  // The same, or zero if the points are nearly on a line, where decide_orientation() answers.
  BOOST_FORCEINLINE
  Sign orientation_by_filter(const Point& p, const Point& q, const Point& r, int i, int j) const
  {
    const double left = (q[i] - p[i]) * (r[j] - p[j]);
    const double right = (q[j] - p[j]) * (r[i] - p[i]);
    const double bound = planar_factor * (std::fabs(left) + std::fabs(right)) + least_bound_;
    return sign_beyond(bound, left - right);
  }

  BOOST_NOINLINE Sign decide_orientation(const Point& p, const Point& q, const Point& r, int i,
                                         int j)
  {
    const std::array<double, 3> x = {p[i], q[i], r[i]}, y = {p[j], q[j], r[j]};
    if(least_tier_ == Arithmetic_tier::DOUBLE)
      return sign_of_number((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]));
    if(p == q || q == r || r == p || (x[0] == x[1] && x[1] == x[2])
       || (y[0] == y[1] && y[1] == y[2]))
      return ZERO;
    std::array<std::int64_t, 3> x_steps, y_steps;
    const int x_bits = grid_steps(x, x_steps), y_bits = grid_steps(y, y_steps);
    if((std::max)(x_bits, y_bits) > max_step_bits || least_tier_ == Arithmetic_tier::FILTERED_EXACT)
      return decide_in_exact_numbers(x, y);
    return sign_in_plane({x_steps[1] - x_steps[0], y_steps[1] - y_steps[0]},
                         {x_steps[2] - x_steps[0], y_steps[2] - y_steps[0]}, x_bits + y_bits);
  }

  // The plane of three points, for questions about several others.
  struct Plane
  {
    Point p, q, r;
    std::array<double, 3> normal;
    std::array<double, 3> sums; // of the absolute values of the terms of the normal
  };

  BOOST_FORCEINLINE static Plane plane(const Point& p, const Point& q, const Point& r)
  {
    Plane plane = {p, q, r, {}, {}};
    for(int i = 0; i < 3; ++i) {
      const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
      const double left = (q[j] - p[j]) * (r[k] - p[k]);
      const double right = (q[k] - p[k]) * (r[j] - p[j]);
      plane.normal[i] = left - right;
      plane.sums[i] = std::fabs(left) + std::fabs(right) + least_sum;
    }
    return plane;
  }

  // Returns on which side of a plane s is: the orientation of p, q, r and s.
  Sign side(const Plane& plane, const Point& s)
  {
    const Sign sign = side_by_filter(plane, s);
    return sign != ZERO ? sign : decide_side(plane, s);
  }

  // The same, or zero if s is close to the plane, where decide_side() answers.
  Sign side_by_filter(const Plane& plane, const Point& s) const
  {
    double sum = 0;
    const double determinant = determinant_of(plane, s, sum);
    return sign_beyond(spatial_factor * sum + least_bound_, determinant);
  }

  BOOST_NOINLINE Sign decide_side(const Plane& plane, const Point& s)
  {
    if(double sum = 0; least_tier_ == Arithmetic_tier::DOUBLE)
      return sign_of_number(determinant_of(plane, s, sum));
    const auto is_degenerate
      = [&](int i) { return s[i] == plane.p[i] && s[i] == plane.q[i] && s[i] == plane.r[i]; };
    if(is_degenerate(0) || is_degenerate(1) || is_degenerate(2) || s == plane.p || s == plane.q
       || s == plane.r)
      return ZERO;
    if(!have_steps())
      return decide_side_in_exact_numbers(plane, s);
    const auto vector_to = [&](const Point& x) {
      const auto along = [&](int i) { return x.steps(i) - plane.p.steps(i); };
      return Vector{along(0), along(1), along(2)};
    };
    return sign_in_space(vector_to(plane.q), vector_to(plane.r), vector_to(s));
  }

private:
  static constexpr int too_many_bits = 1000;
  static constexpr double planar_factor = 0x1p-50, spatial_factor = 0x1p-49, least_sum = 0x1p-1000;

  // Returns the sign of a number that is off by at most `bound`, or zero if that is not known.
  // Which sign it is cannot be predicted, so it takes no branch.
  static Sign sign_beyond(double bound, double x)
  {
    return static_cast<Sign>(static_cast<int>(x > bound) - static_cast<int>(-x > bound));
  }

  // Adds the absolute values of the terms to `sum`.
  static double determinant_of(const Plane& plane, const Point& s, double& sum)
  {
    double determinant = 0;
    for(int i = 0; i < 3; ++i) {
      const double difference = s[i] - plane.p[i];
      determinant += plane.normal[i] * difference;
      sum += plane.sums[i] * std::fabs(difference);
    }
    return determinant;
  }

  // ---- integers ---------------------------------------------------------------------------------

  // Each axis has steps of a grid of its own: to scale an axis changes the size of a determinant,
  // not its sign. Turns have a grid of three points, because few of them get here. Sides have one
  // of all vertices: where one is close to a plane, others are. Returns whether integers hold them.
  bool have_steps()
  {
    if(bits_ == 0)
      bits_ = least_tier_ < Arithmetic_tier::FILTERED_EXACT ? find_steps_(vertices_)
                                                            : too_many_bits;
    return bits_ < too_many_bits;
  }

  template <std::size_t Size>
  static int find_steps(Vertex* vertices)
  {
    int all_bits = 3;
    for(std::size_t axis = 0; axis < 3 && all_bits < too_many_bits; ++axis) {
      std::array<double, Size> x;
      std::array<std::int64_t, Size> steps;
      for(std::size_t k = 0; k < Size; ++k)
        x[k] = vertices[k].x[axis];
      const int bits = grid_steps(x, steps);
      for(std::size_t k = 0; k < Size; ++k)
        vertices[k].steps[axis] = steps[k];
      all_bits += bits <= max_step_bits ? bits : too_many_bits;
    }
    return all_bits;
  }

  // A determinant has two terms of up to 2^bits in the plane, and six terms in space.
  Sign sign_in_plane(const std::array<std::int64_t, 2>& u, const std::array<std::int64_t, 2>& v,
                     int bits)
  {
    if(bits + 1 < 64 && least_tier_ <= Arithmetic_tier::INT64) {
      need(Arithmetic_tier::INT64);
      return sign_of_determinant<std::int64_t>(u, v);
    }
    need(Arithmetic_tier::INT128);
    return sign_of_determinant<Int128>(u, v);
  }

  using Vector = std::array<std::int64_t, 3>;

  Sign sign_in_space(const Vector& u, const Vector& v, const Vector& w)
  {
    if(bits_ < 64 && least_tier_ <= Arithmetic_tier::INT64) {
      need(Arithmetic_tier::INT64);
      return sign_of_product<std::int64_t>(normal_of<std::int64_t>(u, v), w);
    }
    if(bits_ < 128 && least_tier_ <= Arithmetic_tier::INT128) {
      need(Arithmetic_tier::INT128);
      return sign_of_product<Int128>(normal_of<Int128>(u, v), w);
    }
    need(Arithmetic_tier::INT192);
    return sign_of_long_product(normal_of<Int128>(u, v), w);
  }

  // ---- exact numbers ----------------------------------------------------------------------------

  // The orientation of three points is the side of a point above the first one.
  Sign decide_in_exact_numbers(const std::array<double, 3>& x, const std::array<double, 3>& y)
  {
    need(Arithmetic_tier::FILTERED_EXACT);
    return exact_orientation(
      {{{x[0], y[0], 0}, {x[1], y[1], 0}, {x[2], y[2], 0}, {x[0], y[0], 1}}});
  }

  Sign decide_side_in_exact_numbers(const Plane& plane, const Point& s)
  {
    need(Arithmetic_tier::FILTERED_EXACT);
    const auto doubles = [](const Point& x) { return std::array<double, 3>{x[0], x[1], x[2]}; };
    return exact_orientation({doubles(plane.p), doubles(plane.q), doubles(plane.r), doubles(s)});
  }

  void need(Arithmetic_tier tier) { needed_tier_ = (std::max)(needed_tier_, tier); }

  Vertex* vertices_;
  int (*find_steps_)(Vertex*);
  int bits_ = 0; // of determinants of the steps, once these are known
  Arithmetic_tier needed_tier_ = Arithmetic_tier::DOUBLE;
  Arithmetic_tier least_tier_;
  double least_bound_; // infinite if the filter decides nothing
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_STAGED_ORIENTATION_H
