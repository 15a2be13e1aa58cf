// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_PLAIN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_PLAIN_H

// The lanes of any processor: parts are numbers.

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

#define CGAL_LANES_TARGET

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {
namespace lanes_plain {

using Int_part = std::int32_t;
using Float_part = float;
using Double_part = double;

inline Float_part to_float(Int_part x) { return static_cast<Float_part>(x); }

template <class Number>
unsigned int bits_at_most(Number a, Number b)
{
  return a <= b;
}

#include <CGAL/Thick_intersection_d/internal/lanes/vectors.inc>

// The branch on whether a pair is near cannot be predicted. So all pairs of a row with a near one
// are stored, and the count advances only for near ones.
inline Place append_pairs(unsigned int bits, const Ints& p, const Ints& q, Found_pair* pairs,
                          Place count)
{
  if(bits == 0)
    return count;
  for(Place lane = 0; lane < lanes; ++lane) {
    pairs[count] = {static_cast<Place>(p.parts[lane]), static_cast<Place>(q.parts[lane])};
    count += bits >> lane & 1;
  }
  return count;
}

#include <CGAL/Thick_intersection_d/internal/lanes/loops.inc>

} // namespace lanes_plain
} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#undef CGAL_LANES_TARGET

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_LANES_PLAIN_H
