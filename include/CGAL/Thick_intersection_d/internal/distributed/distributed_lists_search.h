// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_LISTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_LISTS_SEARCH_H

// The search behind distributed_fixed_radius_neighbor_lists(). Each process makes lists of the
// points that it has, as the search of one process does, and sends them to the holders of the
// points.

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>
#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/distributed_search.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/lists/neighbor_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The lists of neighbors of a distributed search. The processes that have found the neighbors of a
// point send them to the one that holds the point in its range.
class Distributed_lists
{
  using Position = Neighbor_lists::Position;

public:
  // `size` is the number of points that this process holds.
  Distributed_lists(const Communicator& comm, std::size_t size) : comm_(comm), size_(size)
  {
    run_together(comm, [&] {
      first_ids_.resize(static_cast<std::size_t>(comm.size()));
      heads_.resize(first_ids_.size());
      neighbors_.resize(first_ids_.size());
    });
    const std::uint64_t mine = size;
    comm.gather(&mine, 1, first_ids_);
    replace_by_prefix_sums(first_ids_.data(), first_ids_.data() + first_ids_.size());
  }

  // Takes the lists of the points of `set` that this process has searched, with places of points
  // of `others`, for the holders of the points.
  template <class Carried>
  void pack(const Neighbor_lists& lists, const Part_points<Carried>& set,
            const Part_points<Carried>& others)
  {
    reserve(lists, set, others);
    std::vector<std::uint64_t> ids;
    for(std::size_t i = 0; i < lists.size(); ++i) {
      ids.clear();
      for(const Position j : known_neighbors(lists, i, set, others))
        ids.push_back(others.id(j));
      if(ids.empty())
        continue;
      const Head head = {set.id(i), ids.size()};
      const std::size_t holder = holder_of(head.id);
      write_bytes(&head, 1, heads_[holder]);
      write_bytes(ids.data(), ids.size(), neighbors_[holder]);
    }
  }

  // Sends the lists to the holders, and returns those of the points that this process holds. Each
  // neighbor that arrives is put where its list will be. Collective.
  Distributed_neighbor_lists exchange(const Threads& threads)
  {
    exchange_heads();
    std::vector<std::size_t> begins;
    std::vector<std::uint64_t> ids;
    run_together(comm_, [&] { make_room(begins, ids); });
    std::size_t* const ends = begins.data() + 1; // of what the lists have
    Byte_exchange exchange(comm_, neighbors_);
    exchange.run([&](std::size_t rank, const std::vector<char>& bytes) {
      Byte_reader reader(bytes);
      for_each_head(heads_[rank], [&](std::size_t i, std::size_t size) {
        reader.read(ids.data() + ends[i], size);
        ends[i] += size;
      });
    });
    size_sent_ += exchange.outgoing_size();
    run_together(comm_, [&] {
      threads.run_blocks(size_, [&](std::size_t i, std::size_t last) {
        for(; i != last; ++i)
          std::sort(ids.data() + begins[i], ids.data() + begins[i + 1]);
      });
    });
    return Distributed_neighbor_lists(std::move(begins), std::move(ids), false);
  }

  // Returns how many bytes other processes were sent.
  std::uint64_t size_sent() const { return size_sent_; }

private:
  // What comes before the neighbors of a point.
  struct Head
  {
    std::uint64_t id;
    std::uint64_t size;
  };

  // Returns the neighbors of a point that this process tells the holder of. Two points that were
  // both received, for being near, are a pair of another process.
  template <class Carried>
  static Neighbor_lists::Neighbors
  known_neighbors(const Neighbor_lists& lists, std::size_t i, const Part_points<Carried>& set,
                  const Part_points<Carried>& others)
  {
    const Neighbor_lists::Neighbors all = lists[i];
    if(i < set.own_size)
      return all;
    return {all.begin(), std::lower_bound(all.begin(), all.end(), others.own_size)};
  }

  template <class Carried>
  void reserve(const Neighbor_lists& lists, const Part_points<Carried>& set,
               const Part_points<Carried>& others)
  {
    std::vector<std::size_t> list_counts(first_ids_.size()), neighbor_counts(first_ids_.size());
    for(std::size_t i = 0; i < lists.size(); ++i)
      if(const std::size_t size = known_neighbors(lists, i, set, others).size()) {
        const std::size_t holder = holder_of(set.id(i));
        ++list_counts[holder];
        neighbor_counts[holder] += size;
      }
    for(std::size_t rank = 0; rank < first_ids_.size(); ++rank) {
      heads_[rank].reserve(list_counts[rank] * sizeof(Head));
      reserve_huge_pages(neighbors_[rank], neighbor_counts[rank] * sizeof(std::uint64_t));
    }
  }

  // Replaces the heads of the lists that were packed here by those of the points held here.
  void exchange_heads()
  {
    Bytes_of_ranks received;
    run_together(comm_, [&] { received.resize(heads_.size()); });
    Byte_exchange exchange(comm_, heads_);
    exchange.run([&](std::size_t rank, const std::vector<char>& bytes) { received[rank] = bytes; });
    size_sent_ = exchange.outgoing_size();
    heads_.swap(received);
  }

