// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects of all kinds of a kernel, in one type.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_KERNEL_KINDS_H
#define THICK_INTERSECTION_TEST_SUPPORT_KERNEL_KINDS_H

#include "kernel_types.h"
#include "kinds.h"

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

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

template <class Types, class Ball, class Bbox, class... Others>
using Kind_variant
  = std::variant<typename Types::Point, typename Types::Segment, typename Types::Triangle,
                 typename Types::Iso_box, Bbox, Ball, Others...>;

template <class K, int Dimension>
struct Kernel_kinds : Kind_numbers<K>
{
  static constexpr int dimension = Dimension;
  static constexpr bool have_radii = false;
  using Types = Kernel_types<K, Dimension>;
  using Point = typename Types::Point;
  using Ball = std::pair<Point, typename K::FT>;
  using Object = std::conditional_t<
    Dimension == 2, Kind_variant<Types, Ball, CGAL::Bbox_2>,
    Kind_variant<Types, Ball, CGAL::Bbox_3, typename K::Tetrahedron_3>>;

  Point point(const Place& p) const
  {
    return Types::point([&](std::size_t axis) { return this->number(p[axis]); });
  }

  Object make(const Kind_object& object) const
  {
    const auto p = [&](std::size_t k) { return point(object.points[k]); };
    switch(object.kind) {
    case Kind::POINT: return p(0);
    case Kind::SEGMENT: return typename Types::Segment(p(0), p(1));
    case Kind::TRIANGLE: return typename Types::Triangle(p(0), p(1), p(2));
    case Kind::BALL: return Ball(p(0), this->number(object.radius));
    default: break;
    }
    if constexpr(Dimension == 3)
      if(object.kind == Kind::TETRAHEDRON)
        return typename K::Tetrahedron_3(p(0), p(1), p(2), p(3));
    if(object.kind == Kind::BBOX && !this->is_third)
      return bbox(object.points[0]) + bbox(object.points[1]);
    return typename Types::Iso_box(p(0), p(1));
  }

private:
  auto bbox(const Place& p) const
  {
    return Kernel_types<CGAL::Simple_cartesian<double>, Dimension>::point([&](std::size_t axis) {
      return this->as_double(p[axis]);
    }).bbox();
  }
};

// The same objects, thickened by radii. Segments without a radius stay what they are.
template <class K, int Dimension>
struct Thickened_kinds : Kernel_kinds<K, Dimension>
{
  static constexpr bool have_radii = true;

private:
  using Plain = Kernel_kinds<K, Dimension>;
  using Segment = typename Plain::Types::Segment;

  template <class Kind>
  struct With_radius
  {
    using type = std::pair<Kind, typename K::FT>;
  };
  template <class Center>
  struct With_radius<std::pair<Center, typename K::FT>>
  {
    using type = std::pair<Center, typename K::FT>;
  };
  template <class Plain_object>
  struct Variant;
  template <class Point, class... Kinds>
  struct Variant<std::variant<Point, Kinds...>>
  {
    using type = std::variant<Segment, typename With_radius<Kinds>::type...>;
  };

public:
  using Object = typename Variant<typename Plain::Object>::type;

  Object make(const Kind_object& object) const
  {
    const auto thicken = [&](const auto& x) -> Object {
      using Kind = std::decay_t<decltype(x)>;
      if constexpr(std::is_same_v<Kind, Segment>)
        if(object.radius == 0)
          return x;
      if constexpr(std::is_same_v<Kind, typename Plain::Ball>)
        return x;
      else
        return std::pair(x, this->number(object.radius));
    };
    return std::visit(thicken, Plain::make(object));
  }
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_KERNEL_KINDS_H
