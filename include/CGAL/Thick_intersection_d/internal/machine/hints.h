// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_HINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_HINTS_H

// Hints for the compiler and the processor. They change how long a program takes, and nothing that
// it does.

#include <cstddef>

// Marks a function that a search calls a few times only. The compiler makes it short instead of
// fast, which takes less time: exact numbers that are expanded in each place compile slowly.
#ifdef __GNUC__
#define CGAL_THICK_INTERSECTION_D_RARELY_CALLED __attribute__((noinline, cold))
#else
#define CGAL_THICK_INTERSECTION_D_RARELY_CALLED
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Memory may be brought to the cache ahead of time, where the processor cannot guess what the
// program will touch next. Nothing is read or written, so any address is allowed.

// How many undecided pairs ahead the memory of a pair is prefetched.
inline constexpr std::size_t prefetch_distance = 12;

// The bytes that come to the cache at once.
inline constexpr std::size_t cache_line_size = 64;

// Does nothing. GCC leaves out the calls of a function that does nothing but to prefetch, because
// it takes it for one without effects.
inline void have_effect([[maybe_unused]] const void* address)
{
#ifdef __GNUC__
  __asm__ volatile("" : : "r"(address));
#endif
}

// The program will soon read the cache line `line_count` behind the one of `address`.
inline void prefetch_to_read([[maybe_unused]] const void* address,
                             [[maybe_unused]] std::size_t line_count = 0)
{
#ifdef __GNUC__
  __builtin_prefetch(static_cast<const char*>(address) + line_count * cache_line_size, 0);
  have_effect(address);
#endif
}

// The program will soon write to the cache line `line_count` behind the one of `address`.
inline void prefetch_to_write([[maybe_unused]] const void* address,
                              [[maybe_unused]] std::size_t line_count = 0)
{
#ifdef __GNUC__
  __builtin_prefetch(static_cast<const char*>(address) + line_count * cache_line_size, 1);
  have_effect(address);
#endif
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_HINTS_H
