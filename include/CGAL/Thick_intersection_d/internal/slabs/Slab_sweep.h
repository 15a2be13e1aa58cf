// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_SWEEP_H

// Chooses the runs to sweep. Each strip of a slab meets itself, and the strips within reach behind
// it. The strips of two slabs meet if they are within reach. Each two strips meet once, so no pair
// is reported twice.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>

#include <boost/config.hpp> // BOOST_NOINLINE

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Sweep` has the functions within(run), between(a, b) and is_stopped().
template <class Point, class Sweep = Near_sweep<Point>>
class Slab_sweep
{
  static constexpr int dimension = Point::dimension;
  using Strip_of_points = Strip<dimension>;

public:
  Slab_sweep(double reach, Sweep& sweep) : reach_(reach), sweep_(sweep) {}

  // Sweeps a slab with some slabs, which may include itself.
  void between(const Strips<Point>& a, const Slabs_nearby<Point>& slabs)
  {
    for(const Strips<Point>* b : slabs) {
      if(b == &a)
        within(a);
      else
        between(a, *b);
      if(sweep_.is_stopped())
        return;
    }
  }

  // Sweeps a slab with itself.
  void within(const Strips<Point>& slab)
  {
    const auto& strips = slab.strips();
    for(auto p = strips.begin(); p != strips.end() && !sweep_.is_stopped(); ++p) {
      if(may_meet(*p, *p))
        sweep_.within(slab.run(*p));
      for(auto q = p + 1; q != strips.end() && q->box[1].low - p->box[1].high <= reach_; ++q)
        if(may_meet(*p, *q)) {
          if(q->box[1].low <= p->box[1].high) // the points of the other set in the same strip
            sweep_.between(slab.run(*p), slab.run(*q));
          else
            sweep_strips(slab, *p, slab, *q);
        }
    }
  }

  // Sweeps one slab with another slab. Only their borders meet: the points of either slab that are
  // within reach of the other slab.
  void between(const Strips<Point>& a, const Strips<Point>& b)
  {
    collect_slab_border(a, reachable(b.interval(slab_axis)), slab_border_a_);
    collect_slab_border(b, reachable(a.interval(slab_axis)), slab_border_b_);
    auto first = slab_border_b_.strips().begin(); // strips before it are too low for later p
    const auto last = slab_border_b_.strips().end();
    for(const Strip_of_points& p : slab_border_a_.strips()) {
      while(first != last && p.box[1].low - first->box[1].high > reach_)
        ++first;
      for(auto q = first; q != last && q->box[1].low - p.box[1].high <= reach_; ++q)
        if(may_meet(p, *q))
          sweep_strips(slab_border_a_, p, slab_border_b_, *q);
    }
  }

private:
  static constexpr int slab_axis = Point::slab_axis;

  // Returns the coordinates within reach of an interval. One rounding is monotone, so it loses none
  // of them.
  Interval reachable(const Interval& interval) const
  {
    return {interval.low - reach_, interval.high + reach_};
  }

  void collect_slab_border(const Strips<Point>& slab, const Interval& interval,
                           Strips<Point>& border)
  {
    const Strip_of_points* const strips = slab.strips().data();
    collect_border(slab, strips, strips + slab.strips().size(), slab_axis, interval, border);
  }

  // Sets `border` to the points of the strips [first, last) whose coordinate along `axis` is in
  // `interval`.
  BOOST_NOINLINE void collect_border(const Strips<Point>& slab, const Strip_of_points* first,
                                     const Strip_of_points* last, int axis,
                                     const Interval& interval, Strips<Point>& border)
  {
    Place size = 0;
    for(const Strip_of_points* strip = first; strip != last; ++strip)
      size += strip->size();
    border.reset(size, static_cast<Place>(last - first));
    for(; first != last; ++first)
      border.append_border(slab, *first, axis, interval);
  }

  // Of two sets, strips of different sets meet. `sides` is zero if there is one set.
  static bool may_meet(const Strip_of_points& p, const Strip_of_points& q)
  {
    return (p.sides & q.sides) == 0;
  }

  // Sweeps strips p and q. In the plane they are slabs, or the borders of slabs.
  void sweep_strips(const Strips<Point>& a, const Strip_of_points& p, const Strips<Point>& b,
                    const Strip_of_points& q)
  {
    if(dimension == 2 || are_flat(p, q))
      sweep_.between(a.run(p), b.run(q));
    else
      sweep_borders(a, p, b, q);
  }

  // Whether all points of both strips have one coordinate along axis 1, as those of a plane have.
  static bool are_flat(const Strip_of_points& p, const Strip_of_points& q)
  {
    return p.box[1].low == q.box[1].high && p.box[1].high == q.box[1].low;
  }

  // Sweeps the borders of strips p and q: the points that are within reach of the other strip.
  void sweep_borders(const Strips<Point>& a, const Strip_of_points& p, const Strips<Point>& b,
                     const Strip_of_points& q)
  {
    collect_border(a, &p, &p + 1, 1, reachable(q.box[1]), strip_border_a_);
    collect_border(b, &q, &q + 1, 1, reachable(p.box[1]), strip_border_b_);
    if(!strip_border_a_.strips().empty() && !strip_border_b_.strips().empty())
      sweep_.between(strip_border_a_.run(strip_border_a_.strips().front()),
                     strip_border_b_.run(strip_border_b_.strips().front()));
  }

  const double reach_;
  Sweep& sweep_;
  Strips<Point> slab_border_a_, slab_border_b_;
  Strips<Point> strip_border_a_, strip_border_b_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_SWEEP_H
