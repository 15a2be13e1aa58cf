// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_STREAM_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_STREAM_H

// Slabs made ready to be swept, one after another along the last axis.

#include <CGAL/Thick_intersection_d/internal/slabs/Strips_maker.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Slab_stream
{
  using Point = Slab_point<Dimension>;

public:
  // Starts with the slab `first`.
  Slab_stream(const Slabs<Dimension>& slabs, double reach, Place first,
              const Part_sizes& sizes = Part_sizes())
    : slabs_(slabs), reach_(reach), sizes_(sizes), next_slab_(first), maker_(reach, sizes)
  {}

  // The number of the slab that the last strips belong to.
  Place slab() const { return next_slab_ - 1; }

  // Sets `strips` to those of the next slab, or part of a slab; returns false if there is none.
  //
  // Parts of sparse points are higher than usual. If the points in one turn out to crowd along axis
  // 0, as on a line across the slabs or in clusters, it is cut into lower ones after all: then
  // sweeps look at no more than O(C(n + k)) pairs.
  bool next(Strips<Dimension>& strips)
  {
    for(;;) {
      if(pending_.empty()) {
        if(next_slab_ == slabs_.count())
          return false;
        pending_.push_back({slabs_.begin(next_slab_), slabs_.end(next_slab_), 0});
        ++next_slab_;
      }
      const Part part = pending_.back();
      pending_.pop_back();
      if(part.first == part.last)
        continue;
      maker_.count(part.first, part.last);
      const Range range = maker_.range(axis);
      const bool is_high = range.high - range.low > greatest_height * reach_;
      if(is_high && part.depth <= greatest_depth
         && (maker_.is_crowded() || part.size() > sizes_.large_slab)) {
        cut(part, range);
        continue;
      }
      maker_.make(strips);
      return true;
    }
  }

private:
  static constexpr int axis = Dimension - 1;
  static constexpr int greatest_depth = 2;

  struct Part
  {
    const Point* first;
    const Point* last;
    int depth;

    Place size() const { return static_cast<Place>(last - first); }
  };

  // Cuts a part into lower ones, which come next: of equal height, or if that was tried before,
  // where the points are.
  void cut(const Part& part, const Range& range)
  {
    const Equal_cut cut(range, part_count(range, part.size(), reach_, sizes_.strip));
    if(part.depth == greatest_depth || cut.count() == 1)
      cut_sorted(part);
    else
      cut_equally(part, cut);
  }

  void cut_equally(const Part& part, const Equal_cut& cut)
  {
    std::vector<Place> ends(cut.count(), 0); // of the parts, when all points are in
    for(const Point* p = part.first; p != part.last; ++p)
      ++ends[cut(p->x[axis])];
    Place sum = 0;
    for(Place& end : ends)
      sum += std::exchange(end, sum);
    Point* const points = scratch_[part.depth].require(part.size());
    for(const Point* p = part.first; p != part.last; ++p)
      points[ends[cut(p->x[axis])]++] = *p;
    for(Place p = cut.count(); p-- > 0;)
      pending_.push_back({points + (p == 0 ? 0 : ends[p - 1]), points + ends[p], part.depth + 1});
  }

  void cut_sorted(const Part& part)
  {
    Point* const points = scratch_[part.depth].require(part.size());
    std::copy(part.first, part.last, points);
    sorter_.template sort<axis>(points, points + part.size());
    const auto bottom = static_cast<std::ptrdiff_t>(pending_.size());
    for_each_sorted_part<axis>(points, points + part.size(), usual_height * reach_,
                               sizes_.sorted_part, [&](const Point* first, const Point* last) {
                                 pending_.push_back({first, last, greatest_depth + 1});
                               });
    std::reverse(pending_.begin() + bottom, pending_.end());
  }

  const Slabs<Dimension>& slabs_;
  const double reach_;
  const Part_sizes sizes_;
  Place next_slab_;
  std::vector<Part> pending_; // the last one comes first
  std::array<Buffer<Point>, greatest_depth + 1> scratch_; // the points of parts, by depth
  Strips_maker<Dimension> maker_;
  Bucket_sorter<Dimension> sorter_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_STREAM_H
