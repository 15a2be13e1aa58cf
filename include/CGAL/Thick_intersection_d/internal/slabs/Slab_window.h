// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H

// The slabs within reach of the slab that is being swept. Only these slabs are ready at a time, so
// the sweep finds them in the cache.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_stream.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <cstddef>
#include <iterator>
#include <list>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Leaves a slab as it is.
struct Leave_slab
{
  template <class Point>
  void operator()(Strips<Point>&) const
  {}
};

// Calls number(slab) for each slab that becomes ready, in their order.
template <class Point, class Number = Leave_slab>
class Slab_window
{
public:
  using Slabs_nearby = std::vector<const Strips<Point>*>;

  // Starts with the slab `first`.
  Slab_window(const Slabs<Point>& slabs, double reach, Place first, const Slab_tuning& tuning,
              const Number& number = Number())
    : stream_(slabs, reach, first, tuning), reach_(reach), end_(slabs.count()), number_(number)
  {}

  // Returns the first slab in the window, or nullptr if there is none.
  const Strips<Point>* front() { return at(0); }

  // Returns the number of the slab that the first strips in the window belong to. Returns the
  // number of all slabs if the window is empty.
  Place slab() { return front() ? ready_.front().slab : end_; }

  // Returns the number of the slab that strips in the window belong to. `index` counts from the
  // first ones, and is that of strips that were made ready.
  Place slab(std::size_t index) const
  {
    return std::next(ready_.begin(), static_cast<std::ptrdiff_t>(index))->slab;
  }

  void pop()
  {
    spare_.clear();
    spare_.splice(spare_.begin(), ready_, ready_.begin());
  }

  // Sets `slabs` to the slabs in the window that are not beyond reach above `high`. Slabs follow
  // each other. So the next slab is not made ready if the last one ends beyond reach.
  void find_within_reach(double high, Slabs_nearby& slabs)
  {
    slabs.clear();
    while(slabs.empty() || slabs.back()->interval(axis).high - high <= reach_) {
      const Strips<Point>* const next = at(slabs.size());
      if(!next || next->interval(axis).low - high > reach_)
        return;
      slabs.push_back(next);
    }
  }

private:
  struct Ready_slab
  {
    Strips<Point> strips;
    Place slab = 0;
  };

  static constexpr int axis = Point::slab_axis;

  const Strips<Point>* at(std::size_t index)
  {
    while(index >= ready_.size()) {
      if(spare_.empty())
        spare_.emplace_back();
      Ready_slab& next = spare_.front();
      if(!stream_.next(next.strips))
        return nullptr;
      next.slab = stream_.slab();
      number_(next.strips);
      ready_.splice(ready_.end(), spare_, spare_.begin());
    }
    return &std::next(ready_.begin(), static_cast<std::ptrdiff_t>(index))->strips;
  }

  Slab_stream<Point> stream_;
  const double reach_;
  const Place end_;
  const Number number_;
  // Lists, because strips stay where they are while others come and go.
  std::list<Ready_slab> ready_;
  std::list<Ready_slab> spare_; // at most one, whose memory is used again
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H
