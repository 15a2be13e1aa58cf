// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SWEEP_H

// Sweeps two sorted runs of boxes, which may be the same run: lanes find pairs, and the client gets
// those that are of this piece. It knows neither where the runs come from nor what makes a pair.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_client.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/lanes/with_lanes.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// How many candidates a sweep may still look at before it is given up, and what it has finished.
//
// Each wanted pair allows some more candidates. So a sweep takes time for the first allowance, and
// O(1) time for each wanted pair. Threads share the allowance.
class Sweep_allowance
{
public:
  // As many as a sweep wants.
  Sweep_allowance() = default;

  Sweep_allowance(std::int64_t first, std::int64_t per_wanted_pair)
    : left_(first), per_wanted_pair_(per_wanted_pair)
  {}

  bool is_left() const { return left_.load(std::memory_order_relaxed) >= 0; }

  // After a part of the sweep: how many candidates there were, wanted pairs among them, and boxes
  // that are finished.
  void use(std::uint64_t candidates, std::uint64_t wanted_pairs, std::size_t finished)
  {
    finished_.fetch_add(finished, std::memory_order_relaxed);
    const std::int64_t earned = per_wanted_pair_ * static_cast<std::int64_t>(wanted_pairs);
    left_.fetch_add(earned - static_cast<std::int64_t>(candidates), std::memory_order_relaxed);
  }

  std::size_t finished() const { return finished_.load(std::memory_order_relaxed); }

private:
  std::atomic<std::int64_t> left_ = (std::numeric_limits<std::int64_t>::max)();
  std::atomic<std::size_t> finished_ = 0;
  std::int64_t per_wanted_pair_ = 0;
};

template <int Axes>
class Box_sweep
{
  using Run = Box_run<Axes>;

public:
  Box_sweep(Box_client<Axes>& client, Stop_flag& stop) : client_(client), stop_(stop) {}

  // From now on, starts from the boxes of one of `count` blocks of each run only.
  void take_block(Place index, Place count)
  {
    block_index_ = index;
    block_count_ = count;
  }

  // How many wanted pairs the client has counted.
  std::uint64_t wanted_count() const { return wanted_count_; }

  // Gives the pairs of a box of one run and a box of the other to the client.
  void between(const Run& run, const Run& b)
  {
    const Run a = block_count_ == 1 ? run : run.block(block_index_, block_count_);
    const auto flush = [&] { return give_found(a, b); };
    with_lanes([&](auto set) { set.collect_meeting(a, b, found_, Flush(flush)); });
    flush();
  }

private:
  // Gives the found pairs to the client. Returns false to stop. Not inline, so that the loops of
  // lanes stay short. They call this function once per thousand found pairs.
  BOOST_NOINLINE bool give_found(const Run& a, const Run& b)
  {
    const Place count = std::exchange(found_.count, 0);
    const Place row_count = std::exchange(found_.row_count, 0);
    if(stop_.is_set())
      return false;
    const bool are_pairs = client_.are_decided && !(a.has_copies && b.has_copies);
    const bool goes_on = (row_count == 0 || (are_pairs ? give_rows(a, b, row_count)
                                                       : give_pairs_of_rows(a, b, row_count)))
                         && (count == 0 || give(a, b, found_.pairs.data(), count));
    if(!goes_on)
      stop_.set();
    return goes_on;
  }

  bool give_rows(const Run& a, const Run& b, Place row_count)
  {
    for(Place r = 0; r < row_count; ++r)
      if(!client_.take_row(a.positions[found_.rows[r].i], b.positions + found_.rows[r].j))
        return false;
    return true;
  }

  bool give_pairs_of_rows(const Run& a, const Run& b, Place row_count)
  {
    Place count = 0;
    for(Place r = 0; r < row_count; ++r)
      for(Place lane = 0; lane < lanes; ++lane)
        pairs_of_rows_[count++] = {found_.rows[r].i, found_.rows[r].j + lane};
    return give(a, b, pairs_of_rows_.data(), count);
  }

  bool give(const Run& a, const Run& b, Found_pair* pairs, Place count)
  {
    if(a.has_copies && b.has_copies)
      count = remove_pairs_of_other_pieces(a, b, pairs, count);
    return client_.take(a, b, pairs, count, wanted_count_);
  }

  // Moves the pairs that belong to this piece to the front: to the one where not both boxes go on
  // beyond the same side. Returns their number. No jump depends on sides: no processor could
  // foresee it.
  static Place remove_pairs_of_other_pieces(const Run& a, const Run& b, Found_pair* pairs,
                                            Place count)
  {
    const Place* const p = a.sides;
    const Place* const q = b.sides;
    Found_pair* kept = pairs;
    for(const Found_pair *pair = pairs, *end = pairs + count; pair != end; ++pair) {
      const bool is_kept = (p[pair->i] & q[pair->j]) == 0;
      *kept = *pair;
      kept += is_kept;
    }
    return static_cast<Place>(kept - pairs);
  }

  Box_client<Axes>& client_;
  Stop_flag& stop_;
  Place block_index_ = 0;
  Place block_count_ = 1;
  std::uint64_t wanted_count_ = 0;
  Found_pairs found_;
  std::array<Found_pair, lanes * Found_pairs::row_capacity> pairs_of_rows_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SWEEP_H
