// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H

// The slab that is swept, and those behind it within reach.

#include <CGAL/Thick_intersection_d/internal/slabs/Slab_stream.h>

#include <deque>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Consecutive slabs, or parts of slabs, of which only those near the one being swept are held.
template <int Dimension>
class Slab_window
{
public:
  Slab_window(const Slabs<Dimension>& slabs, double reach, Place first,
              const Part_sizes& sizes = Part_sizes())
    : stream_(slabs, reach, first, sizes), reach_(reach), end_(slabs.count())
  {}

  // Returns the strips at `index` in the window, or nullptr if there are no more.
  const Strips<Dimension>* operator[](std::size_t index)
  {
    while(index >= parts_.size()) {
      parts_.push_back(std::move(spare_));
      if(!stream_.next(parts_.back().strips)) {
        parts_.pop_back();
        return nullptr;
      }
      parts_.back().slab = stream_.slab();
    }
    return &parts_[index].strips;
  }

  // Returns the strips at `index` if some of them are within reach above `high`, otherwise nullptr.
  // Strips follow each other, so those before them may tell that they need not be made.
  const Strips<Dimension>* within_reach(std::size_t index, double high)
  {
    if(index > 0 && parts_[index - 1].strips.range(axis).high - high > reach_)
      return nullptr;
    const Strips<Dimension>* const strips = (*this)[index];
    return strips && strips->range(axis).low - high <= reach_ ? strips : nullptr;
  }

  // The number of the slab that the first strips belong to, or that of slabs if there are none.
  Place slab() { return (*this)[0] ? parts_.front().slab : end_; }

  void pop()
  {
    spare_ = std::move(parts_.front());
    parts_.pop_front();
  }

private:
  struct Part
  {
    Strips<Dimension> strips;
    Place slab = 0;
  };

  static constexpr int axis = Dimension - 1; // that slabs are cut along

  Slab_stream<Dimension> stream_;
  const double reach_;
  const Place end_;
  std::deque<Part> parts_;
  Part spare_; // whose memory is used again
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H
