// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ORDER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ORDER_H

// Orders the boxes of a piece along the sweep axis, and finds the candidates of each box.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_columns.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Axes>
class Box_order
{
  using Columns = Box_columns<Axes>;

public:
  void set(const Piece<Piece_box<Axes>>& piece, int sweep_axis,
           const Box_tuning& tuning = Box_tuning())
  {
    set_count_ = piece.set_count();
    Interval range;
    for(const auto& span : piece)
      for(const auto* box = span.first; box != span.last; ++box)
        range.add(box->low[sweep_axis]);
    const Equal_cut cut(range, piece.size());
    double pairs_in_buckets = 0;
    for(std::size_t set = 0; set < set_count_; ++set)
      pairs_in_buckets += columns_[set].count(piece[set], sweep_axis, cut);
    for(std::size_t set = 0; set < set_count_; ++set)
      if(pairs_in_buckets > tuning.max_bucket_pairs * piece.size())
        columns_[set].sort();
      else
        columns_[set].distribute();
    find_candidates();
  }

  // The candidates of all boxes.
  std::uint64_t candidate_count() const { return candidate_count_; }

  // The same of one of `count` blocks of each run.
  std::uint64_t candidate_count_of_block(Place index, Place count) const
  {
    std::uint64_t sum = 0;
    for(std::size_t set = 0; set < set_count_; ++set)
      sum += run(set).block(index, count).candidate_count();
    return sum;
  }

  std::size_t set_count() const { return set_count_; }

  // The boxes of a set, and the run with their candidates: that of the other set, if there is one.
  const Box_run<Axes>& run(std::size_t set) const { return columns_[set].run(); }
  const Box_run<Axes>& candidates(std::size_t set) const { return run(set_count_ - 1 - set); }

  // The share of wanted pairs of boxes among the candidates, by a sample of them: a random one in
  // each of `crowd_sample` steps. A scene made to mislead a sample at equal steps would be swept in
  // quadratic time. is_wanted(i, j) takes positions.
  template <class Function>
  double share_of_pairs(const Function& is_wanted) const
  {
    Random_numbers random(seed());
    const double step = static_cast<double>(candidate_count_) / crowd_sample;
    Place steps = 0;
    double next = 0;
    const auto take_step = [&] { next = step * (steps++ + double(random()) / random.largest()); };
    take_step();
    double passed = 0;
    Place pairs = 0;
    for(std::size_t set = 0; set < set_count_; ++set) {
      const auto& a = run(set);
      const auto& b = candidates(set);
      for(Place i = a.first; i < a.last; passed += a.ends[i] - a.begins[i], ++i)
        for(; next < passed + (a.ends[i] - a.begins[i]); take_step()) {
          const Place j = a.begins[i] + static_cast<Place>(next - passed);
          pairs += do_meet(a, i, b, j) && is_wanted(a.positions[i], b.positions[j]);
        }
    }
    return static_cast<double>(pairs) / crowd_sample;
  }

private:
  // Equal boxes give equal seeds, so that reports depend on the boxes alone.
  std::uint32_t seed() const
  {
    std::size_t hash = 0;
    for(std::size_t set = 0; set < set_count_; ++set)
      for(const auto& ends : {run(set).low, run(set).high})
        for(const double* end : ends)
          boost::hash_range(hash, end + run(set).first, end + run(set).last);
    const std::uint64_t wide = hash; // a size may have 32 bits
    return static_cast<std::uint32_t>(wide ^ (wide >> 32));
  }

  static bool do_meet(const Box_run<Axes>& a, Place i, const Box_run<Axes>& b, Place j)
  {
    bool meet = (a.sides[i] & b.sides[j]) == 0;
    for(int axis = 0; axis < Axes; ++axis)
      meet = meet && a.low[axis][i] <= b.high[axis][j] && b.low[axis][j] <= a.high[axis][i];
    return meet;
  }

  // Each pair that may meet becomes a box and its candidate once. In one set, the candidate is
  // behind the box. In two sets, the candidate is in the same bucket as the box or in a later
  // one if it is of the second set, and in a later one if it is of the first set.
  void find_candidates()
  {
    Columns& a = columns_[0];
    Columns& b = columns_[1];
    if(set_count_ == 1)
      candidate_count_ = a.set_candidates(a, [](Place i) { return i + 1; });
    else {
      candidate_count_ = a.set_candidates(b, [&](Place i) { return b.begin_of(a.low(i)); });
      candidate_count_ += b.set_candidates(a, [&](Place j) { return a.end_of(b.low(j)); });
    }
  }

  std::array<Columns, 2> columns_; // of the sets
  std::size_t set_count_ = 1;
  std::uint64_t candidate_count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_ORDER_H
