// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H

// The slabs within reach of the slab that is being swept. Only these slabs are ready at a time, so
// the sweep finds them in the cache.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_column.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_stream.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A list of slabs that are ready, and a part of it. Lists and vectors of the standard library, too,
// are compiled for each kind of points, but take longer.
template <class Point>
struct Ready_slab
{
  // Destroys the slabs behind it as well. They are few: only slabs within reach are ready, and none
  // is cut lower than the reach. Compilers would expand this wherever a list ends.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED ~Ready_slab() {}

  Strips<Point> strips;
  Place slab = 0; // the number of the slab that the strips belong to
  std::unique_ptr<Ready_slab> next;
};

// A range of pointers to strips.
template <class Point>
class Slabs_nearby
{
public:
  Slabs_nearby() = default;

  // `count` slabs from the first one on.
  Slabs_nearby(const Ready_slab<Point>* first, std::size_t count) : first_(first), count_(count) {}

  class Iterator
  {
  public:
    Iterator(const Ready_slab<Point>* slab, std::size_t left) : slab_(slab), left_(left) {}

    const Strips<Point>* operator*() const { return &slab_->strips; }
    Iterator& operator++()
    {
      slab_ = slab_->next.get();
      --left_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return left_ != other.left_; }

  private:
    const Ready_slab<Point>* slab_;
    std::size_t left_;
  };

  Iterator begin() const { return {first_, count_}; }
  Iterator end() const { return {nullptr, 0}; }

  // Leaves out the slabs before the slab `number`.
  void drop_before(Place number)
  {
    for(; count_ != 0 && first_->slab < number; --count_)
      first_ = first_->next.get();
  }

private:
  const Ready_slab<Point>* first_ = nullptr;
  std::size_t count_ = 0;
};

template <class Point>
class Slab_window
{
public:
  using Slabs_nearby = internal::Slabs_nearby<Point>;

  // Starts with the slab `first`. Points of slabs that become ready get numbers instead of
  // positions, if there are numbers.
  Slab_window(const Slab_column<Point>& slabs, double reach, Place first,
              const Slab_tuning& tuning, Place_numbers* numbers = nullptr)
    : stream_(slabs, reach, first, tuning), reach_(reach), end_(slabs.count()), numbers_(numbers)
  {}

  // Returns the first slab in the window, or nullptr if there is none.
  const Strips<Point>* front() { return is_ready(first_) ? &first_->strips : nullptr; }

  // Returns the number of the slab that the first strips in the window belong to. Returns the
  // number of all slabs if the window is empty.
  Place slab() { return front() ? first_->slab : end_; }

  void pop()
  {
    spare_ = std::move(first_);
    first_ = std::move(spare_->next);
  }

  // Sets `slabs` to the slabs in the window that are not beyond reach above `high`. Slabs follow
  // each other. So the next slab is not made ready if the last one ends beyond reach.
  void find_within_reach(double high, Slabs_nearby& slabs)
  {
    std::size_t count = 0;
    bool may_meet_next = true;
    for(std::unique_ptr<Ready>* next = &first_; may_meet_next && is_ready(*next);
        next = &(*next)->next, ++count) {
      const Interval& interval = (*next)->strips.interval(axis);
      if(interval.low - high > reach_)
        break;
      may_meet_next = interval.high - high <= reach_;
    }
    slabs = Slabs_nearby(first_.get(), count);
  }

private:
  using Ready = Ready_slab<Point>;

  static constexpr int axis = Point::slab_axis;

  // Whether there is a slab at this place of the list. At its end, makes the next slab ready.
  bool is_ready(std::unique_ptr<Ready>& place)
  {
    if(place)
      return true;
    if(!spare_)
      spare_ = std::make_unique<Ready>();
    if(!stream_.next(spare_->strips))
      return false;
    spare_->slab = stream_.slab();
    if(numbers_ != nullptr)
      number(spare_->strips);
    place = std::move(spare_);
    return true;
  }

  void number(Strips<Point>& slab) const
  {
    Place* positions = nullptr;
    const Place first = numbers_->add(slab.place_count(), positions);
    slab.number_places(first, positions);
  }

  Slab_stream<Point> stream_;
  const double reach_;
  const Place end_;
  Place_numbers* const numbers_;
  std::unique_ptr<Ready> first_; // of a list: strips stay where they are while others come and go
  std::unique_ptr<Ready> spare_; // at most one, whose memory is used again
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_WINDOW_H
