// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_SWEEP_H

// The sweeps of the slab route: each part against itself and against the parts behind it that are
// within reach. Each pair of parts is met once, so no pair of points is reported twice.

#include <CGAL/Thick_intersection_d/internal/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/Slab_order.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Decide` has bool operator()(Place position, Place position): the pair is within the bound and
// not certain by the filter. `Report` takes two positions and returns false to stop.
template <int Dimension, class Decide, class Report>
class Slab_sweep
{
  using Points = Slab_points<Dimension>;

public:
  Slab_sweep(const Points& a, const Points& b, double reach, const Distance_filter& filter,
             const Decide& decide, Report& report)
    : a_(a), b_(b), reach_(reach), filter_(filter), decide_(decide), report_(report)
  {}

  // Reports the pairs of one part with itself, and with the parts [next, last) behind it.
  bool part_with_followers(const Part& part, const Part* next, const Part* last)
  {
    sweep_self(part);
    for(; next != last && next->low - part.high <= reach_; ++next)
      sweep(part, *next);
    return flush();
  }

  // Reports the pairs between a part of the first set and the parts of the second.
  bool part_with_others(const Part& part, const Parts& others)
  {
    auto other = std::partition_point(others.begin(), others.end(), [&](const Part& o) {
      return part.low - o.high > reach_;
    });
    for(; other != others.end() && other->low - part.high <= reach_; ++other)
      sweep(part, *other);
    return flush();
  }

private:
  void sweep_self(const Part& part)
  {
    if(is_stopped_)
      return;
    if(part.children.empty()) {
      sweep_sorted(part);
      return;
    }
    for(std::size_t c = 0; c < part.children.size(); ++c) {
      const Part& child = part.children[c];
      sweep_self(child);
      for(std::size_t d = c + 1;
          d < part.children.size() && part.children[d].low - child.high <= reach_; ++d)
        sweep(child, part.children[d]);
    }
  }

  // The children of either part follow each other along their axis.
  void sweep(const Part& p, const Part& q)
  {
    if(is_stopped_)
      return;
    if(p.children.empty()) {
      sweep_sorted(p, q);
      return;
    }
    auto first = q.children.begin(); // those before are too low for all children to come
    for(const Part& c : p.children) {
      while(first != q.children.end() && c.low - first->high > reach_)
        ++first;
      for(auto d = first; d != q.children.end() && d->low - c.high <= reach_; ++d)
        sweep(c, *d);
    }
  }

  // The part is sorted along axis 0: each point meets those behind it, until one is beyond reach.
  void sweep_sorted(const Part& part)
  {
    const Columns x = columns(a_);
    for(Place i = part.begin; i != part.end; ++i)
      collect_window(x, i, x, i + 1, part.end);
  }

  // Both parts are sorted along axis 0: each point meets those within reach on either side.
  void sweep_sorted(const Part& p, const Part& q)
  {
    const Columns x = columns(a_);
    const Columns y = columns(b_);
    Place first = q.begin; // those before are too low for all points to come
    for(Place i = p.begin; i != p.end; ++i) {
      const double low = x[0][i] - reach_; // not above any coordinate within reach
      for(Place step = 0; step < usual_steps; ++step)
        first += static_cast<Place>(first != q.end) & static_cast<Place>(y[0][first] < low);
      while(first != q.end && y[0][first] < low)
        ++first;
      collect_window(x, i, y, first, q.end);
    }
  }

  using Columns = std::array<const double*, Dimension>;

  static Columns columns(const Points& points)
  {
    Columns columns;
    for(int axis = 0; axis < Dimension; ++axis)
      columns[axis] = points.columns[axis].get();
    return columns;
  }

  // A pair that may be within the bound.
  struct Candidate
  {
    Place i;
    Place j;
  };

  static double squared_distance(const Columns& x, Place i, const Columns& y, Place j)
  {
    const double d = x[0][i] - y[0][j];
    double s = d * d;
    for(int axis = 1; axis < Dimension; ++axis) {
      const double difference = x[axis][i] - y[axis][j];
      s += difference * difference;
    }
    return s;
  }

  // Collects the pairs of i with the places from `first` on, until one is beyond the reach along
  // axis 0 or `last`, that may be within the bound. Whether a pair is near is anybody's guess, so
  // each is written, and counted if it is. Distances are computed by blocks, which compilers turn
  // into vector instructions; those beyond the reach do no harm.
  void collect_window(const Columns& x, Place i, const Columns& y, Place first, Place last)
  {
    const double limit = x[0][i] + reach_; // not below any coordinate within reach
    const double outside = filter_.outside;
    Candidate* const candidates = candidates_.data();
    Place count = count_;
    const auto collect = [&](Place j, double s) {
      candidates[count] = {i, j};
      count += s <= outside;
    };

    Place j = first;
    for(const Place usual = first + (std::min)(last - first, usual_steps); j != usual; ++j)
      collect(j, squared_distance(x, i, y, j));
    while(j != last && y[0][j] <= limit) {
      if(last - j >= block) {
        double s[block];
        for(Place lane = 0; lane < block; ++lane)
          s[lane] = squared_distance(x, i, y, j + lane);
        for(Place lane = 0; lane < block; ++lane)
          collect(j + lane, s[lane]);
        j += block;
      }
      else {
        collect(j, squared_distance(x, i, y, j));
        ++j;
      }
      if(count >= capacity) {
        count_ = count;
        if(!flush())
          return;
        count = 0;
      }
    }
    count_ = count;
    if(count >= capacity)
      flush();
  }

  // Reports the collected pairs that are within the bound.
  bool flush()
  {
    const Columns x = columns(a_);
    const Columns y = columns(b_);
    const bool is_certain = filter_.inside == filter_.outside;
    const Place count = count_;
    count_ = 0;
    for(Place c = 0; c < count && !is_stopped_; ++c) {
      const Candidate pair = candidates_[c];
      const Place i = a_.positions[pair.i];
      const Place j = b_.positions[pair.j];
      if(is_certain || squared_distance(x, pair.i, y, pair.j) <= filter_.inside || decide_(i, j))
        is_stopped_ = !report_((std::min)(i, j), (std::max)(i, j));
    }
    return !is_stopped_;
  }

  static constexpr Place capacity = 1024;
  static constexpr Place block = 8;

  // Most windows are no longer than this, and most move by no more from one point to the next: so
  // many steps are made without asking, because a wrong guess of a branch costs more.
  static constexpr Place usual_steps = 2;

  const Points& a_;
  const Points& b_;
  const double reach_;
  const Distance_filter filter_;
  const Decide& decide_;
  Report& report_;
  Place count_ = 0;
  bool is_stopped_ = false;
  std::array<Candidate, capacity + usual_steps + block> candidates_; // all that one round may add
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_SWEEP_H
