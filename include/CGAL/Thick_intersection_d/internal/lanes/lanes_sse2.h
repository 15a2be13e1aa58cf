// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_SSE2_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_SSE2_H

// The lanes of SSE2, which every processor of x86-64 has.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/lanes/instruction_set.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#define CGAL_LANES_TARGET

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {
namespace lanes_sse2 {

typedef std::int32_t Int_part __attribute__((vector_size(16)));
typedef float Float_part __attribute__((vector_size(16)));
typedef double Double_part __attribute__((vector_size(16)));

CGAL_LANES_TARGET inline Float_part to_float(Int_part x)
{
  return __builtin_convertvector(x, Float_part);
}

template <class Part>
CGAL_LANES_TARGET inline unsigned int bits_at_most(Part a, Part b)
{
  return static_cast<unsigned int>(__builtin_ia32_movmskps((Float_part)(a <= b)));
}
CGAL_LANES_TARGET inline unsigned int bits_at_most(Double_part a, Double_part b)
{
  return static_cast<unsigned int>(__builtin_ia32_movmskpd((Double_part)(a <= b)));
}

#include <CGAL/Thick_intersection_d/internal/lanes/vectors.inc>

CGAL_LANES_TARGET inline void store_two_pairs(Int_part two, Found_pair* pairs, Place& count,
                                              unsigned int bits)
{
  typedef long long Quads __attribute__((vector_size(16)));
  const Quads quads = (Quads)two;
  const long long first = quads[0], second = quads[1];
  std::memcpy(pairs + count, &first, sizeof(first));
  count += bits & 1;
  std::memcpy(pairs + count, &second, sizeof(second));
  count += bits >> 1 & 1;
}

// The branch on whether a pair is near cannot be predicted. So all pairs of a row with a near one
// are stored, and the count advances only for near ones.
CGAL_LANES_TARGET inline Place append_pairs(unsigned int bits, const Ints& p, const Ints& q,
                                            Found_pair* pairs, Place count)
{
  if(bits == 0)
    return count;
  for(Place k = 0; k < Ints::part_count; ++k, bits >>= 4) {
    const Int_part a = p.parts[k];
    const Int_part b = q.parts[k];
    store_two_pairs(CGAL_THICK_INTERSECTION_D_SHUFFLE(Int_part, a, b, 0, 4, 1, 5), pairs, count,
                    bits);
    store_two_pairs(CGAL_THICK_INTERSECTION_D_SHUFFLE(Int_part, a, b, 2, 6, 3, 7), pairs, count,
                    bits >> 2);
  }
  return count;
}

#include <CGAL/Thick_intersection_d/internal/lanes/loops.inc>

} // namespace lanes_sse2
} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_LANES_TARGET

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_SSE2_H
