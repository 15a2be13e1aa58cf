// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_BOXES_H

// The boxes of whole features in space. To make one takes less time than to read faces: it reads
// points alone.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/mesh_faces.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Box_of_numbers
{
  static constexpr double largest = (std::numeric_limits<double>::max)();

  std::array<double, 3> low = {largest, largest, largest};
  std::array<double, 3> high = {-largest, -largest, -largest};
  bool is_finite = true;

  template <class Point>
  void add(const Point& point)
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const auto x = coordinate_bounds(point, static_cast<int>(axis));
      is_finite = is_finite && are_bounds_of_finite(x);
      low[axis] = (std::min)(low[axis], x.first);
      high[axis] = (std::max)(high[axis], x.second);
    }
  }

  void extend(const Box_of_numbers& other)
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = (std::min)(low[axis], other.low[axis]);
      high[axis] = (std::max)(high[axis], other.high[axis]);
    }
  }

  void clip(const Box_of_numbers& other)
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = (std::max)(low[axis], other.low[axis]);
      high[axis] = (std::min)(high[axis], other.high[axis]);
    }
  }
};

// The boxes of features. Throws if a face is no triangle.
class Feature_boxes
{
public:
  template <class Elements>
  void add_features(const Elements& features)
  {
    for(std::size_t position = 0; position < features.size(); ++position) {
      boxes_.emplace_back();
      radii_.push_back(0);
      add_parts(features[position], *this);
    }
  }

  std::size_t size() const { return boxes_.size(); }

  // That of a feature without points is a point.
  Interval interval(std::size_t position, int axis) const
  {
    const Box_of_numbers& box = boxes_[position];
    const auto k = static_cast<std::size_t>(axis);
    if(box.low[k] > box.high[k])
      return {0, 0};
    return thickened(position, {box.low[k], box.high[k]});
  }

  // The interval of a part of a feature, thickened by the largest radius of the feature.
  Interval thickened(std::size_t position, const Interval& interval) const
  {
    if(radii_[position] == 0)
      return interval;
    const auto ends = thickened_interval({interval.low, interval.high}, radii_[position]);
    return {ends.first, ends.second};
  }

  // Whether each number is finite. If not, the pieces of the feature have to be checked.
  bool is_finite(std::size_t position) const { return boxes_[position].is_finite; }

  // ---- for add_parts() --------------------------------------------------------------------------

  template <class Iterator, class Sentinel>
  void add_polyline(Iterator point, Sentinel last)
  {
    for(; point != last; ++point)
      boxes_.back().add(*point);
  }

  template <class Mesh>
  void add_mesh(const Mesh& mesh)
  {
    Box_of_numbers box = boxes_.back();
    for_each_point(mesh, [&](const auto& point) { box.add(point); });
    boxes_.back() = box;
    for_each_face(mesh, boxes_.size() - 1, [](const auto&, const auto&, const auto&) {});
  }

  // What is no radius makes the feature one that has to be checked.
  template <class NT>
  void begin_thick(const NT& radius)
  {
    const double length = bounds(radius).second;
    boxes_.back().is_finite &= length >= 0 && length <= Box_of_numbers::largest;
    radii_.back() = (std::max)(radii_.back(), length);
  }
  void end_thick() {}

private:
  std::vector<Box_of_numbers> boxes_;
  std::vector<double> radii_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_BOXES_H
