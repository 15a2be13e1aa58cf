// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_SORTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_SORTER_H

// Sorts lists of neighbors by the best instructions that the processor has.

#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>
#include <CGAL/Thick_intersection_d/internal/lanes/instruction_set.h>
#include <CGAL/Thick_intersection_d/internal/lanes/run_sorter_avx512.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

inline const Run_sorter& run_sorter()
{
  return instruction_set() == Instruction_set::AVX512 ? run_sorter_avx512 : plain_run_sorter;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_SORTER_H
