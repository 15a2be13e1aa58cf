// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BASE_KIND_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BASE_KIND_H

// The classes of CGAL that the package knows, and those that derive from them: a segment with an id
// is the segment that its base is.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Circle_2.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Iso_rectangle_2.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Segment_2.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Sphere_3.h>
#include <CGAL/Tetrahedron_3.h>
#include <CGAL/Triangle_2.h>
#include <CGAL/Triangle_3.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A name for a type, without an object of it.
template <class T>
struct Named_type
{
  using type = T;
};

// A class and the number of vertices of its objects, or 0 if they have none.
template <class T, int Count>
struct Kind_with_vertices : Named_type<T>
{
  static constexpr int vertex_count = Count;
};

template <class Object, class = void>
struct Base_kind;

// Found by the pointer to an object of the class, or of a class that derives from it. Pairs of what
// is no object of CGAL are those of the user.
template <class K>
Kind_with_vertices<Point_2<K>, 1> base_of(const Point_2<K>*);
template <class K>
Kind_with_vertices<Point_3<K>, 1> base_of(const Point_3<K>*);
template <class K>
Kind_with_vertices<Segment_2<K>, 2> base_of(const Segment_2<K>*);
template <class K>
Kind_with_vertices<Segment_3<K>, 2> base_of(const Segment_3<K>*);
template <class K>
Kind_with_vertices<Triangle_2<K>, 3> base_of(const Triangle_2<K>*);
template <class K>
Kind_with_vertices<Triangle_3<K>, 3> base_of(const Triangle_3<K>*);
template <class K>
Kind_with_vertices<Iso_rectangle_2<K>, 4> base_of(const Iso_rectangle_2<K>*);
template <class K>
Kind_with_vertices<Iso_cuboid_3<K>, 8> base_of(const Iso_cuboid_3<K>*);
template <class K>
Kind_with_vertices<Tetrahedron_3<K>, 4> base_of(const Tetrahedron_3<K>*);
template <class K>
Kind_with_vertices<Circle_2<K>, 0> base_of(const Circle_2<K>*);
template <class K>
Kind_with_vertices<Sphere_3<K>, 0> base_of(const Sphere_3<K>*);
template <class Object, class Radius,
          class = std::enable_if_t<Base_kind<Object>::vertex_count != 0>>
Kind_with_vertices<std::pair<Object, Radius>, 0> base_of(const std::pair<Object, Radius>*);

// The class of CGAL that a class derives from, or else the class itself. A Bbox may be a part of a
// kernel object that has its box at hand.
template <class Object, class>
struct Base_kind
  : std::conditional_t<
      std::is_convertible_v<const Object*, const Bbox_2*>, Kind_with_vertices<Bbox_2, 4>,
      std::conditional_t<std::is_convertible_v<const Object*, const Bbox_3*>,
                         Kind_with_vertices<Bbox_3, 8>, Kind_with_vertices<Object, 0>>>
{};
template <class Object>
struct Base_kind<Object, std::void_t<decltype(base_of(std::declval<const Object*>()))>>
  : decltype(base_of(std::declval<const Object*>())) {};

template <class Object>
using Base_kind_t = typename Base_kind<Object>::type;

// The number of vertices of an object of a class of CGAL; 0 for other types.
template <class Object>
struct Vertex_count
  : std::integral_constant<
      int, std::is_same_v<Base_kind_t<Object>, Object> ? Base_kind<Object>::vertex_count : 0>
{};

// Returns an object as one of the class that it derives from.
template <class Object>
const Base_kind_t<Object>& as_base(const Object& object)
{
  return object;
}

// Whether a class is that of points of a kernel in the plane or in space, or derives from it.
template <class Object>
struct Is_kernel_point : std::bool_constant<Base_kind<Object>::vertex_count == 1> {};

// ---- own tests ----------------------------------------------------------------------------------

// A stand-in for the intersection test of objects of two classes of CGAL.
template <class Kind_a, class Kind_b>
struct Test_of_kinds
{
  friend Test_of_kinds do_intersect(const Kind_a&, const Kind_b&) { return {}; }
};

// An object of a class, which do_intersect() takes as such if it can, and else as its base.
template <class Object, class Test, bool = std::is_final_v<Object>>
struct Asked_object : Object, Test {};
template <class Object, class Test>
struct Asked_object<Object, Test, true> : Test
{
  operator const Object&() const;
};

template <class A, class B>
using Own_test_t = decltype(do_intersect(
  std::declval<const Asked_object<A, Test_of_kinds<Base_kind_t<A>, Base_kind_t<B>>>&>(),
  std::declval<const Asked_object<B, Test_of_kinds<Base_kind_t<A>, Base_kind_t<B>>>&>()));

// Whether objects of two classes, one of which derives from a class of CGAL, have an intersection
// test of their own, which is a better match than that of their bases.
template <class A, class B, class = void>
struct Has_own_test : std::false_type {};
template <class A, class B>
struct Has_own_test<A, B,
                    std::void_t<std::enable_if_t<!std::is_same_v<Base_kind_t<A>, A>
                                                 || !std::is_same_v<Base_kind_t<B>, B>>,
                                Own_test_t<A, B>>>
  : std::bool_constant<
      !std::is_same_v<Own_test_t<A, B>, Test_of_kinds<Base_kind_t<A>, Base_kind_t<B>>>>
{};

// The class whose predicates decide about an object. With a test of its own, a class that derives
// from one of CGAL is as another class of the user.
template <class Object>
using Kind_t = std::conditional_t<Has_own_test<Object, Object>::value, Object, Base_kind_t<Object>>;

// Returns an object as one of its kind.
template <class Object>
const Kind_t<Object>& as_kind(const Object& object)
{
  return object;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BASE_KIND_H
