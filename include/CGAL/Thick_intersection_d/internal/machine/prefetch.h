// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PREFETCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PREFETCH_H

// Asks for memory that will be used soon, where the compiler can do so.

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

inline void prefetch([[maybe_unused]] const void* memory)
{
#ifdef __GNUC__
  __builtin_prefetch(memory);
#endif
}

inline void prefetch_for_write([[maybe_unused]] const void* memory)
{
#ifdef __GNUC__
  __builtin_prefetch(memory, 1);
#endif
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PREFETCH_H
