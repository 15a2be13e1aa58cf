// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_AVX512_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_AVX512_H

// Short lists in ascending order, by sorting networks with AVX-512. Two registers hold a list.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Short_list.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/short_lists_plain.h>

#if defined(__GNUC__) && defined(__x86_64__)

#include <immintrin.h>

#define CGAL_THICK_INTERSECTION_D_AVX512 __attribute__((target("avx512f")))
#define CGAL_THICK_INTERSECTION_D_INLINE \
  __attribute__((target("avx512f"), always_inline)) inline

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

static_assert(Short_list::capacity == 32 && sizeof(Place) == 4, "Two registers hold a list.");

struct Short_lists_avx512
{
  static bool is_supported()
  {
    static const bool is = __builtin_cpu_supports("avx512f");
    return is;
  }

  // Sorts like Short_lists_plain. Lanes without a position hold the largest number, so they are
  // sorted to the end.
  CGAL_THICK_INTERSECTION_D_AVX512 static void sort(const Short_list& list, Place size,
                                                    Place* sorted)
  {
    const __m512i largest = _mm512_set1_epi32(-1);
    const unsigned int rest = size % lane_count;
    const __mmask16 last = static_cast<__mmask16>((1u << rest) - 1);
    const Place* const positions = list.positions.data();
    if(size < lane_count)
      _mm512_storeu_si512(sorted, sorted_16(_mm512_mask_loadu_epi32(largest, last, positions)));
    else {
      const __mmask16 second = size == 2 * lane_count ? all : last;
      const __m512i a = sorted_16(_mm512_loadu_si512(positions));
      const __m512i b
        = sorted_16(_mm512_mask_loadu_epi32(largest, second, positions + lane_count));
      const __m512i b_reversed = from_lanes<15>(b);
      _mm512_storeu_si512(sorted, merged(least(a, b_reversed)));
      _mm512_storeu_si512(sorted + lane_count,
                          merged(_mm512_maskz_max_epu32(all, a, b_reversed)));
    }
  }

private:
  static constexpr Place lane_count = 16;

  // Instructions with this mask are those without a mask. GCC 12 warns of the latter.
  static constexpr __mmask16 all = 0xffff;

  CGAL_THICK_INTERSECTION_D_INLINE static __m512i least(__m512i x, __m512i y)
  {
    return _mm512_maskz_min_epu32(all, x, y);
  }

  // Sorts by merging sorted halves of 2, 4, 8 and 16 lanes. To merge, compare the first half with
  // the reverse of the second one, and then lanes that are nearer and nearer.
  CGAL_THICK_INTERSECTION_D_INLINE static __m512i sorted_16(__m512i x)
  {
    x = compared<1, 0xaaaa>(x);
    x = compared<3, 0xcccc>(x);
    x = compared<1, 0xaaaa>(x);
    x = compared<7, 0xf0f0>(x);
    x = compared<2, 0xcccc>(x);
    x = compared<1, 0xaaaa>(x);
    x = compared<15, 0xff00>(x);
    return merged_8(x);
  }

  // Sorts numbers that rise and then fall, or fall and then rise.
  CGAL_THICK_INTERSECTION_D_INLINE static __m512i merged(__m512i x)
  {
    return merged_8(compared<8, 0xff00>(x));
  }

  CGAL_THICK_INTERSECTION_D_INLINE static __m512i merged_8(__m512i x)
  {
    x = compared<4, 0xf0f0>(x);
    x = compared<2, 0xcccc>(x);
    return compared<1, 0xaaaa>(x);
  }

  // Compares each lane with the lane whose number differs in the bits of `bits`. The lanes of
  // `upper` take the larger number, the others the smaller one.
  template <int bits, int upper>
  CGAL_THICK_INTERSECTION_D_INLINE static __m512i compared(__m512i x)
  {
    const __m512i y = from_lanes<bits>(x);
    return _mm512_mask_max_epu32(least(x, y), static_cast<__mmask16>(upper), x, y);
  }

  // Moves to each lane what is in the lane whose number differs in the bits of `bits`.
  template <int bits>
  CGAL_THICK_INTERSECTION_D_INLINE static __m512i from_lanes(__m512i x)
  {
    const __m512i lane
      = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    return _mm512_maskz_permutexvar_epi32(all, _mm512_xor_si512(lane, _mm512_set1_epi32(bits)), x);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_THICK_INTERSECTION_D_AVX512
#undef CGAL_THICK_INTERSECTION_D_INLINE

#else // other compilers and processors

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Short_lists_avx512 : Short_lists_plain
{
  static bool is_supported() { return false; }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_AVX512_H
