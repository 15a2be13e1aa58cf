// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_POINTS_H

// The points of a distributed search: distributed to processes, with those near them.

#include <CGAL/Distributed_profile.h>

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/exchange_bytes.h>
#include <CGAL/Thick_intersection_d/internal/distributed/gather_bytes.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>
#include <CGAL/Thick_intersection_d/internal/parts/Bisection.h>
#include <CGAL/Thick_intersection_d/internal/parts/Cell_counts.h>
#include <CGAL/Thick_intersection_d/internal/parts/Near_boxes.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>
#include <CGAL/Thick_intersection_d/internal/parts/choose_sample.h>
#include <CGAL/Thick_intersection_d/internal/parts/spatial_order.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The points of one set that a process searches: its own come first, then those it has received
// because they are near.
template <class Carried>
struct Distributed_set
{
  Part_points<Carried> part;
  std::size_t own_size = 0;
  std::uint64_t first_id = 0;
  std::size_t consecutive_size = 0; // the ids of so many points follow each other

  // Looks up an id only if it has to: two ids for each pair are as much work as the pair itself.
  std::uint64_t id(std::size_t i) const
  {
    return i < consecutive_size ? first_id + i : part.ids[i];
  }
};

template <class Carried, class Sets>
class Distributed_points
{
  using Part = Part_points<Carried>;

public:
  // `reach` bounds the differences of coordinates of near points.
  Distributed_points(const Communicator& comm, double reach, Distributed_profile& profile)
    : comm_(comm), reach_(reach), profile_(profile)
  {}

  const std::vector<Distributed_set<Carried>>& sets() const { return sets_; }

  // Copies the points, and gives each its id: the number of points of lower ranks in its set, and
  // its position.
  template <class Elements>
  void read(const Elements& elements, const Sets& sets, int dimension)
  {
    std::size_t first_size = elements.size();
    if constexpr(Sets::are_two)
      first_size = sets.first_size;
    const std::size_t sizes[set_count + 1] = {first_size, elements.size() - first_size};
    agree_on_sizes(sizes, dimension);
    run_together(comm_, [&] {
      sets_.resize(set_count);
      for(std::size_t s = 0; s < set_count; ++s) {
        sets_[s].part.reserve(comm_.size() > 1 ? sizes[s] + sizes[s] / 8 : sizes[s]); // to receive
        for(std::size_t i = 0; i < sizes[s]; ++i)
          sets_[s].part.add(Carried(elements[s * first_size + i]), first_ids_[s] + i);
        sets_[s].own_size = sets_[s].consecutive_size = sizes[s];
        sets_[s].first_id = first_ids_[s];
      }
    });
  }

  // Cuts space into boxes, one for each process.
  void partition()
  {
    std::vector<char> bytes;
    run_together(comm_, [&] {
      for(std::size_t s = 0; s < set_count; ++s)
        choose_sample(sets_[s].part, share_of_sample(s), dimension_, bytes);
    });
    bytes = gather_bytes(comm_, bytes);
    Point_sample sample;
    std::optional<Cell_counts> cells;
    std::vector<std::vector<Cell_counts::Counted_point>> counted;
    run_together(comm_, [&] {
      sample.dimension = dimension_;
      read_sample(bytes, {1, 0}, sample);
      cells.emplace(sample, total_size(), reach_);
      for(const Distributed_set<Carried>& set : sets_)
        counted.push_back(cells->add_some(set.part));
    });
    comm_.add_up(cells->counts());
    run_together(comm_, [&] {
      const std::uint64_t total = sample_size_of_parts(comm_.size());
      bytes.clear();
      for(std::size_t s = 0; s < set_count; ++s)
        cells->choose_by_pairs(sets_[s].part, counted[s], total, bytes);
    });
    bytes = gather_bytes(comm_, bytes);
    run_together(comm_, [&] {
      read_sample(bytes, {0, 1}, sample);
      bytes.clear();
      bisection_.emplace(sample, comm_.size(), reach_, comm_.rank(), bytes);
    });
    bytes = gather_bytes(comm_, bytes);
    run_together(comm_, [&] { bisection_->add(bytes); });
  }

  // Moves each point to the process of its box.
  void migrate()
  {
    std::uint64_t sent = 0;
    for(Distributed_set<Carried>& set : sets_) {
      Bytes_of_ranks outgoing;
      run_together(comm_, [&] { pack_points_of_others(set.part, outgoing); });
      sent += send_points(outgoing, set.part);
      run_together(comm_, [&] {
        set.own_size = set.part.size();
        set.consecutive_size = 0;
        sort_by_cells(set.part, dimension_);
      });
    }
    profile_.set_bytes_sent(Distributed_phase::MIGRATION, sent);
  }

  // Of each two processes, sends the points of one that are near the points of the other.
  void add_halos()
  {
    if(comm_.size() > 1)
      send_near_points();
    std::size_t own_count = 0, all_count = 0;
    for(const Distributed_set<Carried>& set : sets_) {
      own_count += set.own_size;
      all_count += set.part.size();
    }
    profile_.set_sizes(own_count, all_count - own_count);
  }

private:
  static constexpr std::size_t set_count = Sets::are_two ? 2 : 1;

