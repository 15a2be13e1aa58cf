// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes in the points of a kernel: a maker per kind of kernel, and the pairs that the package
// reports for them.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_KERNELS_H
#define THICK_INTERSECTION_TEST_SUPPORT_KERNELS_H

#include "kernel_types.h"
#include "pairs.h"
#include "point_scene.h"

#include <CGAL/Exact_integer.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

namespace test_support {

// Points in the plane or in space with the coordinates of a scene, in a Cartesian kernel.
template <class Kernel, int Dimension>
struct Cartesian_points
{
  using FT = typename Kernel::FT;
  using Types = Kernel_types<Kernel, Dimension>;
  using Point = typename Types::Point;

  static FT number(double x) { return FT(x); }
  static Point make(const Coordinates& c)
  {
    return Types::point([&](std::size_t axis) { return number(c[axis]); });
  }
};

// The same in a homogeneous kernel over the integers: the product of the denominators of the
// coordinates is the last one.
template <class Kernel, int Dimension>
struct Homogeneous_points
{
  using RT = typename Kernel::RT;
  using Types = Kernel_types<Kernel, Dimension>;
  using Point = typename Types::Point;

  static Point make(const Coordinates& c)
  {
    RT numerator[Dimension], denominator[Dimension], w(1);
    for(int i = 0; i < Dimension; ++i) {
      typename CGAL::Fraction_traits<CGAL::Exact_rational>::Decompose()(
        CGAL::Exact_rational(c[i]), numerator[i], denominator[i]);
      w *= denominator[i];
    }
    return Types::point([&](std::size_t i) { return RT(numerator[i] * (w / denominator[i])); }, w);
  }
};

// Points of any dimension in a kernel that has them.
template <class Kernel>
struct Points_d
{
  using Point = typename Kernel::Point_d;
  static Point make(const Coordinates& c) { return Point(c.begin(), c.end()); }
};

template <class Maker>
std::vector<typename Maker::Point> make_points(const Points& points)
{
  std::vector<typename Maker::Point> result;
  for(const Coordinates& c : points)
    result.push_back(Maker::make(c));
  return result;
}

inline CGAL::Exact_rational exact_rational(const std::string& text)
{
  CGAL::Exact_rational value;
  std::istringstream(text) >> value;
  return value;
}

// Calls f(bound) with the closed bound of a scene.
template <class Function>
auto with_bound(const Radius& radius, const Function& f)
{
  return radius.length() ? f(CGAL::within_distance(*radius.length()))
                         : f(CGAL::within_squared_distance(exact_rational(radius.square_text())));
}

template <class ConcurrencyTag = CGAL::Sequential_tag, class Point, class NT>
Pairs near_pairs(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& bound)
{
  Pairs pairs;
  const bool is_complete
    = CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(points, bound, Pair_collector{pairs});
  if(!is_complete)
    pairs.emplace_back(points.size(), points.size()); // nobody stopped it: shows as an extra pair
  return pairs;
}

// The same by recursion route, which is taken for traits of any kind.
template <class Point, class NT>
Pairs near_pairs_by_recursion(const std::vector<Point>& points,
                             const CGAL::Distance_bound<NT>& bound, int dimension)
{
  Pairs pairs;
  CGAL::thick_self_intersection_d(
    points, Pair_collector{pairs},
    CGAL::parameters::geom_traits(CGAL::Thick_point_traits_d<Point>(bound, dimension)));
  return pairs;
}

template <class Point, class NT>
Pairs near_pairs(const std::vector<Point>& a, const std::vector<Point>& b,
                 const CGAL::Distance_bound<NT>& bound)
{
  Pairs pairs;
  CGAL::fixed_radius_near_neighbors(a, b, bound, Pair_collector{pairs});
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_KERNELS_H
