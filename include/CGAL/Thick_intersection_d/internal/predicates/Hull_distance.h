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
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Hull_distance
{
  using Vector = std::array<double, Dimension>;
  using Points = Hull<Dimension>;

public:
  Hull_distance(const Points& a, const Points& b) : a_(a), b_(b)
  {
    const Vector origin = a.vertices[0];
    double largest = 0;
    const auto move = [&](Points& hull) {
      for(std::size_t k = 0; k < hull.size; ++k) {
        hull.vertices[k] = vector_difference(hull.vertices[k], origin);
        for(const double x : hull.vertices[k])
          largest = (std::max)(largest, std::fabs(x));
      }
    };
    move(a_);
    move(b_);
    largest_ = largest + a.error + b.error;
    slack_ = 0x1p-45 * largest_ + 4 * (a.error + b.error);
  }

  // Returns whether the distance is within a bound that is between two doubles, or nothing if that
  // is not known.
  Uncertain<bool> is_within(double low, double high)
  {
    if(!(largest_ >= 0x1p-200 && largest_ <= 0x1p200))
      return Uncertain<bool>::indeterminate();
    Vector v = vector_difference(mean_of(b_), mean_of(a_)); // a direction to begin with
    Hull_simplex<Dimension> simplex;
    for(int step = 0; step < max_steps; ++step) {
      const Vector vertex = look_along(v);
      if(least_product_ > (high + slack_) * length_)
        return false;
      if(simplex.has(vertex) || (is_in_hull_ && square_ - least_product_ <= slack_ * length_))
        break;
      simplex.add(vertex);
      v = simplex.nearest();
      is_in_hull_ = true;
      if(std::sqrt(dot_product(v, v)) + slack_ <= low)
        return true;
      if(simplex.size() > Dimension) // the origin is in it
        break;
    }
    look_along(v);
    return Uncertain<bool>::indeterminate();
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

  // Infinite if the algorithm has not run.
  double tolerance() const
  {
    if(!is_in_hull_)
      return std::numeric_limits<double>::infinity();
    const double gap = (std::max)(square_ - least_product_, 0.) + 8 * slack_ * length_;
    return 4 * largest_ * (std::sqrt(gap) + 2 * slack_) + slack_ * length_;
  }

  static Vector mean_of(const Points& hull)
  {
    Vector sum = {};
    for(std::size_t k = 0; k < hull.size; ++k)
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        sum[axis] += hull.vertices[k][axis] / static_cast<double>(hull.size);
    return sum;
  }

  // Finds the vertex of C with the least product with v.
  Vector look_along(const Vector& v)
  {
    square_ = dot_product(v, v);
    length_ = std::sqrt(square_);
    least_ = std::numeric_limits<double>::infinity();
    most_ = -least_;
    std::size_t of_a = 0, of_b = 0;
    for(std::size_t k = 0; k < a_.size; ++k) {
      levels_of_a_[k] = dot_product(a_.vertices[k], v);
      if(levels_of_a_[k] > most_) {
        most_ = levels_of_a_[k];
        of_a = k;
      }
    }
    for(std::size_t k = 0; k < b_.size; ++k) {
      levels_of_b_[k] = dot_product(b_.vertices[k], v);
      if(levels_of_b_[k] < least_) {
        least_ = levels_of_b_[k];
        of_b = k;
      }
    }
    least_product_ = least_ - most_;
    return vector_difference(b_.vertices[of_b], a_.vertices[of_a]);
  }

  Points a_, b_;
  double largest_;
  double slack_;
  bool is_in_hull_ = false; // whether v is in C, up to the slack
  double square_ = 0, length_ = 0, least_product_ = 0; // of the last v
  std::array<double, Points::capacity> levels_of_a_ = {}, levels_of_b_ = {}; // products with v
  double most_ = 0, least_ = 0; // of them
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_DISTANCE_H
