// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_HAS_GROUPS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_HAS_GROUPS_H

// Whether objects are in groups, and pairs of groups are looked for. Then most pairs of objects may
// be of no use: those within a group, and those of two groups that are known to be a pair.

#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether a class has a constant `has_groups` that is true. Then it also has
//
//   group_of(i)      the number of the group of an object
//   is_wanted(i, j)  whether a pair of these objects would tell a pair of groups that is not known.
//                    This depends on the groups alone. Two groups are no longer wanted when two of
//                    their objects have been a pair.
template <class T, class = void>
inline constexpr bool has_groups_v = false;
template <class T>
inline constexpr bool has_groups_v<T, std::enable_if_t<T::has_groups>> = true;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_HAS_GROUPS_H
