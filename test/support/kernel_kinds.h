// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects of all kinds of a kernel, in one type.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_KERNEL_KINDS_H
#define THICK_INTERSECTION_TEST_SUPPORT_KERNEL_KINDS_H

#include "kinds.h"

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

namespace test_support {

// What all dimensions share. With exact numbers, the unit may be a third of the power of two, so
// that no double holds a coordinate. Boxes of doubles are boxes of the kernel then.
template <class K>
struct Kind_numbers
{
  using FT = typename K::FT;
  static constexpr bool is_exact = CGAL::Algebraic_structure_traits<FT>::Is_exact::value;

  double as_double(std::int64_t x) const { return std::ldexp(static_cast<double>(x), exponent); }

  FT number(std::int64_t x) const
  {
    if constexpr(is_exact)
      if(is_third)
        return FT(FT(as_double(x)) / FT(3));
    return FT(as_double(x));
  }

  int exponent;
  bool is_third;
};

template <class K, int Dimension>
struct Kernel_kinds;

template <class K>
struct Kernel_kinds<K, 2> : Kind_numbers<K>
{
  static constexpr int dimension = 2;
  using Point = typename K::Point_2;
  using Object = std::variant<Point, typename K::Segment_2, typename K::Triangle_2,
                              typename K::Iso_rectangle_2, CGAL::Bbox_2,
                              std::pair<Point, typename K::FT>>;

  Point point(const Place& p) const { return Point(this->number(p[0]), this->number(p[1])); }

  Object make(const Kind_object& object) const
  {
    const auto p = [&](std::size_t k) { return point(object.points[k]); };
    switch(object.kind) {
    case Kind::POINT: return p(0);
    case Kind::SEGMENT: return typename K::Segment_2(p(0), p(1));
    case Kind::TRIANGLE: return typename K::Triangle_2(p(0), p(1), p(2));
    case Kind::BALL: return std::make_pair(p(0), this->number(object.radius));
    default: break;
    }
    if(object.kind == Kind::BBOX && !this->is_third)
      return bbox(object.points[0]) + bbox(object.points[1]);
    return typename K::Iso_rectangle_2(p(0), p(1));
  }

private:
  CGAL::Bbox_2 bbox(const Place& p) const
  {
    const double x = this->as_double(p[0]), y = this->as_double(p[1]);
    return CGAL::Bbox_2(x, y, x, y);
  }
};

template <class K>
struct Kernel_kinds<K, 3> : Kind_numbers<K>
{
  static constexpr int dimension = 3;
  using Point = typename K::Point_3;
  using Object = std::variant<Point, typename K::Segment_3, typename K::Triangle_3,
                              typename K::Iso_cuboid_3, CGAL::Bbox_3,
                              std::pair<Point, typename K::FT>, typename K::Tetrahedron_3>;

  Point point(const Place& p) const
  {
    return Point(this->number(p[0]), this->number(p[1]), this->number(p[2]));
  }

  Object make(const Kind_object& object) const
  {
    const auto p = [&](std::size_t k) { return point(object.points[k]); };
    switch(object.kind) {
    case Kind::POINT: return p(0);
    case Kind::SEGMENT: return typename K::Segment_3(p(0), p(1));
    case Kind::TRIANGLE: return typename K::Triangle_3(p(0), p(1), p(2));
    case Kind::TETRAHEDRON: return typename K::Tetrahedron_3(p(0), p(1), p(2), p(3));
    case Kind::BALL: return std::make_pair(p(0), this->number(object.radius));
    default: break;
    }
    if(object.kind == Kind::BBOX && !this->is_third)
      return bbox(object.points[0]) + bbox(object.points[1]);
    return typename K::Iso_cuboid_3(p(0), p(1));
  }

private:
  CGAL::Bbox_3 bbox(const Place& p) const
  {
    const double x = this->as_double(p[0]), y = this->as_double(p[1]), z = this->as_double(p[2]);
    return CGAL::Bbox_3(x, y, z, x, y, z);
  }
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_KERNEL_KINDS_H
