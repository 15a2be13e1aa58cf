// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_COLLECTOR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_COLLECTOR_H

// Makes lists of neighbors, from pairs or from the lists of single points. Several threads may give
// pairs or lists at once, in any order.
//
// The lists of all points are larger than a cache, and a pair or a list may belong to any point. So
// the collector first puts them into bins. A bin is for consecutive points, so few that a cache
// holds their lists. Then the collector makes the lists of one bin after another.

#include <CGAL/Neighbor_lists.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Chunked_lists.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/machine/Per_thread.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Callback_taker.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/slabs/List_bins.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/list_search.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The neighbors that one thread finds, in any order, in bins. A bin takes the neighbors of
// consecutive points, so few that a cache holds their lists.
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

class Neighbor_collector
{
  using Position = Neighbor_lists::Position;

public:
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Neighbor_collector(std::size_t size, const Threads& threads)
    : size_(size), threads_(threads), pairs_(Neighbor_bins(size), threads),
      lists_(List_bins(size), threads)
  {}

  // Returns bins for the neighbors that this thread finds.
  Neighbor_bins& local_pairs() { return pairs_.local(); }

  // Makes the points at two positions of one set neighbors of each other.
  void operator()(std::size_t i, std::size_t j)
  {
    Neighbor_bins& bins = local_pairs();
    bins.add(static_cast<Position>(i), static_cast<Position>(j));
    bins.add(static_cast<Position>(j), static_cast<Position>(i));
  }

  // Returns bins for the sorted lists of points, each with all of its neighbors. Either all
  // neighbors are given in lists, or all of them in pairs.
  List_bins& local_lists()
  {
    has_lists_.store(true, std::memory_order_relaxed);
    return lists_.local();
  }

  // Returns the lists, in the memory of `old_lists`, which may be any.
  Neighbor_lists lists(bool are_of_one_set = true, Neighbor_lists old_lists = Neighbor_lists())
  {
    return has_lists_ ? lists_of(lists_, true, std::move(old_lists))
                      : lists_of(pairs_, are_of_one_set, std::move(old_lists));
  }

private:
  // The bins of all threads.
  template <class Bins>
  using All_bins = Per_thread<Bins>;

  template <class Bins>
  Neighbor_lists lists_of(All_bins<Bins>& bins, bool are_of_one_set, Neighbor_lists&& old_lists);

  template <class Bins>
  std::size_t bin_count() const
  {
    return (size_ + Bins::bin_size - 1) / Bins::bin_size;
  }

  // Returns for each bin the number of neighbors in all bins before it, and then the total number.
  template <class Bins>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  std::vector<std::size_t> begins_of_all_bins(All_bins<Bins>& all_bins)
  {
    std::vector<std::size_t> begins(bin_count<Bins>() + 1, 0);
    threads_.run_blocks(bin_count<Bins>(), [&](std::size_t bin, std::size_t last) {
      for(; bin != last; ++bin)
        all_bins.for_each([&](const Bins& bins) { begins[bin + 1] += bins.size(bin); });
    });
    for(std::size_t bin = 0; bin < bin_count<Bins>(); ++bin)
      begins[bin + 1] += begins[bin];
    return begins;
  }

  // Writes the lists of a bin to `lists`, and the places where they begin to `begins`. The first
  // list begins at `begin`.
  template <class Bins>
  void make_lists(All_bins<Bins>& all_bins, std::size_t bin, std::size_t begin,
                  std::size_t* begins, Position* lists)
  {
    const auto for_each_part = [&](const auto& task) {
      all_bins.for_each([&](const Bins& bins) {
        bins.for_each(bin, [&](std::size_t of, const Position* first, const Position* last) {
          task(of, first, static_cast<std::size_t>(last - first));
        });
      });
    };
    std::vector<std::size_t> ends(Bins::bin_size, 0); // the ends of the lists, once these are full
    for_each_part([&](std::size_t of, const Position*, std::size_t size) { ends[of] += size; });
    replace_by_prefix_sums(ends.data(), ends.data() + ends.size());
    for_each_part([&](std::size_t of, const Position* part, std::size_t size) {
      std::copy_n(part, size, lists + ends[of]);
      ends[of] += size;
    });

    const std::size_t first = bin * Bins::bin_size;
    const std::size_t count = (std::min)(Bins::bin_size, size_ - first);
    [[maybe_unused]] Buffer<Position> memory_of_sort;
    for(std::size_t i = 0; i < count; ++i) {
      if constexpr(!Bins::are_sorted)
        sort_distinct(lists + (i == 0 ? 0 : ends[i - 1]), lists + ends[i], memory_of_sort);
      begins[first + i + 1] = begin + ends[i];
    }
  }

