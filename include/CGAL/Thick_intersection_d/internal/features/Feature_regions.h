// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_REGIONS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_REGIONS_H

// Where the box of a feature in space meets those of others. Elsewhere, its faces are in no pair,
// and need not be read. To make a box takes less time: it reads points alone.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/mesh_faces.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The features, as the box route reads them: it tells which boxes meet, and no pair is one.
class Feature_regions : public Objects_in_boxes<3>
{
public:
  // Throws if a coordinate is NaN or infinite, if a radius is none, or if a face is no triangle.
  // `test` is like Pieces_intersect.
  template <class Features, class Test>
  Feature_regions(const Features& features, const Test& test, const Threads& threads)
    : are_threads_many_(threads.are_many()), regions_(features.size())
  {
    boxes_.reserve(features.size());
    for(std::size_t position = 0; position < features.size(); ++position) {
      if constexpr(std::is_lvalue_reference_v<decltype(features[position])>) // others are made
        if(position + 2 < features.size())
          prefetch_points(features[position + 2]);
      box_ = Space_box();
      radius_ = 0;
      point_count_ = 0;
      add_parts(features[position], *this);
      point_counts_.push_back(point_count_);
      for(Interval& interval : box_)
        interval = searched_interval(interval.low > interval.high ? Interval{0, 0} : interval,
                                     radius_, test); // without points, any interval does
      boxes_.push_back(box_);
    }
  }

  const Space_box& box(std::size_t position) const { return boxes_[position]; }

  // Where a feature may meet others. It is empty if there is no such place.
  const Space_box& region(std::size_t position) const { return regions_[position]; }

  // How many points a feature has.
  std::size_t point_count(std::size_t position) const { return point_counts_[position]; }

  // ---- for the box route ------------------------------------------------------------------------

  std::size_t size() const { return boxes_.size(); }

  auto intervals(std::size_t position) const
  {
    return [&box = boxes_[position]](int axis) { return box[static_cast<std::size_t>(axis)]; };
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    const Space_box common = common_part(boxes_[i], boxes_[j]);
    std::unique_lock<std::mutex> lock(mutex_, std::defer_lock);
    if(are_threads_many_)
      lock.lock();
    regions_[i].add_box(common);
    regions_[j].add_box(common);
    return false;
  }

  // ---- for add_parts() --------------------------------------------------------------------------

  template <class Iterator, class Sentinel>
  void add_polyline(Iterator point, Sentinel last)
  {
    for(; point != last; ++point) {
      check_vertex(*point, boxes_.size());
      box_.add_point(*point);
      ++point_count_;
    }
  }

  // Points of no face may be anything.
  template <class Mesh>
  void add_mesh(const Mesh& mesh)
  {
    Space_box box = box_; // in registers
    bool are_finite = true;
    for_each_point(mesh, [&](const auto& point) {
      are_finite &= box.add_point(point);
      ++point_count_;
    });
    box_ = box;
    if(!are_finite || !is_closed_by_count(mesh))
      check_faces(mesh, boxes_.size());
  }

  template <class NT>
  void begin_thick(const NT& radius)
  {
    check_feature_radius(radius, boxes_.size());
    radius_ = (std::max)(radius_, bounds(radius).second);
  }
  void end_thick() {}

private:
  const bool are_threads_many_;
  mutable std::mutex mutex_;
  std::vector<Space_box> boxes_;
  mutable std::vector<Space_box> regions_;
  std::vector<std::size_t> point_counts_;

  // Of the feature that is read.
  Space_box box_;
  double radius_;
  std::size_t point_count_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_REGIONS_H
