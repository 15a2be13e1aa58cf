// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The predicates of [V03], section 2.1, written down as they stand in the paper, in the number type
// of the objects: rounded if that is. And those of balls that are stored with the square of their
// radius.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_PAPER_TRAITS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_PAPER_TRAITS_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

namespace lab {

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

// Solid balls that are stored with the square of their radius, as Circle_2 and Sphere_3 are: two
// intersect iff d^2 <= (sqrt R1 + sqrt R2)^2, which without roots is
//   d^2 - R1 - R2 <= 0   or   (d^2 - R1 - R2)^2 <= 4 R1 R2.
// The squares are of degree 2 in the radii, so the second polynomial is of degree 4. The reach is
// given, for it needs a root.
template <class Sphere, int Dimension>
class Squared_radius_traits
{
  struct Position
  {
    decltype(auto) operator()(const Sphere& s, int i) const { return s.center()[i]; }
  };

public:
  using Object_d = Sphere;
  using Less_coordinate_d = typename Paper_order<Sphere, Position>::Less_coordinate_d;
  using Is_close_along_axis_d = typename Paper_order<Sphere, Position>::Is_close_along_axis_d;
  struct Do_intersect_d
  {
    bool operator()(const Sphere& a, const Sphere& b) const
    {
      const Number_of<Sphere> excess = CGAL::squared_distance(a.center(), b.center())
                                   - a.squared_radius() - b.squared_radius();
      return excess <= 0 || excess * excess <= 4 * a.squared_radius() * b.squared_radius();
    }
  };

  explicit Squared_radius_traits(const Number_of<Sphere>& reach) : reach_(reach) {}

  int dimension() const { return Dimension; }
  Less_coordinate_d less_coordinate_d_object() const { return {}; }
  Is_close_along_axis_d is_close_along_axis_d_object() const { return {reach_}; }
  Do_intersect_d do_intersect_d_object() const { return {}; }

private:
  Number_of<Sphere> reach_;
};

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_PAPER_TRAITS_H
