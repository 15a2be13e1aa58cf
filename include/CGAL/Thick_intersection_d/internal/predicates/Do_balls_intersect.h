// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H

// Is |pq| <= r + s? The predicate of balls with a radius each: degree 2, exact for every kernel.

#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Do_balls_intersect
{
  using Number = Coordinate_t<Point>;
  using Exact = Exact_number_t<Number>;

public:
  using Ball = std::pair<Point, Number>;

  explicit Do_balls_intersect(int dimension)
    : error_(2 * relative_error(dimension)), dimension_(dimension)
  {}

  bool operator()(const Ball& a, const Ball& b) const
  {
    const std::pair<double, double> r = bounds(a.second);
    const std::pair<double, double> s = bounds(b.second);
    const double least_sum = r.first + s.first;
    const double max_sum = r.second + s.second;

    double inf = 0; // the squared distance lies between inf and sup, up to relative_error()
    double sup = 0;
    for(int i = 0; i < dimension_; ++i) {
      const Gap g = gap(coordinate(a.first, i), coordinate(b.first, i));
      inf += g.inf * g.inf;
      sup += g.sup * g.sup;
    }

    // The sums of radii and their squares have an error of their own, three roundings: less than
    // relative_error(). Underflow and overflow leave the decision to the exact numbers.
    static const double tiny = std::ldexp(1., -960);
    static const double huge = std::ldexp(1., 1020);
    const double least = least_sum * least_sum;
    const double greatest = max_sum * max_sum;
    if(least > tiny && greatest < huge) {
      if(sup <= least * (1 - error_))
        return true;
      if(inf > greatest * (1 + error_))
        return false;
    }
    return do_intersect_exactly(a, b);
  }

private:
  bool do_intersect_exactly(const Ball& a, const Ball& b) const
  {
    const Exact sum = to_exact_number(a.second) + to_exact_number(b.second);
    return exact_squared_distance(a.first, b.first, dimension_) <= Exact(sum * sum);
  }

  double error_;
  int dimension_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H
