// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_POSITIONS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_POSITIONS_H

// Positions of elements in the user's ranges.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A position of a point, or an index into an array of points. It has 32 bits, because much of the
// time of a search goes into moving points.
using Place = std::uint32_t;

inline constexpr Place max_place = (std::numeric_limits<Place>::max)();

// Two positions, the smaller position first.
using Position_pair = std::pair<std::size_t, std::size_t>;

// Throws if there are `limit` points or more. One place is taken: it stands for no point.
inline void check_size(std::size_t size, std::size_t limit = max_place)
{
  if(size >= limit)
    throw std::length_error("There are too many points: " + std::to_string(size) + ".");
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_POSITIONS_H
