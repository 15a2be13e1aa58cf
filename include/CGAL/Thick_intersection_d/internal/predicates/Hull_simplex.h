// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_SIMPLEX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_SIMPLEX_H

// A simplex of up to four points, and its point next to the origin, in doubles: a step of the
// algorithm of Gilbert, Johnson and Keerthi (Hull_distance.h). Rounding may make the point a worse
// one, but it is one of the simplex, up to the error of a mean with weights that are not negative.

#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Weights of points: of the point of their hull that is next to the origin. They are not negative.
using Weights = std::array<double, 4>;

template <std::size_t N>
Weights weights_of_segment(const std::array<double, N>& p, const std::array<double, N>& q)
{
  const std::array<double, N> pq = vector_difference(q, p);
  const double to_q = -dot_product(p, pq), to_p = dot_product(q, pq);
  return to_q > 0 ? (to_p > 0 ? Weights{to_p, to_q, 0, 0} : Weights{0, 1, 0, 0})
                  : Weights{1, 0, 0, 0};
}

// By the region of the plane of the triangle that the origin is above.
template <std::size_t N>
Weights weights_of_triangle(const std::array<double, N>& p, const std::array<double, N>& q,
                            const std::array<double, N>& r)
{
  const std::array<double, N> pq = vector_difference(q, p), pr = vector_difference(r, p);
  const double p_q = -dot_product(p, pq), p_r = -dot_product(p, pr);
  if(p_q <= 0 && p_r <= 0)
    return {1, 0, 0, 0};
  const double q_q = -dot_product(q, pq), q_r = -dot_product(q, pr);
  if(q_q >= 0 && q_r <= q_q)
    return {0, 1, 0, 0};
  const double of_r = p_q * q_r - q_q * p_r;
  if(of_r <= 0 && p_q >= 0 && q_q <= 0)
    return {-q_q, p_q, 0, 0};
  const double r_q = -dot_product(r, pq), r_r = -dot_product(r, pr);
  if(r_r >= 0 && r_q <= r_r)
    return {0, 0, 1, 0};
  const double of_q = r_q * p_r - p_q * r_r;
  if(of_q <= 0 && p_r >= 0 && r_r <= 0)
    return {-r_r, 0, p_r, 0};
  const double of_p = q_q * r_r - r_q * q_r;
  if(of_p <= 0 && q_r - q_q >= 0 && r_q - r_r >= 0)
    return {0, r_q - r_r, q_r - q_q, 0};
  return {of_p, of_q, of_r, 0};
}

// Returns how much of `whole`, which is not negative, is below `x`: from 0 to 1. The constant makes
// it 0 if both are zero. No jump depends on numbers: no processor could foresee it.
inline double part_below(double x, double whole)
{
  const double twice = x + std::fabs(x);
  return (twice < 2 * whole ? twice : 2 * whole) * (.5 / (whole + 0x1p-900));
}

// Returns the point next to the origin of the differences of a point of the segment from r to s and
// a point of the segment from p to q, or one close to it if they are nearly parallel.
template <std::size_t N>
BOOST_FORCEINLINE std::array<double, N> nearest_of_segments(const std::array<double, N>& pq,
                                                            const std::array<double, N>& rs,
                                                            const std::array<double, N>& pr)
{
  const double pq_pq = dot_product(pq, pq), rs_rs = dot_product(rs, rs);
  const double pq_rs = dot_product(pq, rs);
  const double pq_pr = dot_product(pq, pr), rs_pr = dot_product(rs, pr);
  // If they are nearly parallel, the first x may be any number. The others are from 0 to 1.
  double x = part_below(pq_pr * rs_rs - pq_rs * rs_pr, pq_pq * rs_rs - pq_rs * pq_rs);
  const double y = part_below(pq_rs * x - rs_pr, rs_rs);
  x = part_below(pq_rs * y + pq_pr, pq_pq);
  std::array<double, N> point;
  for(std::size_t i = 0; i < N; ++i)
    point[i] = pr[i] + (y * rs[i] - x * pq[i]);
  return point;
}

inline double triple_product(const std::array<double, 3>& u, const std::array<double, 3>& v,
                             const std::array<double, 3>& w)
{
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2])
         + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

// Vertices of C with weights, as the algorithm keeps them.
template <int Dimension>
class Hull_simplex
{
public:
  using Vector = std::array<double, Dimension>;

  std::size_t size() const { return size_; }

  void add(const Vector& vertex) { vertices_[size_++] = vertex; }

  // Whether the simplex has a vertex already.
  bool has(const Vector& vertex) const
  {
    return std::find(vertices_.begin(), vertices_.begin() + size_, vertex)
           != vertices_.begin() + size_;
  }

  // Returns the point of the simplex that is next to the origin, and drops the vertices that are
  // not needed for it.
  Vector nearest()
  {
    const Weights weights = find_weights();
    const Vector point = mean(weights);
    std::size_t kept = 0;
    for(std::size_t k = 0; k < size_; ++k)
      if(weights[k] > 0)
        vertices_[kept++] = vertices_[k];
    size_ = kept;
    return point;
  }

private:
  // The mean of the vertices. Weights that rounding has made negative count as zero.
  Vector mean(const Weights& weights) const
  {
    Vector sum = {};
    double all = 0;
    for(std::size_t k = 0; k < size_; ++k)
      if(weights[k] > 0) {
        for(std::size_t axis = 0; axis < Dimension; ++axis)
          sum[axis] += weights[k] * vertices_[k][axis];
        all += weights[k];
      }
    const double scale = 1 / all;
    for(double& x : sum)
      x *= scale;
    return sum;
  }

  Weights find_weights() const
  {
    if constexpr(Dimension == 3)
      if(size_ == 4)
        return weights_of_tetrahedron();
    return size_ == 1   ? Weights{1, 0, 0, 0}
           : size_ == 2 ? weights_of_segment(vertices_[0], vertices_[1])
                        : weights_of_triangle(vertices_[0], vertices_[1], vertices_[2]);
  }

  // The volumes of the four parts that the origin makes of the tetrahedron, or the weights of the
  // nearest point of a face that the origin is beyond.
  Weights weights_of_tetrahedron() const
  {
    const auto& [p, q, r, s] = vertices_;
    const Weights volumes = {triple_product(q, r, s), -triple_product(p, r, s),
                             triple_product(p, q, s), -triple_product(p, q, r)};
    const double all = volumes[0] + volumes[1] + volumes[2] + volumes[3];
    Weights nearest = volumes;
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t k = 0; k < 4; ++k)
      if(!(volumes[k] * all > 0)) {
        const Weights weights = weights_of_face(k);
        const Vector point = mean(weights);
        const double square = dot_product(point, point);
        if(square < least) {
          least = square;
          nearest = weights;
        }
      }
    if(least == std::numeric_limits<double>::infinity() && all < 0)
      for(double& weight : nearest)
        weight = -weight;
    return nearest;
  }

  Weights weights_of_face(std::size_t k) const
  {
    std::array<std::size_t, 3> places = {};
    for(std::size_t i = 0, n = 0; i < 4; ++i)
      if(i != k)
        places[n++] = i;
    const Weights of_triangle = weights_of_triangle(vertices_[places[0]], vertices_[places[1]],
                                                    vertices_[places[2]]);
    Weights weights = {};
    for(std::size_t i = 0; i < 3; ++i)
      weights[places[i]] = of_triangle[i];
    return weights;
  }

  std::array<Vector, 4> vertices_;
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_SIMPLEX_H