  // Sets `begins[i + 1]` to where list i begins, to be moved to where it ends.
  void make_room(std::vector<std::size_t>& begins, std::vector<std::uint64_t>& ids) const
  {
    begins.resize(size_ + 1);
    for(const std::vector<char>& bytes : heads_)
      for_each_head(bytes, [&](std::size_t i, std::size_t size) { begins[i + 1] += size; });
    const std::size_t id_count
      = replace_by_prefix_sums(begins.data() + 1, begins.data() + begins.size());
    reserve_huge_pages(ids, id_count);
    ids.resize(id_count);
  }

  // Returns the last process that begins with this id or a lesser one. Those without points begin
  // with the id of the next point.
  std::size_t holder_of(std::uint64_t id) const
  {
    return static_cast<std::size_t>(
      std::upper_bound(first_ids_.begin(), first_ids_.end(), id) - first_ids_.begin() - 1);
  }

  // Calls task(i, size) for each list that was sent, of the point at position `i` here.
  template <class Task>
  void for_each_head(const std::vector<char>& bytes, const Task& task) const
  {
    const std::uint64_t first_id = first_ids_[static_cast<std::size_t>(comm_.rank())];
    for(Byte_reader reader(bytes); !reader.is_at_end();) {
      Head head;
      reader.read(&head, 1);
      task(static_cast<std::size_t>(head.id - first_id), static_cast<std::size_t>(head.size));
    }
  }

  const Communicator& comm_;
  const std::size_t size_;
  std::vector<std::uint64_t> first_ids_; // of the ranges, by their ranks
  Bytes_of_ranks heads_;
  Bytes_of_ranks neighbors_;
  std::uint64_t size_sent_ = 0;
};

// Returns the lists of the points that this process has, of the first set if there are two, as
// places. If the search was stopped here, each pair of one set is in both of its lists or in none.
template <class Carried, class Sets, class NT, class NamedParameters>
Neighbor_lists
collect_neighbors_here(const Communicator& comm,
                       const std::vector<Part_points<Carried>>& points, const Sets& sets,
                       const Distance_bound<NT>& bound, const NamedParameters& np,
                       const Threads& threads)
{
  std::optional<Neighbor_collector> collector;
  run_together(comm, [&] {
    check_list_size(points.front().size());
    check_list_size(points.back().size());
    collector.emplace(points.front().size(), threads);
  });
  bool is_complete = false;
  search_together(comm, np, [&](const auto& watched_np) {
    if constexpr(Sets::are_two) {
      const Second_as_neighbor add(*collector);
      is_complete = report_pairs_here(points, sets, bound, add, watched_np, threads);
    }
    else
      is_complete = report_pairs_here(points, sets, bound, *collector, watched_np, threads);
    return is_complete;
  });
  Neighbor_lists lists;
  run_together(comm, [&] {
    lists = collector->lists(!Sets::are_two);
    if(!Sets::are_two && !is_complete)
      lists = mutual_neighbors(lists);
  });
  return lists;
}

template <class Elements, class Sets, class NT, class NamedParameters>
Distributed_neighbor_lists
make_distributed_lists(const Communicator& comm, const Elements& elements, const Sets& sets,
                       const Distance_bound<NT>& bound, Distributed_profile& profile,
                       const NamedParameters& np, const Threads& threads)
{
  if constexpr(!check_sent_points<Elements, NamedParameters>())
    return Distributed_neighbor_lists();
  else {
    Phase_clock clock(profile);
    Distributed_lists lists(comm, elements.first().size());
    { // then the points are given up
      const auto points = distribute_points(comm, elements, sets, bound, profile, clock, threads);
      const Neighbor_lists here
        = collect_neighbors_here(comm, points.sets(), sets, bound, np, threads);
      run_together(comm, [&] { lists.pack(here, points.sets().front(), points.sets().back()); });
      clock.finish(Distributed_phase::SEARCH);
    }
    Distributed_neighbor_lists mine = lists.exchange(threads);
    profile.set_bytes_sent(Distributed_phase::LISTS, lists.size_sent());
    clock.finish(Distributed_phase::LISTS);
    return mine;
  }
}

// Makes the lists of one range on each process, or those of the first of two ranges, with neighbors
// in the second.
template <class NT, class NamedParameters, class... Ranges>
Distributed_neighbor_lists
collect_distributed_neighbors(const Communicator& comm, const Distance_bound<NT>& bound,
                              Distributed_profile& profile, const NamedParameters& np,
                              const Threads& threads, Ranges&... ranges)
{
  if constexpr((check_range<Ranges, NamedParameters>() && ...)) {
    const auto search = [&](const auto& elements, const auto& sets) {
      return make_distributed_lists(comm, elements, sets, bound, profile, np, threads);
    };
    return with_distributed_ranges(comm, np, search, ranges...);
  }
  else
    return Distributed_neighbor_lists();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_LISTS_SEARCH_H
