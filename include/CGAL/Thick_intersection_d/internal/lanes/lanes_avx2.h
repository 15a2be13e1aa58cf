// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_AVX2_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_AVX2_H

// The lanes of AVX2, on processors that fuse multiplications and additions.

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

#define CGAL_LANES_TARGET __attribute__((target("avx2,fma,popcnt")))

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {
namespace lanes_avx2 {

typedef std::int32_t Int_part __attribute__((vector_size(32)));
typedef float Float_part __attribute__((vector_size(32)));
typedef double Double_part __attribute__((vector_size(32)));

CGAL_LANES_TARGET inline Float_part to_float(Int_part x)
{
  return __builtin_convertvector(x, Float_part);
}

template <class Part>
CGAL_LANES_TARGET inline unsigned int bits_at_most(Part a, Part b)
{
  return static_cast<unsigned int>(__builtin_ia32_movmskps256((Float_part)(a <= b)));
}
CGAL_LANES_TARGET inline unsigned int bits_at_most(Double_part a, Double_part b)
{
  return static_cast<unsigned int>(__builtin_ia32_movmskpd256((Double_part)(a <= b)));
}

#include <CGAL/Thick_intersection_d/internal/lanes/vectors.inc>

// For each set of lanes, their numbers in order, with four bits for each: 1 kB, where vectors would
// take eight.
struct Lanes_in_order
{
  constexpr Lanes_in_order()
  {
    for(unsigned int bits = 0; bits < 256; ++bits)
      for(unsigned int lane = 0, count = 0; lane < 8; ++lane)
        if((bits >> lane & 1) != 0)
          of[bits] |= lane << 4 * count++;
  }

  std::uint32_t of[256] = {};
};
inline constexpr Lanes_in_order lanes_in_order;

// Returns the order for a permutation, which looks at the lowest three bits of each lane alone.
// Each lane takes the number at a place of the order: `places` has four times these places.
CGAL_LANES_TARGET inline Int_part order_of(unsigned int bits, Int_part places)
{
  return (Int_part{} + static_cast<std::int32_t>(lanes_in_order.of[bits])) >> places;
}

// Moves the pairs of these lanes to the front, and stores all eight. Each half of two registers is
// interleaved by itself, so the lower half takes the numbers of pairs 0, 1, 4 and 5.
CGAL_LANES_TARGET inline void store_pairs(unsigned int bits, Int_part p, Int_part q,
                                          Found_pair* pairs)
{
  const Int_part order = order_of(bits, Int_part{0, 4, 16, 20, 8, 12, 24, 28});
  const Int_part a = __builtin_ia32_permvarsi256(p, order);
  const Int_part b = __builtin_ia32_permvarsi256(q, order);
  const Int_part first
    = CGAL_THICK_INTERSECTION_D_SHUFFLE(Int_part, a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Int_part second
    = CGAL_THICK_INTERSECTION_D_SHUFFLE(Int_part, a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  std::memcpy(pairs, &first, sizeof(first));
  std::memcpy(pairs + 4, &second, sizeof(second));
}

CGAL_LANES_TARGET inline Place append_pairs(unsigned int bits, const Ints& p, const Ints& q,
                                            Found_pair* pairs, Place count)
{
  store_pairs(bits, p.parts[0], q.parts[0], pairs + count);
  return count + static_cast<Place>(__builtin_popcount(bits));
}

// As in vectors.inc, by one permutation.
CGAL_LANES_TARGET inline Place store_lanes(unsigned int bits, const Ints& v, std::int32_t* to)
{
  const Int_part order = order_of(bits, Int_part{0, 4, 8, 12, 16, 20, 24, 28});
  const Int_part front = __builtin_ia32_permvarsi256(v.parts[0], order);
  std::memcpy(to, &front, sizeof(front));
  return static_cast<Place>(__builtin_popcount(bits));
}

#include <CGAL/Thick_intersection_d/internal/lanes/loops.inc>

} // namespace lanes_avx2
} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_LANES_TARGET

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_AVX2_H
