// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOX_MEMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOX_MEMBERS_H

// The default traits of boxes. They read a box by its member functions.

#include <type_traits>
#include <utility>

namespace CGAL {
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

// `BoxHandle` knows the dimension. The boxes of a second range may have another type.
template <class BoxHandle>
class Box_members
{
  using Box = std::decay_t<decltype(as_box(std::declval<const BoxHandle&>()))>;

public:
  static constexpr int dimension() { return Box::dimension(); }

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
