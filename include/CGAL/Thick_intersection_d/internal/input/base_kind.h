// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BASE_KIND_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BASE_KIND_H

// Classes that derive from those of CGAL: a segment with an id is the segment that its base is.

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

// Found by the pointer to an object of the class, or of a class that derives from it.
template <class K>
Named_type<Point_2<K>> base_of(const Point_2<K>*);
template <class K>
Named_type<Point_3<K>> base_of(const Point_3<K>*);
template <class K>
Named_type<Segment_2<K>> base_of(const Segment_2<K>*);
template <class K>
Named_type<Segment_3<K>> base_of(const Segment_3<K>*);
template <class K>
Named_type<Triangle_2<K>> base_of(const Triangle_2<K>*);
template <class K>
Named_type<Triangle_3<K>> base_of(const Triangle_3<K>*);
template <class K>
Named_type<Iso_rectangle_2<K>> base_of(const Iso_rectangle_2<K>*);
template <class K>
Named_type<Iso_cuboid_3<K>> base_of(const Iso_cuboid_3<K>*);
template <class K>
Named_type<Tetrahedron_3<K>> base_of(const Tetrahedron_3<K>*);
template <class K>
Named_type<Circle_2<K>> base_of(const Circle_2<K>*);
template <class K>
Named_type<Sphere_3<K>> base_of(const Sphere_3<K>*);
// Templates, so that no base of a class with two of these bases comes first.
template <int = 2>
Named_type<Bbox_2> base_of(const Bbox_2*);
template <int = 3>
Named_type<Bbox_3> base_of(const Bbox_3*);

// The class of CGAL that a class derives from, or else the class itself.
template <class Object, class = void>
struct Base_kind : Named_type<Object> {};
template <class Object>
struct Base_kind<Object, std::void_t<decltype(base_of(std::declval<const Object*>()))>>
  : decltype(base_of(std::declval<const Object*>())) {};

// A stand-in for the intersection test of objects of a class of CGAL.
template <class Kind>
struct Test_of_kind
{
  friend Test_of_kind do_intersect(const Kind&, const Kind&) { return {}; }
};

// An object of a class, which does_intersect() takes as such if it can, and else as its base.
template <class Object, class Kind>
struct Asked_object : Object, Test_of_kind<Kind> {};

// Whether a class that derives from one of CGAL has an intersection test of its own, which is a
// better match than that of its base.
template <class Object, class Kind, class = void>
struct Has_own_test : std::false_type {};
template <class Object, class Kind>
struct Has_own_test<
  Object, Kind,
  std::void_t<std::enable_if_t<!std::is_same_v<Object, Kind> && !std::is_final_v<Object>>,
              decltype(do_intersect(std::declval<const Asked_object<Object, Kind>&>(),
                                    std::declval<const Asked_object<Object, Kind>&>()))>>
  : std::bool_constant<
      !std::is_same_v<decltype(do_intersect(std::declval<const Asked_object<Object, Kind>&>(),
                                            std::declval<const Asked_object<Object, Kind>&>())),
                      Test_of_kind<Kind>>>
{};

// The class whose predicates decide about an object.
template <class Object>
using Kind_t
  = std::conditional_t<Has_own_test<Object, typename Base_kind<Object>::type>::value, Object,
                       typename Base_kind<Object>::type>;

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
