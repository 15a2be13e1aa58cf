// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_AVX512_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_AVX512_H

// Near pairs of points with AVX-512. One instruction compresses the near pairs of eight lanes into
// consecutive memory. This reports many pairs in space twice as fast (doc/design.md).
// near_points_plain.h has the same loops, and explains them.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_question.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/near_points_plain.h>

#include <algorithm>
#include <cstdint>

#if defined(__GNUC__) && defined(__x86_64__)

#include <immintrin.h>

#define CGAL_THICK_INTERSECTION_D_AVX512 __attribute__((target("avx512f")))

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

static_assert(lanes == 8 && sizeof(Found_pair) == 8, "A vector holds eight doubles or pairs.");

// The near pairs of eight lanes: {i + lane, j + lane} or {i + lane, j}, for growing j.
class Near_lanes_avx512
{
public:
  CGAL_THICK_INTERSECTION_D_AVX512
  Near_lanes_avx512(const Distance_filter& filter, Found_pairs& found)
    : inside_(_mm512_set1_pd(filter.inside)), outside_(_mm512_set1_pd(filter.outside)),
      found_(found), count_(found.count)
  {}

  template <bool moves_j>
  CGAL_THICK_INTERSECTION_D_AVX512 void start(Place i, Place j)
  {
    const __m512i lane = _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0);
    const __m512i step = moves_j ? _mm512_or_si512(lane, _mm512_slli_epi64(lane, 32)) : lane;
    const std::uint64_t first = static_cast<std::uint64_t>(j) << 32 | i;
    pairs_ = _mm512_add_epi64(_mm512_set1_epi64(static_cast<long long>(first)), step);
  }

  // Appends the pairs whose squared distance is not certainly beyond the bound, and goes on to the
  // next j. Returns false if flush() returns false.
  template <class Flush>
  CGAL_THICK_INTERSECTION_D_AVX512 bool append(__m512d squared_distances, const Flush& flush)
  {
    const __mmask8 near = _mm512_cmp_pd_mask(squared_distances, outside_, _CMP_LE_OQ);
    undecided_ |= near & _mm512_cmp_pd_mask(squared_distances, inside_, _CMP_GT_OQ);
    _mm512_storeu_si512(&found_.pairs[count_], _mm512_maskz_compress_epi64(near, pairs_));
    count_ += static_cast<Place>(__builtin_popcount(near));
    pairs_ = _mm512_add_epi64(pairs_, _mm512_set1_epi64(1LL << 32));
    if(count_ < Found_pairs::capacity)
      return true;
    finish();
    const bool goes_on = flush();
    count_ = found_.count;
    undecided_ = 0;
    return goes_on;
  }

  void finish()
  {
    found_.count = count_;
    found_.is_any_undecided |= undecided_ != 0;
  }

private:
  const __m512d inside_;
  const __m512d outside_;
  __m512i pairs_;
  Found_pairs& found_;
  Place count_;
  unsigned int undecided_ = 0;
};

struct Near_points_avx512
{
  static bool is_supported()
  {
    static const bool is = __builtin_cpu_supports("avx512f");
    return is;
  }

  template <int Dimension, class Flush>
  CGAL_THICK_INTERSECTION_D_AVX512 static void
  collect_within(const Run<Dimension>& run, Near_question near, Found_pairs& found,
                 const Flush& flush)
  {
    const __m512d reach = _mm512_set1_pd(near.reach);
    Near_lanes_avx512 lanes_of_run(near.filter, found);
    for(Place i = 0; i < run.size; i += lanes) {
      __m512d p[Dimension];
      for(int axis = 0; axis < Dimension; ++axis)
        p[axis] = _mm512_loadu_pd(run.x[axis] + i);
      lanes_of_run.start<true>(i, i + 1);
      for(Place j = i + 1;; ++j) {
        __m512d gap = _mm512_sub_pd(_mm512_loadu_pd(run.x[0] + j), p[0]);
        if(_mm512_cmp_pd_mask(gap, reach, _CMP_LE_OQ) == 0)
          break;
        __m512d s = _mm512_mul_pd(gap, gap);
        for(int axis = 1; axis < Dimension; ++axis) {
          gap = _mm512_sub_pd(_mm512_loadu_pd(run.x[axis] + j), p[axis]);
          s = _mm512_add_pd(s, _mm512_mul_pd(gap, gap));
        }
        if(!lanes_of_run.append(s, flush))
          return;
      }
    }
    lanes_of_run.finish();
  }

  template <int Dimension, class Flush>
  CGAL_THICK_INTERSECTION_D_AVX512 static void
  collect_between(const Run<Dimension>& a, const Run<Dimension>& b, Near_question near,
                  Found_pairs& found, const Flush& flush)
  {
    Place first = 0;
    Near_lanes_avx512 lanes_of_a(near.filter, found);
    for(Place i = 0; i < a.size; i += lanes) {
      const double low = a.x[0][i] - near.reach;
      while(b.x[0][first] < low)
        ++first;
      const double high = a.x[0][(std::min)(i + lanes, a.size) - 1] + near.reach;
      __m512d p[Dimension];
      for(int axis = 0; axis < Dimension; ++axis)
        p[axis] = _mm512_loadu_pd(a.x[axis] + i);
      lanes_of_a.start<false>(i, first);
      for(Place j = first; b.x[0][j] <= high; ++j) {
        __m512d s = _mm512_setzero_pd();
        for(int axis = 0; axis < Dimension; ++axis) {
          const __m512d gap = _mm512_sub_pd(p[axis], _mm512_set1_pd(b.x[axis][j]));
          s = _mm512_add_pd(s, _mm512_mul_pd(gap, gap));
        }
        if(!lanes_of_a.append(s, flush))
          return;
      }
    }
    lanes_of_a.finish();
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

struct Near_points_avx512 : Near_points_plain
{
  static bool is_supported() { return false; }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_AVX512_H
