// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_POINTS_H

// The points of a distributed search: distributed to processes, with those near them.

#include <CGAL/Distributed_profile.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>
#include <CGAL/Thick_intersection_d/internal/parts/Bisection.h>
#include <CGAL/Thick_intersection_d/internal/parts/Cell_counts.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>
#include <CGAL/Thick_intersection_d/internal/parts/spatial_order.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Carried>
class Distributed_points
{
  using Part = Part_points<Carried>;

public:
  // `reach` bounds the differences of coordinates of near points.
  Distributed_points(const Communicator& comm, double reach, Distributed_profile& profile)
    : comm_(comm), reach_(reach), profile_(profile)
  {}

  // The points of each set that this process searches.
  const std::vector<Part>& sets() const { return sets_; }

  // Copies the points, set by set, and gives each its id: the number of points of lower ranks in
  // its set, and its position.
  template <class Elements>
  void read(const Elements& elements, int set_count, int dimension)
  {
    run_together(comm_, [&] { sets_.resize(static_cast<std::size_t>(set_count)); });
    sets_.front().own_size = sets_.front().consecutive_size = elements.first().size();
    sets_.back().own_size = sets_.back().consecutive_size = elements.second().size();
    agree_on_sizes(dimension);
    run_together(comm_, [&] {
      std::size_t position = 0;
      for(Part& set : sets_) {
        set.reserve(set.own_size + (comm_.size() > 1 ? set.own_size / 8 : 0)); // to receive
        for(std::size_t i = 0; i < set.own_size; ++i)
          set.add(Carried(elements[position++]), set.first_id + i);
      }
    });
  }

  // Cuts space into boxes, one for each process.
  void partition()
  {
    Point_sample chosen, sample;
    std::optional<Cell_counts> cells;
    std::vector<std::vector<Cell_counts::Counted_point>> counted;
    run_together(comm_, [&] {
      chosen.dimension = sample.dimension = dimension_;
      for(const Part& set : sets_)
        for_random_positions(set.size(), share_of_sample(set), [&](std::uint64_t i) {
          chosen.add(set.points[static_cast<std::size_t>(i)], set.first_id + i);
        });
    });
    gather_sample(chosen, {1, 0}, sample);
    run_together(comm_, [&] {
      cells.emplace(sample, total_size_, reach_);
      for(const Part& set : sets_)
        counted.push_back(cells->add_some(set));
    });
    comm_.add_up(cells->counts());
    run_together(comm_, [&] {
      for(std::size_t s = 0; s < sets_.size(); ++s)
        cells->choose_by_pairs(sets_[s], counted[s], sample_size_of_parts(comm_.size()), chosen);
    });
    gather_sample(chosen, {0, 1}, sample);
    run_together(comm_, [&] {
      bisection_.emplace(sample, comm_.size(), reach_, comm_.rank());
    });
    const std::vector<Bisection::Cut> cuts = gather_all(comm_, bisection_->own_cuts());
    bisection_->add(cuts);
  }

