// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_KERNEL_ORIENTATION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_KERNEL_ORIENTATION_H

// The orientation of points of a kernel whose predicates are exact, by these predicates.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
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
  static constexpr int dimension = Dimension;

  using Vertex = std::conditional_t<Dimension == 2, Point_2, typename Kernel::Point_3>;

  // Refers to a vertex.
  class Point
  {
  public:
    Point() = default;
    explicit Point(const Vertex& vertex) : vertex_(&vertex) {}
    const Vertex& operator*() const { return *vertex_; }

  private:
    const Vertex* vertex_;
  };

  template <std::size_t Size>
  using Vertices = std::array<Vertex, Size>;

  template <std::size_t Size>
  explicit Kernel_orientation(Vertices<Size>&, Arithmetic_tier = Arithmetic_tier::FILTERED_EXACT)
  {}

  static Arithmetic_tier needed_tier() { return Arithmetic_tier::FILTERED_EXACT; }

  static Sign compare(const Point& p, const Point& q, int axis)
  {
    return CGAL::compare((*p).cartesian(axis), (*q).cartesian(axis));
  }

  static Sign orientation(const Point& p, const Point& q, const Point& r, int i, int j)
  {
    const typename Kernel::Orientation_2 orientation = Kernel().orientation_2_object();
    if constexpr(Dimension == 2)
      return orientation(*p, *q, *r);
    else {
      const auto projection
        = [=](const Point& x) { return Point_2((*x).cartesian(i), (*x).cartesian(j)); };
      return orientation(projection(p), projection(q), projection(r));
    }
  }

  static Sign orientation_by_filter(const Point& p, const Point& q, const Point& r, int i, int j)
  {
    return orientation(p, q, r, i, j);
  }

  static Sign decide_orientation(const Point& p, const Point& q, const Point& r, int i, int j)
  {
    return orientation(p, q, r, i, j);
  }

  struct Plane
  {
    Point p, q, r;
  };

  static Plane plane(const Point& p, const Point& q, const Point& r) { return {p, q, r}; }

  static Sign side(const Plane& plane, const Point& s)
  {
    return Kernel().orientation_3_object()(*plane.p, *plane.q, *plane.r, *s);
  }

  static Sign side_by_filter(const Plane& plane, const Point& s) { return side(plane, s); }

  static Sign decide_side(const Plane& plane, const Point& s) { return side(plane, s); }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_KERNEL_ORIENTATION_H
