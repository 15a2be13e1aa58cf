// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_ASKED_FEATURES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_ASKED_FEATURES_H

// Features that have a vertex of another one in their box, as Feature_insides finds them. The trees
// of their faces are worth making.

#include <CGAL/Bbox_3.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Everywhere.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_boxes.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Asked_features : public Everywhere
{
public:
  struct Filled
  {
    Place feature;
  };

  explicit Asked_features(const Feature_boxes& boxes) : boxes_(boxes), are_asked_(boxes.size()) {}

  static Filled filled(std::size_t position) { return {static_cast<Place>(position)}; }
  Bbox_3 box_of_filled(std::size_t position) const
  {
    return box_of_intervals<Bbox_3>([&](int axis) {
      const Interval interval = boxes_.interval(position, axis);
      return finite_interval({interval.low, interval.high});
    });
  }

  std::size_t filled_count() const { return boxes_.size(); }

  // Remembers that the question was asked.
  template <class Object>
  bool is_inside(const Object&, std::size_t position) const
  {
    are_asked_[position].store(true, std::memory_order_relaxed);
    return false;
  }

  bool takes(std::size_t feature) const { return are_asked_[feature]; }

private:
  const Feature_boxes& boxes_;
  mutable std::vector<std::atomic<bool>> are_asked_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_ASKED_FEATURES_H
