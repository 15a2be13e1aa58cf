// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_STREAM_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_STREAM_H

// Makes one slab after another ready for the sweep. Cuts large or crowded slabs again.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Bucket_sorter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_column.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips_maker.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A slab that is not ready: points of the last one of the slabs, or of a buffer. It has places
// instead of pointers, so it is compiled once for all kinds of points.
struct Pending_slab
{
  Place begin;
  Place end;
  int cuts;   // how often the points were cut
  int buffer; // negative for the slabs

  Place size() const { return end - begin; }
};

template <class Point>
class Slab_stream
{
public:
  // Starts with the slab `first`.
  Slab_stream(const Slab_column<Point>& slabs, double reach, Place first, const Slab_tuning& tuning)
    : slabs_(slabs), reach_(reach), tuning_(tuning), next_slab_(first),
      maker_(reach, slabs.sets(), tuning)
  {}

  // Returns the number of the slab that the last strips belong to.
  Place slab() const { return next_slab_ - 1; }

  // Sets `strips` to the strips of the next slab. A slab that was cut gives several slabs. Returns
  // false if there is no further slab.
  //
  // A slab of sparse points is higher than usual. Its points may be crowded along axis 0, if they
  // form clusters, or a line across the slabs. Then the slab is cut into lower ones, so that sweeps
  // look at O(C(n + k)) pairs. A high slab with too many points for the cache is cut as well.
  bool next(Strips<Point>& strips)
  {
    for(;;) {
      if(pending_.empty() && !take_next_slab())
        return false;
      const Pending_slab slab = pending_.back();
      pending_.pop_back();
      if(slab.size() == 0)
        continue;
      maker_.count(begin(slab), end(slab));
      const Interval interval = maker_.interval(axis);
      if(interval.length() > max_height * reach_ && slab.cuts <= max_cut_depth
         && (maker_.is_crowded() || slab.size() > tuning_.max_slab_size)) {
        cut(slab, interval);
        continue;
      }
      maker_.make(strips);
      return true;
    }
  }

private:
  static constexpr int axis = Point::slab_axis;

  const Point* begin(const Pending_slab& slab) const
  {
    return (slab.buffer < 0 ? points_ : scratch_[slab.buffer].data()) + slab.begin;
  }
  const Point* end(const Pending_slab& slab) const { return begin(slab) + slab.size(); }

  bool take_next_slab()
  {
    if(next_slab_ == slabs_.count())
      return false;
    Place size = 0;
    points_ = slabs_.points(next_slab_, unpacked_, size);
    pending_.push_back({0, size, 0, -1});
    ++next_slab_;
    return true;
  }

  // Cuts a slab into lower ones, which come next. They have equal heights, unless equal cuts were
  // tried max_cut_depth times, or are impossible. Then the slab is cut where the points are.
  void cut(const Pending_slab& slab, const Interval& interval)
  {
    const Equal_cut cut(interval, piece_count(interval, slab.size(), reach_,
                                              tuning_.points_per_strip));
    if(slab.cuts == max_cut_depth || cut.count() == 1)
      cut_sorted(slab);
    else
      cut_equally(slab, cut);
  }

  void cut_equally(const Pending_slab& slab, const Equal_cut& cut)
  {
    const Point* const first = begin(slab);
    const Point* const last = end(slab);
    std::vector<Place> ends(cut.count(), 0); // the ends of the lower slabs, once these are full
    for(const Point* p = first; p != last; ++p)
      ++ends[cut(p->x[axis])];
    replace_by_prefix_sums(ends.data(), ends.data() + ends.size());
    Point* const points = scratch_[slab.cuts].require(slab.size());
    for(const Point* p = first; p != last; ++p)
      points[ends[cut(p->x[axis])]++] = *p;
    for(Place s = cut.count(); s-- > 0;)
      pending_.push_back({s == 0 ? 0 : ends[s - 1], ends[s], slab.cuts + 1, slab.cuts});
  }

  void cut_sorted(const Pending_slab& slab)
  {
    Point* const points = scratch_[slab.cuts].require(slab.size());
    std::copy(begin(slab), end(slab), points);
    sorter_.sort(points, points + slab.size(), axis);
    const auto bottom = static_cast<std::ptrdiff_t>(pending_.size());
    for_each_sorted_piece(points, points + slab.size(), axis, usual_height * reach_,
                          tuning_.points_per_sorted_strip,
                          [&](const Point* first, const Point* last) {
                            pending_.push_back({static_cast<Place>(first - points),
                                                static_cast<Place>(last - points),
                                                max_cut_depth + 1, slab.cuts});
                          });
    std::reverse(pending_.begin() + bottom, pending_.end());
  }

  const Slab_column<Point> slabs_;
  const double reach_;
  const Slab_tuning tuning_;
  Place next_slab_;
  const Point* points_ = nullptr;     // of the last one of the slabs
  Buffer<Point> unpacked_;            // the same, if they are stored otherwise
  std::vector<Pending_slab> pending_; // a stack: the last slab comes first
  std::array<Buffer<Point>, max_cut_depth + 1> scratch_; // the points of slabs that were cut
  Strips_maker<Point> maker_;
  Bucket_sorter<Point> sorter_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_STREAM_H
