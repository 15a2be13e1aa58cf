// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H

// Sweeps one or two sorted runs of points: lanes find near pairs, the test decides those that lanes
// left undecided, and the report gets them. It does not know where the runs come from.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Flush.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/with_lanes.h>

#include <CGAL/Arithmetic_tier.h>

#include <boost/config.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether a report takes many pairs at once: report_pairs(pairs, count) takes `count` pairs of
// positions.
template <class Report, class = void>
inline constexpr bool takes_found_pairs = false;

template <class Report>
inline constexpr bool
  takes_found_pairs<Report, std::void_t<decltype(&Report::report_pairs)>> = true;

// `Test` decides what a pair is. It has
//
//   Run                         sorted points in columns, with positions and block()
//   question()                  the question that lanes ask
//   ask_for(a, b, pair)         may ask for the memory that is_pair() will read
//   is_pair(a, b, pair, counts) decides about a pair that lanes left undecided
//
// `Report` takes two positions, returns false to stop, and has is_stopped().
template <class Test, class Report>
class Near_sweep
{
  using Run = typename Test::Run;

public:
  Near_sweep(const Test& test, Report& report) : test_(test), report_(report) {}

  // From now on, starts from the points of one of `count` blocks of each run only.
  void take_block(Place index, Place count)
  {
    block_index_ = index;
    block_count_ = count;
  }

  bool is_stopped() const { return is_stopped_; }

  // How many pairs each arithmetic has decided so far.
  const Decision_counts& counts() const { return counts_; }

  // Reports the pairs of a run.
  void within(const Run& run)
  {
    const Run a = block_of(run);
    const auto flush = [&] { return report_found(a, a); };
    with_lanes([&](auto set) {
      set.collect_within(a, test_.question(), found_, Flush(flush));
    });
    flush();
  }

  // Reports the pairs of a point of one run and a point of another.
  void between(const Run& run, const Run& b)
  {
    const Run a = block_of(run);
    const auto flush = [&] { return report_found(a, b); };
    with_lanes([&](auto set) {
      set.collect_between(a, b, test_.question(), found_, Flush(flush));
    });
    flush();
  }

private:
  // How many undecided pairs ahead the memory of a pair is asked for.
  static constexpr Place prefetch_distance = 12;

  Run block_of(const Run& run) const
  {
    return block_count_ == 1 ? run : run.block(block_index_, block_count_);
  }

  // Reports the found pairs that are pairs. Returns false to stop. Lanes call this function once
  // per thousand found pairs.
  BOOST_NOINLINE bool report_found(const Run& a, const Run& b)
  {
    const Place count = std::exchange(found_.count, 0);
    const Place undecided_count = std::exchange(found_.undecided_count, 0);
    is_stopped_ = report_.is_stopped();
    if(!is_stopped_) {
      counts_.add(Arithmetic_tier::DOUBLE, count);
      is_stopped_ = !report_pairs(count)
                    || (undecided_count != 0 && !report_undecided(a, b, undecided_count));
    }
    return !is_stopped_;
  }

  // The loop itself stores nothing. This makes short callbacks fast.
  bool report_pairs(Place count)
  {
    if constexpr(takes_found_pairs<Report>)
      return report_.report_pairs(found_.pairs.data(), count);
    else {
      for(Place c = 0; c < count; ++c)
        if(!report_(found_.pairs[c].i, found_.pairs[c].j))
          return false;
      return true;
    }
  }

  BOOST_NOINLINE bool report_undecided(const Run& a, const Run& b, Place count)
  {
    for(Place c = 0; c < count; ++c) {
      if(c + prefetch_distance < count)
        test_.ask_for(a, b, found_.undecided[c + prefetch_distance]);
      if(test_.is_pair(a, b, found_.undecided[c], counts_)
         && !report_pair(a.positions[found_.undecided[c].i], b.positions[found_.undecided[c].j]))
        return false;
    }
    return true;
  }

  bool report_pair(Place i, Place j) { return i < j ? report_(i, j) : report_(j, i); }

  const Test& test_;
  Report& report_;
  Place block_index_ = 0;
  Place block_count_ = 1;
  bool is_stopped_ = false;
  Decision_counts counts_;
  Near_pairs found_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H
