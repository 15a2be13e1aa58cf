// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_HUGE_PAGES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_HUGE_PAGES_H

// Huge pages for large arrays. The system clears each page when the search touches it first. With
// pages of 4 kB and 10^7 points in the plane, this took a quarter of the search (doc/dropped.md).

#include <cstddef>
#include <cstdint>

#if defined(__linux__) && defined(__GLIBC__) && (defined(__x86_64__) || defined(__aarch64__))
#define CGAL_THICK_INTERSECTION_D_HAS_MADVISE
// Declared here, because <sys/mman.h> defines a macro MAP_TYPE, a name in headers of CGAL.
extern "C" int madvise(void* address, std::size_t size, int advice) noexcept;
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Asks for huge pages in memory that was not touched yet. The system may refuse.
inline void advise_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t size)
{
#ifdef CGAL_THICK_INTERSECTION_D_HAS_MADVISE
  constexpr int huge_page_advice = 14; // MADV_HUGEPAGE
  constexpr std::uintptr_t page_size = std::uintptr_t(1) << 21; // a multiple of all small sizes
  const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + page_size - 1) / page_size * page_size;
  const std::uintptr_t last = (begin + size) / page_size * page_size;
  if(first < last)
    madvise(reinterpret_cast<void*>(first), last - first, huge_page_advice);
#endif
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_HUGE_PAGES_H
