// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_INSTRUCTION_SET_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_INSTRUCTION_SET_H

// The instruction set that lanes use, and how compilers call one of its functions.

// A vector of the elements of two others: those with the given numbers, where the elements of the
// second one follow those of the first. GCC has had the function of Clang since version 12.
#if defined(__clang__) || __GNUC__ >= 12
#define CGAL_THICK_INTERSECTION_D_SHUFFLE(Vector, a, b, ...) \
  __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define CGAL_THICK_INTERSECTION_D_SHUFFLE(Vector, a, b, ...) \
  __builtin_shuffle(a, b, Vector{__VA_ARGS__})
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

enum class Instruction_set { PLAIN, SSE2, AVX2, AVX512, NEON };

inline Instruction_set best_instruction_set()
{
#if defined(__GNUC__) && defined(__x86_64__)
  if(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl"))
    return Instruction_set::AVX512;
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? Instruction_set::AVX2
                                                                         : Instruction_set::SSE2;
#elif defined(__GNUC__) && defined(__aarch64__)
  return Instruction_set::NEON;
#else
  return Instruction_set::PLAIN;
#endif
}

// The best one that the processor has. Tests and measurements take others, while nothing is
// searched: all of them find the same pairs in the same order, but near ties differ.
inline Instruction_set& instruction_set()
{
  static Instruction_set set = best_instruction_set();
  return set;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_INSTRUCTION_SET_H
