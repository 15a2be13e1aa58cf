// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_FIRST_SUPPORTED_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_FIRST_SUPPORTED_H

// Chooses the instruction set while the program runs.

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Finds pairs by the first kind of lanes that the processor supports. All kinds collect the
// same pairs in the same order, but a kind may leave out near ties that are beyond the bound.
template <class First, class... Others>
struct First_supported
{
  template <class... Arguments>
  static void collect_within(Arguments&&... arguments)
  {
    if constexpr(sizeof...(Others) == 0)
      First::collect_within(arguments...);
    else if(First::is_supported())
      First::collect_within(arguments...);
    else
      First_supported<Others...>::collect_within(arguments...);
  }

  template <class... Arguments>
  static void collect_between(Arguments&&... arguments)
  {
    if constexpr(sizeof...(Others) == 0)
      First::collect_between(arguments...);
    else if(First::is_supported())
      First::collect_between(arguments...);
    else
      First_supported<Others...>::collect_between(arguments...);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_FIRST_SUPPORTED_H
