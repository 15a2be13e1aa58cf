// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H

// Sweeps one or two sorted runs of points: the test decides those pairs that lanes left undecided,
// and the report gets the pairs.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/prefetch.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Run_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>

#include <boost/config.hpp> // BOOST_NOINLINE

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

// Whether a report has numbered the points of the runs: position(number) has their positions.
template <class Report, class = void>
inline constexpr bool has_positions = false;

template <class Report>
inline constexpr bool has_positions<Report, std::void_t<decltype(&Report::position)>> = true;

// `Test` decides what a pair is. It has
//
//   Run                         sorted points in columns, with positions and block()
//   question()                  the question that lanes ask
//   ask_for(i)                  may ask for the memory that is_pair() reads of the point at i
//   is_pair(a, b, pair, at, counts)  decides about a pair that lanes left undecided
//
// where `at` has the positions of the points, and `pair` their places in the runs.
//
// `Report` takes two positions, returns false to stop, and has is_stopped().
template <class Test, class Report>
class Near_sweep : public Run_sweep<typename Test::Run>
{
  using Run = typename Test::Run;
  using Base = Run_sweep<Run>;
  using Base::found_;
  using Base::is_stopped_;

public:
  Near_sweep(const Test& test, Report& report)
    : Base(test.question(), [](Base& sweep, const Run& a, const Run& b) {
        return static_cast<Near_sweep&>(sweep).report_found(a, b);
      }),
      test_(test), report_(report)
  {}

  // How many pairs each arithmetic has decided so far.
  const Decision_counts& counts() const { return counts_; }

private:
  // Reports the found pairs that are pairs.
  bool report_found(const Run& a, const Run& b)
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
        ask_for(positions(a, b, found_.undecided[c + prefetch_distance]));
      const Found_pair pair = found_.undecided[c];
      if(test_.is_pair(a, b, pair, positions(a, b, pair), counts_)
         && !report_pair(a.positions[pair.i], b.positions[pair.j]))
        return false;
    }
    return true;
  }

  void ask_for(Found_pair at) const
  {
    test_.ask_for(at.i);
    test_.ask_for(at.j);
  }

  Found_pair positions(const Run& a, const Run& b, Found_pair pair) const
  {
    const Place i = a.positions[pair.i], j = b.positions[pair.j];
    if constexpr(has_positions<Report>)
      return {report_.position(i), report_.position(j)};
    else
      return {i, j};
  }

  bool report_pair(Place i, Place j) { return i < j ? report_(i, j) : report_(j, i); }

  const Test& test_;
  Report& report_;
  Decision_counts counts_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SWEEP_H
