// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_NEIGHBOR_COLLECTOR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_NEIGHBOR_COLLECTOR_H

// Makes lists of neighbours from pairs that come in any order, by several threads at once.
//
// The lists of all points together are larger than a cache, and pairs belong to any of them. So
// pairs are thrown into bins first, each for as many consecutive points as have their lists in a
// cache; then the lists of one bin after another are filled and sorted.

#include <CGAL/Thick_intersection_d/internal/Neighbor_bins.h>
#include <CGAL/Thick_intersection_d/internal/parallel.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag>
class Neighbor_collector
{
  using Position = Neighbor_lists::Position;

public:
  explicit Neighbor_collector(std::size_t size) : size_(size), bins_(Neighbor_bins(size)) {}

  // Makes the points at two positions neighbours of each other.
  void add(std::size_t i, std::size_t j)
  {
    Neighbor_bins& bins = bins_.local();
    const Position p = static_cast<Position>(i);
    const Position q = static_cast<Position>(j);
    bins.add({p, q});
    bins.add({q, p});
  }

  Neighbor_lists lists()
  {
    std::vector<std::size_t> begins(size_ + 1, 0);
    for_each_bin([&](std::size_t bin) {
      for_each_neighbor(bin, [&](const Neighbor& n) { ++begins[n.of + std::size_t(1)]; });
    });
    for(std::size_t i = 0; i < size_; ++i)
      begins[i + 1] += begins[i];

    std::vector<Position> positions;
    positions.reserve(begins.back());
    ask_for_huge_pages(positions.data(), begins.back() * sizeof(Position));
    positions.resize(begins.back());
    for_each_bin([&](std::size_t bin) { fill(bin, begins, positions); });
    return Neighbor_lists(std::move(begins), std::move(positions));
  }

private:
  static constexpr std::size_t bin_size = Neighbor_bins::bin_size;

  template <class Task>
  void for_each_bin(const Task& task)
  {
    for_each_block<ConcurrencyTag>(bins_.local().count(), [&](std::size_t bin, std::size_t last) {
      for(; bin != last; ++bin)
        task(bin);
    });
  }

  template <class Task>
  void for_each_neighbor(std::size_t bin, const Task& task)
  {
    bins_.for_each([&](const Neighbor_bins& bins) { bins.for_each(bin, task); });
  }

  // Fills the lists of a bin.
  void fill(std::size_t bin, const std::vector<std::size_t>& begins,
            std::vector<Position>& positions)
  {
    const std::size_t first = bin * bin_size;
    const std::size_t last = (std::min)(first + bin_size, size_);
    std::vector<std::size_t> next(begins.begin() + static_cast<std::ptrdiff_t>(first),
                                  begins.begin() + static_cast<std::ptrdiff_t>(last));
    for_each_neighbor(
      bin, [&](const Neighbor& n) { positions[next[n.of - first]++] = n.position; });
    for(std::size_t i = first; i < last; ++i)
      sort(positions.data() + begins[i], positions.data() + begins[i + 1]);
  }

  // Most lists are short: the rank of each of their positions, which are distinct, is counted in a
  // loop without branches.
  static void sort(Position* first, Position* last)
  {
    constexpr std::ptrdiff_t greatest_short_size = 64;
    const std::ptrdiff_t size = last - first;
    if(size > greatest_short_size) {
      std::sort(first, last);
      return;
    }
    Position copy[greatest_short_size];
    std::copy(first, last, copy);
    for(std::ptrdiff_t i = 0; i < size; ++i) {
      Position rank = 0;
      for(std::ptrdiff_t j = 0; j < size; ++j)
        rank += copy[j] < copy[i];
      first[rank] = copy[i];
    }
  }

  const std::size_t size_;
  Per_thread<ConcurrencyTag, Neighbor_bins> bins_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_NEIGHBOR_COLLECTOR_H
