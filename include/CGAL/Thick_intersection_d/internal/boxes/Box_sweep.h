// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SWEEP_H

// Sweeps two sorted runs of boxes, which may be the same run: lanes find pairs, the test decides
// those that lanes left undecided, and the report gets the rest. It knows neither where the runs
// come from nor what makes a pair.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/has_groups.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/machine/prefetch.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <cstdint>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Test` decides what a pair is. It has
//
//   Run                                 sorted boxes in columns, with positions and block()
//   collect_between(a, b, found, flush) finds the pairs that are not certainly no pairs, by lanes
//   prefetch(a, b, pair)                 may ask for the memory that is_pair() will read
//   are_undecided(a, b)                 whether found pairs need is_pair()
//   is_pair(a, b, pair)                 decides about a found pair
//   is_of_piece(a, b, pair)             does so if all that lanes left open is whether a pair of
//                                       copies is one of this piece: are_copies(a, b)
//
// It may have groups (has_groups.h). Then do_intersect(i, j) decides about the found pairs that are
// of this piece and wanted. It takes positions.
//
// `Report` takes two positions, returns false to stop, and has is_stopped().
template <class Test, class Report>
class Box_sweep
{
  using Run = typename Test::Run;

public:
  Box_sweep(const Test& test, Report& report) : test_(test), report_(report) {}

  // From now on, starts from the boxes of one of `count` blocks of each run only.
  void take_block(Place index, Place count)
  {
    block_index_ = index;
    block_count_ = count;
  }

  bool is_stopped() const { return is_stopped_; }

  // How many wanted pairs were tested.
  std::uint64_t wanted_count() const { return wanted_count_; }

  // Reports the pairs of a box of one run and a box of the other.
  void between(const Run& run, const Run& b)
  {
    const Run a = block_of(run);
    test_.collect_between(a, b, found_, [&] { return flush(a, b); });
    flush(a, b);
  }

private:
  Run block_of(const Run& run) const
  {
    return block_count_ == 1 ? run : run.block(block_index_, block_count_);
  }

  // Reports the found pairs that are pairs. Returns false to stop. Not inline, so that the loops of
  // lanes stay short. They call this function once per thousand found pairs.
  BOOST_NOINLINE bool flush(const Run& a, const Run& b)
  {
    const Place count = std::exchange(found_.count, 0);
    const Place row_count = std::exchange(found_.row_count, 0);
    if(report_.is_stopped())
      is_stopped_ = true;
    else if(test_.are_undecided(a, b))
      is_stopped_ = !decide_rows(a, b, row_count)
                    || !report_pairs(a, b, test_.are_copies(a, b) ? remove_copies(a, b, count)
                                                                  : remove_others(a, b, count));
    else
      is_stopped_ = !report_rows(a, b, row_count) || !report_pairs(a, b, count);
    return !is_stopped_;
  }

  // Moves the found pairs that are pairs to the front. Returns their number. No jump depends on
  // sides: no processor could foresee it.
  Place remove_copies(const Run& a, const Run& b, Place count)
  {
    Place pair_count = 0;
    for(Place c = 0; c < count; ++c) {
      const Found_pair pair = found_.pairs[c];
      found_.pairs[pair_count] = pair;
      pair_count += test_.is_of_piece(a, b, pair);
    }
    return pair_count;
  }

  // The same, for pairs that need is_pair().
  Place remove_others(const Run& a, const Run& b, Place count)
  {
    Place pair_count = 0;
    for(Place c = 0; c < count; ++c) {
      if(c + prefetch_distance < count)
        test_.prefetch(a, b, found_.pairs[c + prefetch_distance]);
      found_.pairs[pair_count] = found_.pairs[c];
      pair_count += is_pair(a, b, found_.pairs[c]);
    }
    return pair_count;
  }

  // The loop itself stores nothing. This makes short callbacks fast.
  bool report_pairs(const Run& a, const Run& b, Place count)
  {
    for(Place c = 0; c < count; ++c)
      if(!report_pair(a.positions[found_.pairs[c].i], b.positions[found_.pairs[c].j]))
        return false;
    return true;
  }

  bool report_rows(const Run& a, const Run& b, Place row_count)
  {
    for(Place r = 0; r < row_count; ++r)
      if(!report_row(a.positions[found_.rows[r].i], b.positions + found_.rows[r].j))
        return false;
    return true;
  }

  // Not inline, so that compilers make lanes of the others, not of rows.
  BOOST_NOINLINE bool report_row(Place i, const Place* others)
  {
    for(Place lane = 0; lane < lanes; ++lane)
      if(!report_pair(i, others[lane]))
        return false;
    return true;
  }

  // Reports the pairs of rows that are pairs. Returns false to stop.
  bool decide_rows(const Run& a, const Run& b, Place row_count)
  {
    for(Place r = 0; r < row_count; ++r)
      for(Place lane = 0; lane < lanes; ++lane) {
        const Found_pair pair = {found_.rows[r].i, found_.rows[r].j + lane};
        if(is_pair(a, b, pair) && !report_pair(a.positions[pair.i], b.positions[pair.j]))
          return false;
      }
    return true;
  }

  bool is_pair(const Run& a, const Run& b, Found_pair pair)
  {
    if constexpr(has_groups_v<Test>) {
      const Place i = a.positions[pair.i], j = b.positions[pair.j];
      if(!test_.is_of_piece(a, b, pair) || !test_.is_wanted(i, j))
        return false;
      ++wanted_count_;
      return test_.do_intersect(i, j);
    }
    else
      return test_.is_pair(a, b, pair);
  }

  bool report_pair(Place i, Place j)
  {
    const Place swapped = (i ^ j) & (Place(0) - static_cast<Place>(j < i)); // no branch
    return report_(i ^ swapped, j ^ swapped);
  }

  const Test& test_;
  Report& report_;
  Place block_index_ = 0;
  Place block_count_ = 1;
  bool is_stopped_ = false;
  std::uint64_t wanted_count_ = 0;
  Found_pairs found_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SWEEP_H
