// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_BINS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_BINS_H

// The neighbors that one thread finds, in any order, in bins. A bin takes the neighbors of
// consecutive points, so few that a cache holds their lists.

#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Chunked_lists.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Neighbor_bins
{
public:
  using Position = Neighbor_lists::Position;

  // The number of points of a bin. 16384 points with 20 neighbors each have lists of 1.3 MB.
  static constexpr std::size_t bin_size = 16384;

  // Whether the neighbors of a point come in ascending order.
  static constexpr bool are_sorted = false;

  // Makes bins for `size` points.
  explicit Neighbor_bins(std::size_t size) : bins_((size + bin_size - 1) / bin_size) {}

  // Puts the neighbor of the point `of` into the bin of that point.
  void add(Position of, Position neighbor)
  {
    bins_.append(of / bin_size,
                 {static_cast<std::uint16_t>(of % bin_size), static_cast<std::uint16_t>(neighbor),
                  static_cast<std::uint16_t>(neighbor >> 16)});
  }

  // Returns the number of neighbors in a bin.
  std::size_t size(std::size_t bin) const { return bins_.size(bin); }

  // Calls task(of, first, last) for each neighbor in a bin, as a list of one neighbor. `of` counts
  // from the first point of the bin.
  template <class Task>
  void for_each(std::size_t bin, const Task& task) const
  {
    bins_.for_each(bin, [&](const Neighbor& neighbor) {
      const Position position = neighbor.low | static_cast<Position>(neighbor.high) << 16;
      task(neighbor.of, &position, &position + 1);
      return true;
    });
  }

  // Frees the memory of all neighbors. None can be added or read then.
  void clear() { bins_.clear(); }

private:
  // It has six bytes, because moving neighbors takes much of the time.
  struct Neighbor
  {
    std::uint16_t of;
    std::uint16_t low;
    std::uint16_t high;
  };

  static constexpr std::size_t chunk_size = 1024; // neighbors

  Chunked_lists<Neighbor, chunk_size> bins_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_BINS_H
