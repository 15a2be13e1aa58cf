// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_KERNEL_ORIENTATION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_KERNEL_ORIENTATION_H

// The orientation of points of a kernel whose predicates are exact, by these predicates.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// As Staged_orientation.
template <class Kernel, int Dimension>
class Kernel_orientation
{
  using Point_2 = typename Kernel::Point_2;

public:
  using Point = std::conditional_t<Dimension == 2, Point_2, typename Kernel::Point_3>;
  static constexpr int dimension = Dimension;

  static Arithmetic_tier needed_tier() { return Arithmetic_tier::FILTERED_EXACT; }

  static Sign compare(const Point& p, const Point& q, int axis)
  {
    return CGAL::compare(p.cartesian(axis), q.cartesian(axis));
  }

  static Sign turn(const Point& p, const Point& q, const Point& r, int i, int j)
  {
    const typename Kernel::Orientation_2 orientation = Kernel().orientation_2_object();
    if constexpr(Dimension == 2)
      return orientation(p, q, r);
    else {
      const auto shadow = [=](const Point& x) { return Point_2(x.cartesian(i), x.cartesian(j)); };
      return orientation(shadow(p), shadow(q), shadow(r));
    }
  }

  struct Plane
  {
    const Point& p;
    const Point& q;
    const Point& r;
  };

  static Plane plane(const Point& p, const Point& q, const Point& r) { return {p, q, r}; }

  static Sign side(const Plane& plane, const Point& s)
  {
    return Kernel().orientation_3_object()(plane.p, plane.q, plane.r, s);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_KERNEL_ORIENTATION_H