  // Moves each point to the process of its box.
  void migrate()
  {
    std::uint64_t sent = 0;
    for(Part& set : sets_) {
      Bytes_of_ranks outgoing;
      run_together(comm_, [&] { pack_points_of_others(set, outgoing); });
      sent += send_points(outgoing, set);
      run_together(comm_, [&] {
        set.own_size = set.size();
        set.consecutive_size = 0;
        sort_by_cells(set, dimension_);
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
    for(const Part& set : sets_) {
      own_count += set.own_size;
      all_count += set.size();
    }
    profile_.set_sizes(own_count, all_count - own_count);
  }

private:
  // Empties `chosen`, and adds what all processes have chosen to the sample, with the same load.
  void gather_sample(Point_sample& chosen, const Point_load& load, Point_sample& sample) const
  {
    const std::vector<double> coordinates = gather_all(comm_, chosen.coordinates);
    const std::vector<std::uint64_t> ids = gather_all(comm_, chosen.ids);
    run_together(comm_, [&] {
      sample.coordinates.insert(sample.coordinates.end(), coordinates.begin(), coordinates.end());
      sample.ids.insert(sample.ids.end(), ids.begin(), ids.end());
      sample.loads.resize(sample.ids.size(), load);
    });
    chosen.coordinates.clear();
    chosen.ids.clear();
  }

  void send_near_points()
  {
    std::vector<Part_box> mine;
    std::vector<int> parts; // whose boxes the intervals are
    std::vector<Interval> intervals;
    std::optional<Near_boxes> near;
    run_together(comm_, [&] {
      mine = own_boxes();
      for(const Part_box& box : mine)
        if(!box.is_empty()) {
          parts.push_back(comm_.rank());
          intervals.insert(intervals.end(), box.intervals().begin(), box.intervals().end());
        }
    });
    parts = gather_all(comm_, parts);
    intervals = gather_all(comm_, intervals);
    run_together(comm_, [&] { near.emplace(mine, comm_.rank(), parts, intervals, reach_); });
    std::uint64_t sent = 0;
    for(Part& set : sets_) {
      Bytes_of_ranks outgoing;
      run_together(comm_, [&] { pack_near_points(set, *near, outgoing); });
      sent += send_points(outgoing, set);
    }
    profile_.set_bytes_sent(Distributed_phase::HALO, sent);
  }

  // Finds the first ids, the number of points of all sets on all processes, and the dimension,
  // which is zero without points.
  void agree_on_sizes(int dimension)
  {
    std::vector<std::uint64_t> mine, all;
    run_together(comm_, [&] {
      mine = {static_cast<std::uint64_t>(dimension)};
      for(const Part& set : sets_)
        mine.push_back(set.own_size);
      all.resize(mine.size() * static_cast<std::size_t>(comm_.size()));
    });
    comm_.gather(mine.data(), mine.size(), all);
    const std::uint64_t* of_rank = all.data();
    for(int rank = 0; rank < comm_.size(); ++rank, of_rank += mine.size()) {
      for(std::size_t s = 0; s < sets_.size(); ++s) {
        sets_[s].first_id += rank < comm_.rank() ? of_rank[s + 1] : 0;
        total_size_ += of_rank[s + 1];
      }
      const int other = static_cast<int>(of_rank[0]);
      if(other != 0 && dimension_ != 0 && other != dimension_)
        throw std::invalid_argument("The points of rank " + std::to_string(rank)
                                    + " have dimension " + std::to_string(other) + " instead of "
                                    + std::to_string(dimension_) + ".");
      dimension_ = (dimension_ != 0) ? dimension_ : other;
    }
  }

  // Returns how many points of a set this process has in the sample.
  std::size_t share_of_sample(const Part& set) const
  {
    return sampled_before(set.first_id + set.own_size, total_size_, comm_.size())
           - sampled_before(set.first_id, total_size_, comm_.size());
  }

  void pack_points_of_others(Part& part, Bytes_of_ranks& outgoing) const
  {
    outgoing.resize(static_cast<std::size_t>(comm_.size()));
    auto owners = zeros_on_huge_pages<int>(part.size());
    std::vector<std::size_t> counts(outgoing.size());
    for(std::size_t i = 0; i < part.size(); ++i) {
      owners[i] = bisection_->owner(part.points[i], part.ids[i]);
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
    return bisection_ ? bisection_->find(part.points[i], part.ids[i]).box : 0;
  }

  std::vector<Part_box> own_boxes() const
  {
    std::vector<Part_box> boxes(bisection_ ? Bisection::max_boxes : 1, Part_box(dimension_));
    for(const Part& set : sets_)
      for(std::size_t i = 0; i < set.own_size; ++i)
        boxes[own_box_of(set, i)].add(set.points[i]);
    return boxes;
  }

  void pack_near_points(const Part& set, const Near_boxes& near, Bytes_of_ranks& outgoing) const
  {
    outgoing.resize(static_cast<std::size_t>(comm_.size()));
    for(std::size_t i = 0; i < set.own_size; ++i)
      near.for_receivers(own_box_of(set, i), set.points[i], [&](int rank) {
        set.pack(i, outgoing[static_cast<std::size_t>(rank)]);
      });
  }

  const Communicator& comm_;
  double reach_;
  Distributed_profile& profile_;
  int dimension_ = 0;
  std::uint64_t total_size_ = 0; // of all sets on all processes
  std::vector<Part> sets_;
  std::optional<Bisection> bisection_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_POINTS_H
