// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_NEAR_OBJECT_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_NEAR_OBJECT_BOXES_H

// Points in any dimension, or objects, as the box route reads them. The intervals of two of them
// are within the reach along an axis iff they meet when each is longer by the reach.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Test` tells the dimension and the reach, the interval of an object along an axis, and whether
// two objects are near.
template <int Dimension, class Elements, class Test>
class Near_object_boxes : public Objects_in_boxes
{
public:
  static constexpr int static_dimension = Dimension;

  Near_object_boxes(const Elements& objects, const Test& test) : objects_(objects), test_(test) {}

  std::size_t size() const { return objects_.size(); }
  int dimension() const { return test_.dimension(); }

  auto intervals(std::size_t position) const
  {
    return [this, position](int axis) {
      return around(test_.interval(objects_[position], axis));
    };
  }

  // How much longer boxes are than objects, and the interval of an object, or of a part of it.
  double reach() const { return test_.reach(); }
  Interval with_reach(const Interval& interval) const { return longer(interval, test_.reach()); }

  void prefetch(std::size_t position) const { prefetch_object(objects_, position); }
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    return test_(objects_[i], objects_[j]);
  }

private:
  Interval around(const std::pair<double, double>& interval) const
  {
    return with_reach({interval.first, interval.second});
  }

  const Elements& objects_;
  const Test& test_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_NEAR_OBJECT_BOXES_H
