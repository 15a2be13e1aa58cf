// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_RUN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_RUN_H

// Points in the order of axis 0, as columns, for lanes to sweep.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// How many pairs are computed at once.
inline constexpr Place lanes = 8;

// Behind the last point there are `lanes` points whose coordinate along axis 0 is NaN. They are not
// near any point, so they end all loops.
template <int Dimension>
struct Run
{
  std::array<const double*, Dimension> x;
  const Place* positions;
  Place size;

  // Returns one of `count` blocks of the run. A sweep starts from the points of the block, and
  // meets the points behind the block as well.
  Run block(Place index, Place count) const
  {
    const std::uint64_t groups = (size + lanes - 1) / lanes;
    const Place begin = static_cast<Place>(groups * index / count * lanes);
    const Place end = static_cast<Place>(groups * (index + 1) / count * lanes);
    Run block = *this;
    for(const double*& column : block.x)
      column += begin;
    block.positions += begin;
    block.size = (std::min)(end, size) - begin;
    return block;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_RUN_H
