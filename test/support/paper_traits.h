// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The predicates of [V03], section 2.1, written down as they stand in the paper, in the number type
// of the objects: rounded if that is.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PAPER_TRAITS_H
#define THICK_INTERSECTION_TEST_SUPPORT_PAPER_TRAITS_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

namespace test_support {

template <class Object>
using Number_of = typename CGAL::Kernel_traits<Object>::Kernel::FT;

// The order along an axis, x_i(A) <= x_i(B) and x_i(A) <= x_i(B) - R. Position(a, i) gives
// coordinate i of the object a.
template <class Object, class Position>
struct Paper_order
{
  struct Less_coordinate_d
  {
    bool operator()(const Object& a, const Object& b, int i) const
    {
      return Position()(a, i) < Position()(b, i);
    }
  };
  struct Is_close_along_axis_d
  {
    Number_of<Object> reach;
    bool operator()(const Object& a, const Object& b, int i) const
    {
      return Position()(a, i) <= Position()(b, i) + reach
             && Position()(b, i) <= Position()(a, i) + reach;
    }
  };
};

// Points within a distance.
template <class Point, int Dimension>
class Paper_point_traits
{
  struct Position
  {
    decltype(auto) operator()(const Point& p, int i) const { return p[i]; }
  };

public:
  using Object_d = Point;
  using Less_coordinate_d = typename Paper_order<Point, Position>::Less_coordinate_d;
  using Is_close_along_axis_d = typename Paper_order<Point, Position>::Is_close_along_axis_d;
  struct Do_intersect_d
  {
    Number_of<Point> radius;
    bool operator()(const Point& p, const Point& q) const
    {
      return CGAL::squared_distance(p, q) <= radius * radius;
    }
  };

  explicit Paper_point_traits(const Number_of<Point>& radius) : radius_(radius) {}

  int dimension() const { return Dimension; }
  Less_coordinate_d less_coordinate_d_object() const { return {}; }
  Is_close_along_axis_d is_close_along_axis_d_object() const { return {radius_}; }
  Do_intersect_d do_intersect_d_object() const { return {radius_}; }

private:
  Number_of<Point> radius_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_PAPER_TRAITS_H
