// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_ARE_TRACKS_NEAR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_ARE_TRACKS_NEAR_H

// The legs of tracks as the box route reads them, in space and time: two of them are a pair if they
// are within the bound at a common time, and no others of their tracks have told it before. Pairs
// of tracks are remembered for this, unless each track is one stretch.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_bound.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Leg.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Relative_motion.h>
#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Legs>
class Are_tracks_near : public Objects_in_boxes<Legs::dimension + 1>
{
  using Exact = typename Legs::Exact;
  static constexpr int time_axis = Legs::dimension;

public:
  // Counts in `counts` which arithmetic decides, unless `counts` is null. Integers are left out if
  // `least_tier` is that of exact numbers. The legs have been cut.
  template <class NT>
  Are_tracks_near(const Legs& legs, const Distance_bound<NT>& bound, Arithmetic_tier least_tier,
                  Shared_decision_counts* counts, const Threads& threads)
    : legs_(legs), exact_bound_(bound), least_tier_(least_tier), counts_(counts),
      have_groups_(!legs.have_one_stretch_each()), known_(threads)
  {
    set_hull_bound(bound_, bound, exact_bound_);
    // Legs that have no time in common are farther apart than an infinite bound.
    bound_.radius.low = (std::min)(bound_.radius.low, (std::numeric_limits<double>::max)());
  }

  std::size_t size() const { return legs_.size(); }

  auto intervals(std::size_t position) const
  {
    return [this, position](int axis) -> Interval {
      const Interval interval = legs_.interval(position, axis);
      return axis == time_axis ? interval : longer(interval, exact_bound_.reach());
    };
  }

  void prefetch(std::size_t position) const { legs_.prefetch(position); }

  static constexpr bool may_have_groups = true;
  bool have_groups() const { return have_groups_; }
  Place group_of(std::size_t position) const { return legs_.track_of(position); }
  bool is_wanted(std::size_t i, std::size_t j) const
  {
    const Place a = legs_.track_of(i), b = legs_.track_of(j);
    return a != b && (!have_groups_ || !known_.has(a, b));
  }

  // Several threads ask at once. What is known grows by the answers.
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    return are_near(i, j)
           && (!have_groups_ || known_.add(legs_.track_of(i), legs_.track_of(j)));
  }

private:
  void count(Arithmetic_tier tier) const
  {
    if(counts_ != nullptr)
      counts_->add(tier);
  }

  bool are_near(std::size_t i, std::size_t j) const
  {
    if(exact_bound_.is_open() && exact_bound_.is_zero()) // no distance is less than zero
      return false;
    const Leg<Legs::dimension> a = legs_.leg(i), b = legs_.leg(j);
    const Interval distance = distance_of(a, b);
    const bool is_near = distance.high <= bound_.radius.low;
    if(is_near || distance.low > bound_.radius.high) {
      count(Arithmetic_tier::DOUBLE);
      return is_near;
    }
    return decide(i, j, a, b);
  }

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  bool decide(std::size_t i, std::size_t j, const Leg<Legs::dimension>& a,
              const Leg<Legs::dimension>& b) const
  {
    if(a.is_exact() && b.is_exact() && bound_.is_exact_radius && !exact_bound_.is_unbounded()
       && least_tier_ != Arithmetic_tier::FILTERED_EXACT) {
      const Integer_legs<Legs::dimension> legs(a, b, bound_.radius.low);
      if(const std::optional<bool> are_near = legs.are_near(bound_.is_open)) {
        count(Arithmetic_tier::INT128);
        return *are_near;
      }
    }
    count(Arithmetic_tier::FILTERED_EXACT);
    const Relative_motion<Exact, Legs::dimension> motion(legs_.template exact_leg<Exact>(i),
                                                         legs_.template exact_leg<Exact>(j));
    if(!motion.has_time())
      return false;
    const auto [n, d] = motion.least_square();
    return exact_bound_.holds_for(n, d, Exact(0));
  }

  const Legs& legs_;
  const Squared_bound<Exact> exact_bound_;
  Hull_bound bound_;
  const Arithmetic_tier least_tier_;
  Shared_decision_counts* const counts_;
  const bool have_groups_;
  mutable Known_pairs known_; // grows while threads ask
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_ARE_TRACKS_NEAR_H
