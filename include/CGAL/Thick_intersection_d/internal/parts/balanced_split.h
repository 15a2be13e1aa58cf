// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BALANCED_SPLIT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BALANCED_SPLIT_H

// Divides a sequence of points, with the pairs that they stand for, into two groups.

#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// One group is [begin, end) of the sequence if begin <= end, or all but [end, begin). The other one
// is the rest. `error` tells how much more than its share one of the groups has.
struct Split
{
  std::size_t begin = 0;
  std::size_t end = 0;
  double error = 0;
};

// One cut can divide the points evenly, or the pairs: where half of the points are in a crowd with
// all pairs, not both. Two cuts can. Bend the sequence to a circle, and move an arc with a share of
// the points around it. On average it has the same share of the pairs, so somewhere it has
// (Hobby and Rice 1965).
class Split_finder
{
public:
  static constexpr double tolerance = 0.04;

  // `sums[i]` is the load of the first i points, as a share of all loads. One group must have
  // `share` of it.
  Split_finder(std::vector<Point_load> sums, double share)
    : sums_(std::move(sums)), share_(share)
  {}

  // Returns the best split by one cut, if it is good enough, or by two cuts.
  Split operator()() const
  {
    Split best = best_single_cut();
    if(best.error > tolerance) {
      find_arcs(&Point_load::points, best);
      find_arcs(&Point_load::pairs, best);
    }
    return best;
  }

private:
  // Points count more: a process can wait, but not do without memory.
  static constexpr double weight_of_points = 4;

  std::size_t size() const { return sums_.size() - 1; }

  Split best_single_cut() const
  {
    Split best = {0, 0, error_of({0, 0})};
    for(std::size_t end = 1; end <= size(); ++end)
      take_better(0, end, best);
    return best;
  }

  // Moves an arc with a share of one of the loads around the circle.
  void find_arcs(double Point_load::*load, Split& best) const
  {
    std::size_t last = 0; // the arc [begin, last) has less than the share, unless it is empty
    for(std::size_t begin = 0; begin < size(); ++begin) {
      while(last < begin + size() && sum(last) .* load - sums_[begin] .* load < share_)
        ++last;
      take_better(begin, last, best);
      if(last > begin)
        take_better(begin, last - 1, best);
    }
  }

  // The load before a place that may be in the second turn.
  Point_load sum(std::size_t place) const
  {
    if(place <= size())
      return sums_[place];
    const Point_load& rest = sums_[place - size()];
    return {sums_.back().points + rest.points, sums_.back().pairs + rest.pairs};
  }

  void take_better(std::size_t begin, std::size_t end, Split& best) const
  {
    const Point_load below = sums_[begin], above = sum(end);
    const double error = error_of({above.points - below.points, above.pairs - below.pairs});
    if(error < best.error)
      best = {begin, end <= size() ? end : end - size(), error};
  }

  double error_of(const Point_load& load) const
  {
    return weight_of_points * excess(load.points, sums_.back().points)
           + excess(load.pairs, sums_.back().pairs);
  }

  // Returns how much more than its share one of the groups has. `all` is 1, or 0 if nothing is
  // known.
  double excess(double load, double all) const
  {
    return all > 0 ? (std::max)(load / share_, (1 - load) / (1 - share_)) - 1 : 0;
  }

  std::vector<Point_load> sums_;
  double share_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_BALANCED_SPLIT_H
