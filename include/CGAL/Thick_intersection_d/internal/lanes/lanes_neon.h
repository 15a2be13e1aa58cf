// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_NEON_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_NEON_H

// The lanes of NEON, which every processor of AArch64 has. The file is empty for other processors.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__GNUC__) && defined(__aarch64__)

#include <arm_neon.h>

#define CGAL_LANES_TARGET

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {
namespace lanes_neon {

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
  const Int_part bit = {1, 2, 4, 8};
  return static_cast<unsigned int>(vaddvq_s32((int32x4_t)((Int_part)(a <= b) & bit)));
}
CGAL_LANES_TARGET inline unsigned int bits_at_most(Double_part a, Double_part b)
{
  const auto is = a <= b;
  return static_cast<unsigned int>((is[0] & 1) | (is[1] & 2));
}

#include <CGAL/Thick_intersection_d/internal/lanes/vectors.inc>

// The branch on whether a pair is near cannot be predicted. So all pairs of a row with a near one
// are stored, and the count advances only for near ones.
CGAL_LANES_TARGET inline Place append_pairs(unsigned int bits, const Ints& p, const Ints& q,
                                            Found_pair* pairs, Place count)
{
  if(bits == 0)
    return count;
  for(Place k = 0; k < Ints::part_count; ++k)
    for(Place lane = 0; lane < Ints::lanes_per_part; ++lane) {
      pairs[count] = {static_cast<Place>(p.parts[k][lane]), static_cast<Place>(q.parts[k][lane])};
      count += bits >> (k * Ints::lanes_per_part + lane) & 1;
    }
  return count;
}

#include <CGAL/Thick_intersection_d/internal/lanes/loops.inc>

} // namespace lanes_neon
} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_LANES_TARGET

#endif // AArch64

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_NEON_H
