// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_AVX512_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_AVX512_H

// The lanes of AVX-512, with the vectors of 256 bits that AVX512VL has.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/lanes/lanes_avx2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#define CGAL_LANES_TARGET __attribute__((target("avx2,fma,popcnt,avx512f,avx512vl")))

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {
namespace lanes_avx512 {

typedef std::int32_t Int_part __attribute__((vector_size(32)));
typedef float Float_part __attribute__((vector_size(32)));
typedef double Double_part __attribute__((vector_size(64)));

CGAL_LANES_TARGET inline Float_part to_float(Int_part x)
{
  return __builtin_convertvector(x, Float_part);
}

template <class Part>
CGAL_LANES_TARGET inline unsigned int bits_at_most(Part a, Part b)
{
  return static_cast<unsigned int>(__builtin_ia32_movmskps256((Float_part)(a <= b)));
}
// Of the lanes in `bits`: one instruction, which leaves the bits where the next one needs them.
CGAL_LANES_TARGET inline unsigned char bits_at_most(Double_part a, Double_part b,
                                                    unsigned char bits)
{
  constexpr int is_at_most = 18, current_rounding = 4;
  return static_cast<unsigned char>(__builtin_ia32_cmppd512_mask(
    a, b, is_at_most, static_cast<char>(bits), current_rounding));
}
CGAL_LANES_TARGET inline unsigned int bits_at_most(Double_part a, Double_part b)
{
  return bits_at_most(a, b, 0xff);
}

#include <CGAL/Thick_intersection_d/internal/lanes/vectors.inc>

// By the instructions of AVX2: to compress pairs of 64 bits takes longer, as they are made first.
CGAL_LANES_TARGET inline Place append_pairs(unsigned int bits, const Ints& p, const Ints& q,
                                            Found_pair* pairs, Place count)
{
  lanes_avx2::store_pairs(bits, p.parts[0], q.parts[0], pairs + count);
  return count + static_cast<Place>(__builtin_popcount(bits));
}

// As in vectors.inc: one instruction moves these lanes to the front.
CGAL_LANES_TARGET inline Place store_lanes(unsigned int bits, const Ints& v, std::int32_t* to)
{
  const Int_part front = __builtin_ia32_compresssi256_mask(v.parts[0], Int_part(),
                                                           static_cast<unsigned char>(bits));
  std::memcpy(to, &front, sizeof(front));
  return static_cast<Place>(__builtin_popcount(bits));
}
CGAL_LANES_TARGET inline Place store_lanes(unsigned int bits, const Doubles& v, double* to)
{
  const Double_part front = __builtin_ia32_compressdf512_mask(v.parts[0], Double_part(),
                                                              static_cast<unsigned char>(bits));
  std::memcpy(to, &front, sizeof(front));
  return static_cast<Place>(__builtin_popcount(bits));
}

#include <CGAL/Thick_intersection_d/internal/lanes/loops.inc>

} // namespace lanes_avx512
} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_LANES_TARGET

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_AVX512_H
