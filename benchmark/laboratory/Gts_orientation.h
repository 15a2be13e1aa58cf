// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The orientation of points by the adaptive predicates of J. R. Shewchuk (Adaptive precision
// floating-point arithmetic and fast robust geometric predicates, 1997), as the GNU Triangulated
// Surface Library has them. It takes the place of this package's Staged_orientation, so that two
// columns differ in nothing but the arithmetic.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_GTS_ORIENTATION_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_GTS_ORIENTATION_H

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <gts.h>

#include <array>
#include <cstddef>

namespace lab {

template <int Dimension>
class Gts_orientation
{
public:
  static constexpr int dimension = Dimension;

  struct Vertex
  {
    std::array<double, Dimension> x;
  };

  // Refers to a vertex.
  class Point
  {
  public:
    Point() = default;
    explicit Point(const Vertex& vertex) : vertex_(&vertex) {}
    double operator[](int axis) const { return vertex_->x[static_cast<std::size_t>(axis)]; }

  private:
    const Vertex* vertex_;
  };

  template <std::size_t Size>
  using Vertices = std::array<Vertex, Size>;

  template <std::size_t Size>
  explicit Gts_orientation(Vertices<Size>&, CGAL::Arithmetic_tier)
  {}

  static CGAL::Arithmetic_tier needed_tier() { return CGAL::Arithmetic_tier::FILTERED_EXACT; }

  static CGAL::Sign compare(const Point& p, const Point& q, int axis)
  {
    return CGAL::compare(p[axis], q[axis]);
  }

  static CGAL::Sign orientation(const Point& p, const Point& q, const Point& r, int i, int j)
  {
    GtsPoint a = gts_point(p[i], p[j]), b = gts_point(q[i], q[j]), c = gts_point(r[i], r[j]);
    return CGAL::sign(gts_point_orientation(&a, &b, &c));
  }

  static CGAL::Sign orientation_by_filter(const Point& p, const Point& q, const Point& r, int i,
                                          int j)
  {
    return orientation(p, q, r, i, j);
  }

  static CGAL::Sign decide_orientation(const Point&, const Point&, const Point&, int, int)
  {
    return CGAL::ZERO; // orientation_by_filter() knows it
  }

  struct Plane
  {
    GtsPoint p, q, r;
  };

  static Plane plane(const Point& p, const Point& q, const Point& r)
  {
    return {gts_point(p), gts_point(q), gts_point(r)};
  }

  // The sign of the library is the opposite one.
  static CGAL::Sign side(Plane plane, const Point& s)
  {
    GtsPoint d = gts_point(s);
    return CGAL::sign(-gts_point_orientation_3d(&plane.p, &plane.q, &plane.r, &d));
  }

  static CGAL::Sign side_by_filter(const Plane& plane, const Point& s) { return side(plane, s); }

  static CGAL::Sign decide_side(const Plane&, const Point&) { return CGAL::ZERO; }

private:
  // Predicates read the coordinates alone.
  static GtsPoint gts_point(double x, double y, double z = 0)
  {
    GtsPoint point = {};
    point.x = x;
    point.y = y;
    point.z = z;
    return point;
  }
  static GtsPoint gts_point(const Point& p) { return gts_point(p[0], p[1], p[2]); }
};

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_GTS_ORIENTATION_H