  const std::size_t size_;
  const Threads threads_;
  All_bins<Neighbor_bins> pairs_;
  All_bins<List_bins> lists_;
  std::atomic<bool> has_lists_ = false;
};

template <class Bins>
Neighbor_lists Neighbor_collector::lists_of(All_bins<Bins>& bins, bool are_of_one_set,
                                            Neighbor_lists&& old_lists)
{
  Neighbor_lists::Begins begins = std::move(old_lists).begins();
  Neighbor_lists::Positions positions = std::move(old_lists).positions();
  const std::vector<std::size_t> begins_of_bins = begins_of_all_bins(bins);
  std::size_t* const all_begins = begins.require(size_ + 1);
  Position* const all_lists = positions.require(begins_of_bins.back());

  all_begins[0] = 0;
  threads_.run_blocks(bin_count<Bins>(), [&](std::size_t bin, std::size_t last) {
    Buffer<Position> lists;
    for(; bin != last; ++bin) {
      const std::size_t begin = begins_of_bins[bin];
      const std::size_t count = begins_of_bins[bin + 1] - begin;
      Position* const first = lists.require(count);
      make_lists(bins, bin, begin, all_begins, first);
      std::copy_n(first, count, all_lists + begin);
    }
  });
  if(threads_.are_many()) // to free much memory takes a while
    bins.for_each_at_once(threads_, [](Bins& bins_of_thread) { bins_of_thread.clear(); });
  return Neighbor_lists(std::move(begins), std::move(positions), are_of_one_set);
}

// Makes the second point of a pair, which is of another set, a neighbor of the first one.
class Second_as_neighbor
{
public:
  explicit Second_as_neighbor(Neighbor_collector& collector) : collector_(collector) {}

  // Looks the bins of the thread up once for many pairs.
  friend auto part_of_thread(const Second_as_neighbor& all)
  {
    using Position = Neighbor_lists::Position;
    return [&bins = all.collector_.local_pairs()](std::size_t i, std::size_t j) {
      bins.add(static_cast<Position>(i), static_cast<Position>(j));
    };
  }

  void operator()(std::size_t i, std::size_t j) const { part_of_thread(*this)(i, j); }

private:
  Neighbor_collector& collector_;
};

// Hands the results of a search by slabs to a collector: pairs, or the lists of single points.
class Collector_taker final
  : public Callback_taker<One_set, Neighbor_collector, List_taker>
{
public:
  explicit Collector_taker(Neighbor_collector& collector)
    : Callback_taker<One_set, Neighbor_collector, List_taker>(One_set(), collector)
  {}

  List_bins& local_lists() override { return callback_.local_lists(); }
};

inline Collector_taker taker_of(const One_set&, Neighbor_collector& collector)
{
  return Collector_taker(collector);
}

// Returns the lists with those pairs that are in both of their lists.
template <class Position>
Basic_neighbor_lists<Position> mutual_neighbors(const Basic_neighbor_lists<Position>& lists)
{
  std::vector<std::size_t> begins(1, 0);
  std::vector<Position> positions;
  for(std::size_t i = 0; i < lists.size(); ++i) {
    for(const Position j : lists[i])
      if(std::binary_search(lists[j].begin(), lists[j].end(), i))
        positions.push_back(j);
    begins.push_back(positions.size());
  }
  return {std::move(begins), std::move(positions)};
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template class Per_thread<Neighbor_bins>;
extern template class Per_thread<List_bins>;
extern template class Callback_taker<One_set, Neighbor_collector, List_taker>;
extern template Neighbor_lists Neighbor_collector::lists_of(
  Per_thread<Neighbor_bins>&, bool, Neighbor_lists&&);
extern template Neighbor_lists Neighbor_collector::lists_of(
  Per_thread<List_bins>&, bool, Neighbor_lists&&);
extern template Neighbor_lists mutual_neighbors(const Neighbor_lists&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_COLLECTOR_H
