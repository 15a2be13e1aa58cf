// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_BINS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_BINS_H

// Neighbors in any order, thrown into bins by one thread. A bin is for as many consecutive points
// as have their lists in a cache.

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

  // The points of a bin: 16384 of them have lists of 1.3 MB for 20 neighbors each.
  static constexpr std::size_t bin_size = 16384;

  // Makes bins for `size` points.
  explicit Neighbor_bins(std::size_t size) : bins_((size + bin_size - 1) / bin_size) {}

  // Throws the neighbor of a point into the bin of that point.
  void add(Position of, Position neighbor)
  {
    bins_.append(of / bin_size,
                 {static_cast<std::uint16_t>(of % bin_size), static_cast<std::uint16_t>(neighbor),
                  static_cast<std::uint16_t>(neighbor >> 16)});
  }

  // Returns the number of neighbors in a bin.
  std::size_t size(std::size_t bin) const { return bins_.size(bin); }

  // Calls task(of, neighbor) for those in a bin, where `of` is counted from its first point.
  template <class Task>
  void for_each(std::size_t bin, const Task& task) const
  {
    bins_.for_each(bin, [&](const Neighbor& neighbor) {
      task(neighbor.of, neighbor.low | static_cast<Position>(neighbor.high) << 16);
      return true;
    });
  }

private:
  // Six bytes: much of the time goes into moving neighbors.
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

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_BINS_H
