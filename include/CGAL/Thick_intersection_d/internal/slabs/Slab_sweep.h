// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_SWEEP_H

// The sweeps of the slab route: each strip against itself and against the strips behind it that are
// within reach. Each pair of strips is met once, so no pair of points is reported twice.

#include <CGAL/Thick_intersection_d/internal/predicates/Near_tie_test.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/near_points.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Decide` has bool operator()(Place position, Place position, Decision_counts&): whether a pair is
// within the bound that neither the filter nor the close call decides. The close call is one that
// decides nothing unless all doubles are exact. `Report` takes two positions and returns false to
// stop.
template <int Dimension, class Decide, class Report>
class Slab_sweep
{
public:
  Slab_sweep(double reach, const Distance_filter& filter, const Close_call& close_call,
             const Decide& decide, Report& report)
    : reach_(reach), filter_(filter), close_call_(close_call), decide_(decide), report_(report)
  {}

  // Takes only this one of `count` shares of all pairs from now on.
  void take_share(Place index, Place count)
  {
    share_index_ = index;
    share_count_ = count;
  }

  // Which arithmetic has decided the pairs so far.
  const Decision_counts& counts() const { return counts_; }

  // Reports the pairs of a point of a slab and one of any of some slabs, which may include itself.
  bool between(const Strips<Dimension>& a, const std::vector<const Strips<Dimension>*>& slabs)
  {
    for(const Strips<Dimension>* b : slabs)
      if(!(b == &a ? within(a) : between(a, *b)))
        return false;
    return true;
  }

  // Reports the pairs of a slab.
  bool within(const Strips<Dimension>& slab)
  {
    const auto& strips = slab.strips();
    for(auto p = strips.begin(); p != strips.end() && !is_stopped_; ++p) {
      sweep(slab.run(*p));
      for(auto q = p + 1; q != strips.end() && q->ranges[1].low - p->ranges[1].high <= reach_; ++q)
        sweep_near_parts(slab, *p, slab, *q);
    }
    return !is_stopped_;
  }

  // Reports the pairs of a point of one slab and a point of another.
  bool between(const Strips<Dimension>& a, const Strips<Dimension>& b)
  {
    const Range within_b = reachable(b.range(last_axis));
    const Range within_a = reachable(a.range(last_axis));
    keep(a, a.strips(), last_axis, within_b, layer_a_);
    keep(b, b.strips(), last_axis, within_a, layer_b_);
    auto first = layer_b_.strips().begin(); // those before are too low for all strips to come
    const auto last = layer_b_.strips().end();
    for(const Strip<Dimension>& p : layer_a_.strips()) {
      while(first != last && p.ranges[1].low - first->ranges[1].high > reach_)
        ++first;
      for(auto q = first; q != last && q->ranges[1].low - p.ranges[1].high <= reach_; ++q)
        if constexpr(Dimension == 2)
          sweep(layer_a_.run(p), layer_b_.run(*q));
        else
          sweep_near_parts(layer_a_, p, layer_b_, *q);
    }
    return !is_stopped_;
  }

private:
  static constexpr int last_axis = Dimension - 1;

  // The coordinates within reach of a range. One rounding does not lose any, since it is monotone.
  Range reachable(const Range& range) const { return {range.low - reach_, range.high + reach_}; }

  template <class Some_strips>
  void keep(const Strips<Dimension>& slab, const Some_strips& strips, int axis, const Range& range,
            Strips<Dimension>& kept)
  {
    Place size = 0;
    Place longest = 0;
    for(const Strip<Dimension>& strip : strips) {
      size += strip.end - strip.begin;
      longest = (std::max)(longest, strip.end - strip.begin);
    }
    kept.reset(size, static_cast<Place>(strips.size()));
    Place* const places = places_.require(longest);
    for(const Strip<Dimension>& strip : strips)
      kept.append_part(slab, strip, axis, range, places);
  }

