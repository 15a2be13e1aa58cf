// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_RUN_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_RUN_SWEEP_H

// Sweeps one or two sorted runs of points: lanes find near pairs. It does not know where the runs
// come from, nor what decides and takes the pairs. So it is compiled once for all searches.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Flush.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/with_lanes.h>

#include <boost/config.hpp> // BOOST_NOINLINE

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Run_of_points` is a Run.
template <class Run_of_points>
class Run_sweep
{
public:
  using Question = Near_question<typename Run_of_points::Coordinate>;

  // From now on, starts from the points of one of `count` blocks of each run only.
  void take_block(Place index, Place count)
  {
    block_index_ = index;
    block_count_ = count;
  }

  bool is_stopped() const { return is_stopped_; }

  // Reports the pairs of a run.
  BOOST_NOINLINE void within(const Run_of_points& run)
  {
    const Run_of_points a = block_of(run);
    const auto flush = [&] { return report_found_(*this, a, a); };
    with_lanes([&](auto set) { set.collect_within(a, question_, found_, Flush(flush)); });
    report_found_(*this, a, a);
  }

  // Reports the pairs of a point of one run and a point of another.
  BOOST_NOINLINE void between(const Run_of_points& run, const Run_of_points& b)
  {
    const Run_of_points a = block_of(run);
    const auto flush = [&] { return report_found_(*this, a, b); };
    with_lanes([&](auto set) { set.collect_between(a, b, question_, found_, Flush(flush)); });
    report_found_(*this, a, b);
  }

protected:
  // Empties `found_`, and reports the pairs. Returns false to stop, and sets `is_stopped_` then.
  // Lanes call this function once per thousand found pairs. It is no virtual function, because a
  // program holds the name of each class that has one.
  using Report_found = bool (*)(Run_sweep&, const Run_of_points& a, const Run_of_points& b);

  Run_sweep(const Question& question, Report_found report_found)
    : question_(question), report_found_(report_found)
  {}

  Near_pairs found_;
  bool is_stopped_ = false;

private:
  Run_of_points block_of(const Run_of_points& run) const
  {
    return block_count_ == 1 ? run : run.block(block_index_, block_count_);
  }

  const Question question_;
  const Report_found report_found_;
  Place block_index_ = 0;
  Place block_count_ = 1;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_RUN_SWEEP_H
