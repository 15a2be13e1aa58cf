// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H

// Sweeps one or two sorted runs of points. Lanes find pairs, a thousand at a time. Then the
// undecided ones are decided, and the taker gets all of them.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/with_lanes.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_ties.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Collects the pairs of a run.
template <class Run>
BOOST_NOINLINE void collect_near_within(const Run& run,
                                        const Near_question<typename Run::Coordinate>& question,
                                        Near_pairs& found, const Flush& flush)
{
  with_lanes([&](auto set) { set.collect_within(run, question, found, flush); });
}

// Collects the pairs of a point of run a and a point of run b.
template <class Run>
BOOST_NOINLINE void collect_near_between(const Run& a, const Run& b,
                                         const Near_question<typename Run::Coordinate>& question,
                                         Near_pairs& found, const Flush& flush)
{
  with_lanes([&](auto set) { set.collect_between(a, b, question, found, flush); });
}

template <class Point>
class Near_sweep
{
  static constexpr int dimension = Point::dimension;
  using Run = typename Point::Run;
  using Question = Near_question<typename Point::Number>;

public:
  // Points of runs have numbers instead of what they are reported by if `positions` is not null: it
  // has the latter, by the numbers.
  Near_sweep(const Question& question, const Near_points<dimension>& points,
             const Near_task<dimension>& task, Pair_taker& taker, Stop_flag& stop,
             const Place* const* positions = nullptr)
    : question_(question), ties_(points, task), taker_(taker), stop_(stop), positions_(positions)
  {}

  // From now on, starts from the points of one of `count` blocks of each run only.
  void take_block(Place index, Place count)
  {
    block_index_ = index;
    block_count_ = count;
  }

  bool is_stopped() const { return stop_.is_set(); }

  // Returns how many pairs each arithmetic has decided since the last call.
  Decision_counts take_counts() { return std::exchange(counts_, Decision_counts()); }

  // Gives the pairs of a run to the taker.
  BOOST_NOINLINE void within(const Run& run)
  {
    const Run a = block_of(run);
    const auto flush = [&] { return give_found(a, a); };
    collect_near_within(a, question_, found_, Flush(flush));
    give_found(a, a);
  }

  // Gives the pairs of a point of one run and a point of another.
  BOOST_NOINLINE void between(const Run& run, const Run& b)
  {
    const Run a = block_of(run);
    const auto flush = [&] { return give_found(a, b); };
    collect_near_between(a, b, question_, found_, Flush(flush));
    give_found(a, b);
  }

private:
  Run block_of(const Run& run) const
  {
    return block_count_ == 1 ? run : run.block(block_index_, block_count_);
  }

  // Empties `found_`, and gives the pairs to the taker. Returns false to stop.
  BOOST_NOINLINE bool give_found(const Run& a, const Run& b)
  {
    const Place count = std::exchange(found_.count, 0);
    const Place undecided_count = std::exchange(found_.undecided_count, 0);
    if(stop_.is_set())
      return false;
    counts_.add(Arithmetic_tier::DOUBLE, count);
    if(give(count) && (undecided_count == 0 || give(decide(a, b, undecided_count))))
      return true;
    stop_.set();
    return false;
  }

  bool give(Place count) { return count == 0 || taker_.take(found_.pairs.data(), count); }

  // Replaces the found pairs by the undecided ones that are pairs. Returns how many they are.
  BOOST_NOINLINE Place decide(const Run& a, const Run& b, Place undecided_count)
  {
    Place count = 0;
    for(Place c = 0; c < undecided_count; ++c) {
      if(c + prefetch_distance < undecided_count)
        ties_.prefetch(reported(a, b, found_.undecided[c + prefetch_distance]));
      const Found_pair pair = found_.undecided[c];
      if(ties_.is_pair(a, b, pair, reported(a, b, pair), counts_)) {
        const Place i = a.positions[pair.i], j = b.positions[pair.j];
        found_.pairs[count++] = i < j ? Found_pair{i, j} : Found_pair{j, i};
      }
    }
    return count;
  }

  // Returns what the points at two places are reported by.
  Found_pair reported(const Run& a, const Run& b, Found_pair pair) const
  {
    const Place i = a.positions[pair.i], j = b.positions[pair.j];
    return positions_ == nullptr ? Found_pair{i, j}
                                 : Found_pair{(*positions_)[i], (*positions_)[j]};
  }

  const Question question_;
  Near_ties<Point> ties_;
  Pair_taker& taker_;
  Stop_flag& stop_;
  const Place* const* const positions_;
  Near_pairs found_;
  Decision_counts counts_;
  Place block_index_ = 0;
  Place block_count_ = 1;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H
