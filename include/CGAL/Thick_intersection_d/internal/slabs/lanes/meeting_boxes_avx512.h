// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_AVX512_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_AVX512_H

// Meeting pairs of boxes with AVX-512. meeting_boxes_plain.h has the same loop, and explains it.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Box_run.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/meeting_boxes_plain.h>

#include <boost/config.hpp> // BOOST_LIKELY

#include <cstdint>

#if defined(__GNUC__) && defined(__x86_64__)

#include <immintrin.h>

#define CGAL_THICK_INTERSECTION_D_AVX512 __attribute__((target("avx512f")))

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

static_assert(lanes == 8 && sizeof(Found_pair) == 8, "A vector holds eight doubles or pairs.");

// The pairs {i, j + lane} that meet, appended to the found pairs.
class Meeting_lanes_avx512
{
public:
  CGAL_THICK_INTERSECTION_D_AVX512
  explicit Meeting_lanes_avx512(Found_pairs& found)
    : steps_(_mm512_slli_epi64(_mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0), 32)), found_(found),
      count_(found.count), row_count_(found.row_count)
  {}

  // Returns false if flush() returns false.
  template <class Flush>
  CGAL_THICK_INTERSECTION_D_AVX512 bool append(__mmask8 meets, Place i, Place j,
                                               const Flush& flush)
  {
    if(meets == 0xff)
      found_.rows[row_count_++] = {i, j};
    else
      append_pairs(meets, i, j);
    if(BOOST_LIKELY(count_ < Found_pairs::capacity && row_count_ < Found_pairs::row_capacity))
      return true;
    finish();
    const bool goes_on = flush();
    count_ = found_.count;
    row_count_ = found_.row_count;
    return goes_on;
  }

  void finish()
  {
    found_.count = count_;
    found_.row_count = row_count_;
  }

private:
  CGAL_THICK_INTERSECTION_D_AVX512 void append_pairs(__mmask8 meets, Place i, Place j)
  {
    const std::uint64_t first = static_cast<std::uint64_t>(j) << 32 | i;
    const __m512i pairs = _mm512_add_epi64(_mm512_set1_epi64(static_cast<long long>(first)),
                                           steps_);
    _mm512_storeu_si512(&found_.pairs[count_], _mm512_maskz_compress_epi64(meets, pairs));
    count_ += static_cast<Place>(__builtin_popcount(meets));
  }

  const __m512i steps_;
  Found_pairs& found_;
  Place count_;
  Place row_count_;
};

struct Meeting_boxes_avx512
{
  static bool is_supported()
  {
    static const bool is = __builtin_cpu_supports("avx512f");
    return is;
  }

  template <int Axes, class Flush>
  CGAL_THICK_INTERSECTION_D_AVX512 static void
  collect_between(const Box_run<Axes>& a, const Box_run<Axes>& b, Found_pairs& found,
                  const Flush& flush)
  {
    Meeting_lanes_avx512 lanes_of_b(found);
    const auto b_low = b.low; // copies, which stay in registers: stores cannot change them
    const auto b_high = b.high;
    for(Place i = a.first; i < a.last; ++i) {
      __m512d low[Axes];
      __m512d high[Axes];
      for(int axis = 0; axis < Axes; ++axis) {
        low[axis] = _mm512_set1_pd(a.low[axis][i]);
        high[axis] = _mm512_set1_pd(a.high[axis][i]);
      }
      const Place end = a.ends[i];
      for(Place j = a.begins[i]; j < end; j += lanes) {
        __mmask8 meets = 0xff;
        for(int axis = 0; axis < Axes; ++axis) {
          meets = _mm512_mask_cmp_pd_mask(meets, _mm512_loadu_pd(b_low[axis] + j), high[axis],
                                          _CMP_LE_OQ);
          meets = _mm512_mask_cmp_pd_mask(meets, _mm512_loadu_pd(b_high[axis] + j), low[axis],
                                          _CMP_GE_OQ);
        }
        if(!lanes_of_b.append(meets, i, j, flush))
          return;
      }
    }
    lanes_of_b.finish();
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_THICK_INTERSECTION_D_AVX512

#else // other compilers and processors

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Meeting_boxes_avx512 : Meeting_boxes_plain
{
  static bool is_supported() { return false; }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_AVX512_H