  // Reports the pairs of a point of strip p and one of strip q, after a look at axis 1.
  void sweep_near_parts(const Strips<Dimension>& a, const Strip<Dimension>& p,
                        const Strips<Dimension>& b, const Strip<Dimension>& q)
  {
    keep(a, std::array<Strip<Dimension>, 1>{p}, 1, reachable(q.ranges[1]), part_a_);
    keep(b, std::array<Strip<Dimension>, 1>{q}, 1, reachable(p.ranges[1]), part_b_);
    if(!part_a_.strips().empty() && !part_b_.strips().empty())
      sweep(part_a_.run(part_a_.strips().front()), part_b_.run(part_b_.strips().front()));
  }

  Run<Dimension> share_of(const Run<Dimension>& run) const
  {
    return share_count_ == 1 ? run : run.share(share_index_, share_count_);
  }

  void sweep(const Run<Dimension>& run)
  {
    const Run<Dimension> a = share_of(run);
    collect_within(a, reach_, filter_, candidates_, [&] { return flush(a, a); });
    flush(a, a);
  }

  void sweep(const Run<Dimension>& run, const Run<Dimension>& b)
  {
    const Run<Dimension> a = share_of(run);
    collect_between(a, b, reach_, filter_, candidates_, [&] { return flush(a, b); });
    flush(a, b);
  }

  static double squared_distance(const Run<Dimension>& a, const Run<Dimension>& b, Candidate pair)
  {
    double s = 0;
    for(int axis = 0; axis < Dimension; ++axis) {
      const double gap = a.x[axis][pair.i] - b.x[axis][pair.j];
      s += gap * gap;
    }
    return s;
  }

  // Whether a candidate is within the bound. Its doubles are in the cache, the points are not.
  bool is_near(const Run<Dimension>& a, const Run<Dimension>& b, Candidate pair)
  {
    if(squared_distance(a, b, pair) <= filter_.inside) {
      counts_.add(Arithmetic_tier::DOUBLE);
      return true;
    }
    const auto x = [&](int axis) { return a.x[axis][pair.i]; };
    const auto y = [&](int axis) { return b.x[axis][pair.j]; };
    if(const std::optional<bool> is_within = close_call_.decide(x, y, Dimension, counts_))
      return *is_within;
    return decide_(a.positions[pair.i], b.positions[pair.j], counts_);
  }

  // Reports the collected pairs that are within the bound.
  bool flush(const Run<Dimension>& a, const Run<Dimension>& b)
  {
    const Place count = candidates_.count;
    candidates_.count = 0;
    const bool is_any_undecided = std::exchange(candidates_.is_any_undecided, false);
    if(report_.is_stopped())
      is_stopped_ = true;
    else if(is_any_undecided)
      is_stopped_ = !report_decided<true>(a, b, count);
    else {
      counts_.add(Arithmetic_tier::DOUBLE, count);
      is_stopped_ = !report_decided<false>(a, b, count);
    }
    return !is_stopped_;
  }

  // A loop without stores of its own, for the sake of short callbacks.
  template <bool is_any_undecided>
  bool report_decided(const Run<Dimension>& a, const Run<Dimension>& b, Place count)
  {
    for(Place c = 0; c < count; ++c) {
      const Candidate pair = candidates_.pairs[c];
      const Place i = a.positions[pair.i];
      const Place j = b.positions[pair.j];
      if constexpr(is_any_undecided)
        if(!is_near(a, b, pair))
          continue;
      const Place swapped = (i ^ j) & (Place(0) - static_cast<Place>(j < i)); // no branch
      if(!report_(i ^ swapped, j ^ swapped))
        return false;
    }
    return true;
  }

  const double reach_;
  const Distance_filter filter_;
  const Close_call close_call_;
  const Decide decide_;
  Report& report_;
  Place share_index_ = 0;
  Place share_count_ = 1;
  bool is_stopped_ = false;
  Decision_counts counts_;
  Candidates candidates_;
  Strips<Dimension> layer_a_, layer_b_; // of slabs, within reach of each other
  Strips<Dimension> part_a_, part_b_;   // of strips, likewise
  Buffer<Place> places_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_SWEEP_H
