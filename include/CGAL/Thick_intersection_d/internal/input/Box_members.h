// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOX_MEMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOX_MEMBERS_H

// The default traits of boxes. They read a box by its member functions.

#include <type_traits>
#include <utility>

namespace CGAL {

// The boxes of CGAL know their dimension as an argument of the template of their base class. Their
// function dimension() is no constant expression. Their header is under the GPL, so it is not
// included.
namespace Box_intersection_d {
struct ID_NONE;
template <class NT, int Dimension, class IdPolicy>
class Box_d;
} // namespace Box_intersection_d

namespace Thick_intersection_d {
namespace internal {

template <class Handle, class = void>
struct Is_box : std::false_type {};
template <class Handle>
struct Is_box<Handle, std::void_t<decltype(std::declval<const Handle&>().min_coord(0))>>
  : std::true_type {};

// Returns the box itself, or the box that a pointer points to.
template <class Handle>
decltype(auto) as_box(const Handle& handle)
{
  if constexpr(Is_box<Handle>::value)
    return (handle);
  else
    return (*handle);
}

template <class Box, class NT, int Dimension,
          class Base = Box_intersection_d::Box_d<NT, Dimension, Box_intersection_d::ID_NONE>>
std::integral_constant<int, (&Box::dimension == &Base::dimension) ? Dimension : 0>
dimension_by_base(const Box_intersection_d::Box_d<NT, Dimension, Box_intersection_d::ID_NONE>*);

// The dimension of boxes that are derived from those of CGAL. It is 0 for others, and for boxes
// with a function dimension() of their own.
template <class Box, class = void>
struct Inherited_dimension : std::integral_constant<int, 0> {};
template <class Box>
struct Inherited_dimension<
  Box, std::void_t<decltype(dimension_by_base<Box>(std::declval<const Box*>()))>>
  : decltype(dimension_by_base<Box>(std::declval<const Box*>())) {};

// `BoxHandle` knows the dimension. The boxes of a second range may have another type.
template <class BoxHandle>
class Box_members
{
  using Box = std::decay_t<decltype(as_box(std::declval<const BoxHandle&>()))>;

public:
  // A constant expression if that of the box is one, or if the box is one of CGAL.
  static constexpr int dimension()
  {
    if constexpr(Inherited_dimension<Box>::value != 0)
      return Inherited_dimension<Box>::value;
    else
      return Box::dimension();
  }

  template <class Handle>
  static decltype(auto) min_coord(const Handle& handle, int axis)
  {
    return as_box(handle).min_coord(axis);
  }
  template <class Handle>
  static decltype(auto) max_coord(const Handle& handle, int axis)
  {
    return as_box(handle).max_coord(axis);
  }

  // Exists if the box has an id.
  template <class Handle>
  static auto id(const Handle& handle) -> decltype(as_box(handle).id())
  {
    return as_box(handle).id();
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOX_MEMBERS_H
