// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_COLLECTOR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_COLLECTOR_H

// Makes lists of neighbors from pairs. Several threads may give pairs at once, in any order.
//
// The lists of all points are larger than a cache, and a pair may belong to any list. So the
// collector first puts pairs into bins. A bin is for consecutive points, so few that a cache holds
// their lists. Then the collector fills and sorts the lists of one bin after another.

#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/machine/huge_pages.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/reports/Neighbor_bins.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag>
class Neighbor_collector
{
  using Position = Neighbor_lists::Position;
  using Positions = std::vector<Position>;

public:
  explicit Neighbor_collector(std::size_t size) : size_(size), bins_(Neighbor_bins(size)) {}

  // Makes the points at two positions neighbors of each other.
  void operator()(std::size_t i, std::size_t j)
  {
    Neighbor_bins& bins = bins_.local();
    bins.add(static_cast<Position>(i), static_cast<Position>(j));
    bins.add(static_cast<Position>(j), static_cast<Position>(i));
  }

  Neighbor_lists lists()
  {
    std::vector<std::size_t> begins(size_ + 1, 0);
    Positions positions;
    const std::vector<std::size_t> begins_of_bins = begins_of_all_bins();
    positions.reserve(begins_of_bins.back());
    ask_for_huge_pages(positions.data(), begins_of_bins.back() * sizeof(Position));
    if constexpr(is_parallel_v<ConcurrencyTag>)
      positions.resize(begins_of_bins.back()); // in sequence, lists are appended: one write less

    for_each_block<ConcurrencyTag>(bin_count(), [&](std::size_t bin, std::size_t last) {
      Buffer<Position> lists;
      for(; bin != last; ++bin) {
        const std::size_t begin = begins_of_bins[bin];
        const std::size_t end = begins_of_bins[bin + 1];
        Position* const first = lists.require(end - begin);
        make_lists(bin, begin, begins, first);
        if constexpr(is_parallel_v<ConcurrencyTag>)
          std::copy(first, first + (end - begin), positions.data() + begin);
        else
          positions.insert(positions.end(), first, first + (end - begin));
      }
    });
    return Neighbor_lists(std::move(begins), std::move(positions));
  }

private:
  static constexpr std::size_t bin_size = Neighbor_bins::bin_size;

  std::size_t bin_count() const { return (size_ + bin_size - 1) / bin_size; }

  // Returns for each bin the number of neighbors in all bins before it, and then the total number.
  std::vector<std::size_t> begins_of_all_bins()
  {
    std::vector<std::size_t> begins(bin_count() + 1, 0);
    bins_.for_each([&](const Neighbor_bins& bins) {
      for(std::size_t bin = 0; bin < bin_count(); ++bin)
        begins[bin + 1] += bins.size(bin);
    });
    for(std::size_t bin = 0; bin < bin_count(); ++bin)
      begins[bin + 1] += begins[bin];
    return begins;
  }

  template <class Task>
  void for_each_neighbor(std::size_t bin, const Task& task)
  {
    bins_.for_each([&](const Neighbor_bins& bins) { bins.for_each(bin, task); });
  }

  // Writes the lists of a bin to `lists`, and the places where they begin to `begins`. The first
  // list begins at `begin`.
  void make_lists(std::size_t bin, std::size_t begin, std::vector<std::size_t>& begins,
                  Position* lists)
  {
    std::vector<std::size_t> ends(bin_size, 0); // the ends of the lists, once these are full
    for_each_neighbor(bin, [&](std::size_t of, Position) { ++ends[of]; });
    replace_by_prefix_sums(ends.data(), ends.data() + ends.size());
    for_each_neighbor(bin, [&](std::size_t of, Position position) {
      lists[ends[of]++] = position;
    });

    const std::size_t first = bin * bin_size;
    const std::size_t count = (std::min)(bin_size, size_ - first);
    for(std::size_t i = 0; i < count; ++i) {
      sort_distinct(lists + (i == 0 ? 0 : ends[i - 1]), lists + ends[i]);
      begins[first + i + 1] = begin + ends[i];
    }
  }

  const std::size_t size_;
  Per_thread<ConcurrencyTag, Neighbor_bins> bins_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_COLLECTOR_H
