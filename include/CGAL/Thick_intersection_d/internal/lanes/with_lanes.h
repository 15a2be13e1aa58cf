// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_WITH_LANES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_WITH_LANES_H

// Calls the lanes of the instruction set.

#include <CGAL/Thick_intersection_d/internal/lanes/instruction_set.h>

#if defined(__GNUC__) && defined(__x86_64__)
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_avx2.h>
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_avx512.h>
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_sse2.h>
#elif defined(__GNUC__) && defined(__aarch64__)
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_neon.h>
#else
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_plain.h>
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Calls task(lanes), with an object that has the functions of loops.inc.
template <class Task>
void with_lanes(const Task& task)
{
#if defined(__GNUC__) && defined(__x86_64__)
  switch(instruction_set()) {
  case Instruction_set::AVX512: return task(lanes_avx512::Lanes());
  case Instruction_set::AVX2: return task(lanes_avx2::Lanes());
  default: return task(lanes_sse2::Lanes());
  }
#elif defined(__GNUC__) && defined(__aarch64__)
  task(lanes_neon::Lanes());
#else
  task(lanes_plain::Lanes());
#endif
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_WITH_LANES_H
