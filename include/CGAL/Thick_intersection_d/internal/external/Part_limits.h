// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PART_LIMITS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PART_LIMITS_H

// How a budget of memory is shared.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Part_limits
{
public:
  // `point_size` is that of a point with its id.
  Part_limits(std::size_t bytes, std::size_t point_size) : bytes_(bytes), point_size_(point_size) {}

  // Tiles have a chunk in memory each. All of these share an eighth of the budget.
  std::size_t tile_count() const { return bytes_ < most_tiles << 16 ? 64 : most_tiles; }

  // Large chunks are written and read faster: 10^7 points in the plane took 1.3 times as long with
  // 512 points each. Pages hold whole chunks where the budget allows this.
  std::size_t points_per_chunk() const
  {
    const std::size_t fair = bytes_ / 8 / (tile_count() * point_size_);
    const std::size_t of_pages = fair < points_per_pages ? fair : fair / points_per_pages
                                                                   * points_per_pages;
    return (std::min)((std::max)(of_pages, std::size_t(4)), std::size_t(4096));
  }

  // The points of a sample, which takes a sixteenth of the budget, with the cuts made of it.
  std::size_t points_per_sample() const
  {
    const std::size_t fair = bytes_ / 16 / 64 & ~std::size_t(1);
    return (std::min)(fair, std::size_t(1) << 13);
  }

  // The points that are searched at the same time. A search takes up to 30 bytes for each of them
  // (benchmark/results.md, memory), and has places for less than half as many as places can tell
  // apart.
  std::size_t points_per_search() const
  {
    return (std::min)(bytes_ / 16 * 13 / (point_size_ + 30), std::size_t(max_place / 2 - 1));
  }

private:
  static constexpr std::size_t most_tiles = 128;
  static constexpr std::size_t points_per_pages = 512;

  std::size_t bytes_;
  std::size_t point_size_;
};

[[noreturn]] inline void refuse_crowd(std::size_t points_per_search)
{
  throw std::length_error("The points near a part of the points do not fit in the memory budget, "
                          "which has room for " + std::to_string(points_per_search)
                          + " points: take a larger budget or a smaller bound.");
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PART_LIMITS_H
