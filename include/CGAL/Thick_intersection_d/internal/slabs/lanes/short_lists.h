// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_H

// Short lists in ascending order, by the best instructions that the processor has. Each
// instruction set has a file of its own.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/instruction_set.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/short_lists_avx512.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/short_lists_plain.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Writes the first `size` of some positions to `sorted` in ascending order. There is room for a
// whole list in either place.
inline void sort_short_list(const Place* positions, Place size, Place* sorted)
{
  if(instruction_set() == Instruction_set::AVX512)
    Short_lists_avx512::sort(positions, size, sorted);
  else
    Short_lists_plain::sort(positions, size, sorted);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_H
