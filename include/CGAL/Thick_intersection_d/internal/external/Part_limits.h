// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PART_LIMITS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PART_LIMITS_H

// How a budget of memory is shared.

#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Part_limits
{
public:
  // Parts are cut into at most so many parts at a time.
  static constexpr int most_parts = 64;

  // Throws std::invalid_argument if the budget is too small for any search.
  explicit Part_limits(std::size_t bytes) : bytes_(bytes)
  {
    if(bytes < least_bytes)
      throw std::invalid_argument("The memory budget is less than 64 KiB.");
  }

  // The points of a chunk. A part that is cut and the parts that it becomes have two lists each,
  // and each list may have a chunk in memory; they share an eighth of the budget.
  std::size_t points_per_chunk() const
  {
    const std::size_t fair = bytes_ / 8 / (2 * most_parts * sizeof(Stored_point));
    return (std::min)((std::max)(fair, std::size_t(4)), std::size_t(2048));
  }

  // The points of a sample, which takes a sixteenth of the budget, with the cuts made of it.
  std::size_t points_per_sample() const
  {
    const std::size_t fair = bytes_ / 16 / 64 & ~std::size_t(1);
    return (std::min)(fair, std::size_t(1) << 16);
  }

  // The points that are searched at the same time.
  std::size_t points_per_search() const { return bytes_ / 16 * 13 / bytes_per_point; }

private:
  static constexpr std::size_t least_bytes = 1 << 16;

  // A point has 24 bytes and a position of 8. A search takes up to 30 bytes more
  // (benchmark/results.md, memory).
  static constexpr std::size_t bytes_per_point = 64;

  std::size_t bytes_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PART_LIMITS_H