  void send_near_points()
  {
    std::vector<Part_box> mine;
    std::vector<std::vector<Part_box>> all;
    std::optional<Near_boxes> near;
    std::vector<char> bytes;
    run_together(comm_, [&] {
      mine = own_boxes();
      write_boxes(mine, bytes);
    });
    bytes = gather_bytes(comm_, bytes);
    run_together(comm_, [&] {
      all = read_boxes_of_parts(bytes, dimension_);
      near.emplace(mine, comm_.rank(), all, reach_);
    });
    std::uint64_t sent = 0;
    for(Distributed_set<Carried>& set : sets_) {
      Bytes_of_ranks outgoing;
      run_together(comm_, [&] { pack_near_points(set, *near, outgoing); });
      sent += send_points(outgoing, set.part);
    }
    profile_.set_bytes_sent(Distributed_phase::HALO, sent);
  }

  // Finds the first ids, the sizes of all sets, and the dimension, which is zero without points.
  void agree_on_sizes(const std::size_t* sizes, int dimension)
  {
    std::vector<std::uint64_t> all;
    run_together(comm_, [&] { all.resize(3 * static_cast<std::size_t>(comm_.size())); });
    const std::uint64_t mine[3]
      = {sizes[0], set_count == 2 ? sizes[1] : 0, static_cast<std::uint64_t>(dimension)};
    comm_.gather(mine, 3, all);
    for(int rank = 0; rank < comm_.size(); ++rank) {
      const std::uint64_t* const of_rank = all.data() + 3 * rank;
      for(std::size_t s = 0; s < set_count; ++s) {
        first_ids_[s] += rank < comm_.rank() ? of_rank[s] : 0;
        totals_[s] += of_rank[s];
        local_sizes_[s] = sizes[s];
      }
      const int other = static_cast<int>(of_rank[2]);
      if(other != 0 && dimension_ != 0 && other != dimension_)
        throw std::invalid_argument("The points of rank " + std::to_string(rank)
                                    + " have dimension " + std::to_string(other) + " instead of "
                                    + std::to_string(dimension_) + ".");
      dimension_ = (dimension_ != 0) ? dimension_ : other;
    }
  }

  // Returns the number of points of all sets on all processes.
  std::uint64_t total_size() const
  {
    return std::accumulate(totals_, totals_ + set_count, std::uint64_t(0));
  }

  // Returns how many points of a set this process has in the sample.
  std::size_t share_of_sample(std::size_t s) const
  {
    const std::uint64_t end = first_ids_[s] + local_sizes_[s];
    return sampled_before(end, total_size(), comm_.size())
           - sampled_before(first_ids_[s], total_size(), comm_.size());
  }

  void pack_points_of_others(Part& part, Bytes_of_ranks& outgoing) const
  {
    outgoing.resize(static_cast<std::size_t>(comm_.size()));
    auto owners = zeros_on_huge_pages<int>(part.size());
    std::vector<std::size_t> counts(outgoing.size());
    for(std::size_t i = 0; i < part.size(); ++i) {
      owners[i] = bisection_->owner(part.lower_bounds(i), part.ids[i]);
      ++counts[static_cast<std::size_t>(owners[i])];
    }
    counts[static_cast<std::size_t>(comm_.rank())] = 0;
    for(std::size_t rank = 0; rank < outgoing.size(); ++rank)
      reserve_huge_pages(outgoing[rank], counts[rank] * Part::packed_size(dimension_));
    std::size_t kept = 0;
    for(std::size_t i = 0; i < part.size(); ++i)
      if(owners[i] != comm_.rank())
        part.pack(i, outgoing[static_cast<std::size_t>(owners[i])]);
      else
        part.move(i, kept++);
    part.resize(kept);
  }

  // Appends the points that this process is sent to its part. Returns how many bytes it has sent.
  std::uint64_t send_points(Bytes_of_ranks& outgoing, Part& part) const
  {
    Byte_exchange exchange(comm_, outgoing);
    run_together(comm_, [&] {
      part.reserve(part.size() + exchange.incoming_size() / Part::packed_size(dimension_));
    });
    exchange.run([&](std::size_t, const std::vector<char>& bytes) {
      part.unpack(bytes, dimension_);
    });
    return exchange.outgoing_size();
  }

  // Returns which box of this process a point of its own is in.
  std::size_t own_box_of(const Part& part, std::size_t i) const
  {
    return bisection_ ? bisection_->find(part.lower_bounds(i), part.ids[i]).box : 0;
  }

  std::vector<Part_box> own_boxes() const
  {
    std::vector<Part_box> boxes(bisection_ ? Bisection::max_boxes : 1, Part_box(dimension_));
    for(const Distributed_set<Carried>& set : sets_)
      for(std::size_t i = 0; i < set.own_size; ++i)
        boxes[own_box_of(set.part, i)].add(set.part.points[i]);
    return boxes;
  }

  void pack_near_points(const Distributed_set<Carried>& set, const Near_boxes& near,
                        Bytes_of_ranks& outgoing) const
  {
    outgoing.resize(static_cast<std::size_t>(comm_.size()));
    for(std::size_t i = 0; i < set.own_size; ++i) {
      const auto pack = [&](std::size_t rank) { set.part.pack(i, outgoing[rank]); };
      near.for_receivers(own_box_of(set.part, i), set.part.points[i], pack);
    }
  }

  const Communicator& comm_;
  double reach_;
  Distributed_profile& profile_;
  int dimension_ = 0;
  std::uint64_t first_ids_[set_count] = {};
  std::uint64_t totals_[set_count] = {}; // of all processes
  std::size_t local_sizes_[set_count] = {};
  std::vector<Distributed_set<Carried>> sets_;
  std::optional<Bisection> bisection_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_POINTS_H
