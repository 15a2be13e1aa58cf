// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_SORTER_AVX512_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_SORTER_AVX512_H

// Sorts and merges runs by sorting networks with AVX-512. Two registers hold a run.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>

#if defined(__GNUC__) && defined(__x86_64__)

#include <CGAL/Thick_intersection_d/internal/lanes/instruction_set.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

#define CGAL_THICK_INTERSECTION_D_AVX512 __attribute__((target("avx512f")))
#define CGAL_THICK_INTERSECTION_D_INLINE \
  __attribute__((target("avx512f"), always_inline)) inline

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

static_assert(max_run_size == 32 && sizeof(Place) == 4, "Two registers hold a run.");

// The compilers have these instructions without <immintrin.h>, whose 90 headers take longer to read
// than all headers of this package.
struct Run_sorter_avx512
{
  // Sorts like sort_run_by_ranks(). Lanes without a position hold the largest number, so they are
  // sorted to the end.
  CGAL_THICK_INTERSECTION_D_AVX512 static void sort(const Place* positions, Place size,
                                                    Place* sorted)
  {
    if(size < lane_count)
      store(sorted_16(load(positions, size)), sorted);
    else {
      const Register a = sorted_16(load(positions, lane_count));
      const Register b = sorted_16(load(positions + lane_count, size - lane_count));
      store(store_lesser_half(a, b, sorted), sorted + lane_count);
    }
  }

  // Merges like merge_two_runs(). Invariant: x holds the largest positions so far, and all others
  // are in `merged`.
  CGAL_THICK_INTERSECTION_D_AVX512 static void merge(const Place* run, std::ptrdiff_t size,
                                                     Place* merged)
  {
    const Place *a = run, *b = run + size;
    const Place *const end_of_a = b, *const end_of_b = b + size;
    Register x = load(a, lane_count);
    a += lane_count;
    while(a != end_of_a || b != end_of_b) {
      const bool is_b_first = (a == end_of_a) | ((b != end_of_b) & (*b < *a));
      const Register y = load(is_b_first ? b : a, lane_count);
      b += is_b_first ? lane_count : 0;
      a += is_b_first ? 0 : lane_count;
      x = store_lesser_half(x, y, merged);
      merged += lane_count;
    }
    store(x, merged);
  }

private:
  static constexpr Place lane_count = 16;
  static constexpr int all = 0xffff;

  typedef std::uint32_t Register __attribute__((vector_size(64)));
  typedef std::int32_t Signed_register __attribute__((vector_size(64)));

  // Reads as many positions as there are lanes, and keeps the first `size`.
  CGAL_THICK_INTERSECTION_D_INLINE static Register load(const Place* positions, Place size)
  {
    const Register lane = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    const Register largest = max_place - Register();
    Register x;
    std::memcpy(&x, positions, sizeof(x));
    return lane < size - Register() ? x : largest;
  }

  CGAL_THICK_INTERSECTION_D_INLINE static void store(Register x, Place* positions)
  {
    std::memcpy(positions, &x, sizeof(x));
  }

  CGAL_THICK_INTERSECTION_D_INLINE static Register least(Register x, Register y)
  {
#ifdef __clang__
    return x < y ? x : y;
#else // two instructions otherwise
    return (Register)__builtin_ia32_pminud512_mask((Signed_register)x, (Signed_register)y,
                                                   (Signed_register)x, static_cast<short>(all));
#endif
  }

  // Returns the larger numbers in the lanes of `mask`, and `others` in the other lanes.
  template <int mask>
  CGAL_THICK_INTERSECTION_D_INLINE static Register greatest(Register x, Register y, Register others)
  {
#ifdef __clang__
    const Register lane = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    const Register bits = static_cast<std::uint32_t>(mask) - Register();
    return ((bits >> lane) & 1 - Register()) != Register() ? (x < y ? y : x) : others;
#else
    return (Register)__builtin_ia32_pmaxud512_mask((Signed_register)x, (Signed_register)y,
                                                   (Signed_register)others,
                                                   static_cast<short>(mask));
#endif
  }

  // Stores the lesser half of two sorted registers in ascending order. Returns the other half.
  CGAL_THICK_INTERSECTION_D_INLINE static Register store_lesser_half(Register x, Register y,
                                                                     Place* sorted)
  {
    const Register reversed = from_lanes<15>(y);
    store(merged(least(x, reversed)), sorted);
    return merged(greatest<all>(x, reversed, x));
  }

  // Sorts by merging sorted halves of 2, 4, 8 and 16 lanes. To merge, compare the first half with
  // the reverse of the second one, and then lanes that are nearer and nearer.
  CGAL_THICK_INTERSECTION_D_INLINE static Register sorted_16(Register x)
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
  CGAL_THICK_INTERSECTION_D_INLINE static Register merged(Register x)
  {
    return merged_8(compared<8, 0xff00>(x));
  }

  CGAL_THICK_INTERSECTION_D_INLINE static Register merged_8(Register x)
  {
    x = compared<4, 0xf0f0>(x);
    x = compared<2, 0xcccc>(x);
    return compared<1, 0xaaaa>(x);
  }

  // Compares each lane with the lane whose number differs in the bits of `bits`. The lanes of
  // `upper` take the larger number, the others the smaller one.
  template <int bits, int upper>
  CGAL_THICK_INTERSECTION_D_INLINE static Register compared(Register x)
  {
    const Register y = from_lanes<bits>(x);
    return greatest<upper>(x, y, least(x, y));
  }

  // Moves to each lane what is in the lane whose number differs in the bits of `bits`.
  template <int bits>
  CGAL_THICK_INTERSECTION_D_INLINE static Register from_lanes(Register x)
  {
    return CGAL_THICK_INTERSECTION_D_SHUFFLE(
      Register, x, x, 0 ^ bits, 1 ^ bits, 2 ^ bits, 3 ^ bits, 4 ^ bits, 5 ^ bits, 6 ^ bits,
      7 ^ bits, 8 ^ bits, 9 ^ bits, 10 ^ bits, 11 ^ bits, 12 ^ bits, 13 ^ bits, 14 ^ bits,
      15 ^ bits);
  }
};

inline constexpr Run_sorter run_sorter_avx512
  = {16, Run_sorter_avx512::sort, Run_sorter_avx512::merge};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_THICK_INTERSECTION_D_AVX512
#undef CGAL_THICK_INTERSECTION_D_INLINE

#else // other compilers and processors

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

inline constexpr Run_sorter run_sorter_avx512 = plain_run_sorter;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_SORTER_AVX512_H
