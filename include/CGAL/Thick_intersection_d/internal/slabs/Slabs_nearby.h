// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_NEARBY_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_NEARBY_H

// A list of slabs that are ready, and a part of it. Lists and vectors of the standard library, too,
// are compiled for each kind of points, but take longer.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLABS_NEARBY_H
