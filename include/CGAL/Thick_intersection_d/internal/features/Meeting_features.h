// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MEETING_FEATURES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MEETING_FEATURES_H

// Which features in space have a box that meets that of another one. The others are in no pair, and
// their pieces need not be read. A box takes less time than pieces: it reads points alone.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/mesh_faces.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The boxes of features. Throws if a face is no triangle.
class Feature_boxes
{
public:
  template <class Elements>
  void add_features(const Elements& features)
  {
    for(std::size_t position = 0; position < features.size(); ++position) {
      boxes_.emplace_back();
      add_parts(features[position], *this);
    }
  }

  std::size_t size() const { return boxes_.size(); }

  // That of a feature without points is a point.
  Interval interval(std::size_t position, int axis) const
  {
    const Box& box = boxes_[position];
    const auto k = static_cast<std::size_t>(axis);
    if(box.low[k] > box.high[k])
      return {0, 0};
    const auto ends = thickened_interval({box.low[k], box.high[k]}, box.radius);
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
    Box box = boxes_.back();
    for_each_point(mesh, [&](const auto& point) { box.add(point); });
    boxes_.back() = box;
    for_each_face(mesh, boxes_.size() - 1, [](const auto&, const auto&, const auto&) {});
  }

  // All points of a feature count as those with the largest radius. What is no radius makes a
  // feature one that has to be checked.
  template <class NT>
  void begin_thick(const NT& radius)
  {
    const double length = bounds(radius).second;
    boxes_.back().is_finite &= length >= 0 && length <= largest;
    boxes_.back().radius = (std::max)(boxes_.back().radius, length);
  }
  void end_thick() {}

private:
  static constexpr double largest = (std::numeric_limits<double>::max)();

  struct Box
  {
    std::array<double, 3> low = {largest, largest, largest};
    std::array<double, 3> high = {-largest, -largest, -largest};
    double radius = 0;
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
  };

  std::vector<Box> boxes_;
};

// The features, as the box route reads them. `Test` is like Pieces_intersect.
template <class Test>
class Meeting_features : public Objects_in_boxes
{
public:
  static constexpr int static_dimension = 3;

  Meeting_features(const Feature_boxes& boxes, const Test& test)
    : boxes_(boxes), test_(test), do_meet_(boxes.size())
  {
    for(std::size_t position = 0; position < boxes.size(); ++position)
      do_meet_[position] = !boxes.is_finite(position);
  }

  // Finds the features whose boxes meet those of others.
  template <class Sets>
  void search(const Sets& sets, const Threads& threads)
  {
    Unwatched_progress progress;
    const auto stop = [](std::size_t, std::size_t) { return false; };
    if(!report_meeting_boxes(*this, sets, stop, progress, threads))
      std::fill(do_meet_.begin(), do_meet_.end(), true);
  }

  bool has_met(std::size_t position) const { return do_meet_[position]; }

  std::size_t size() const { return boxes_.size(); }
  int dimension() const { return 3; }

  auto intervals(std::size_t position) const
  {
    return [this, position](int axis) {
      const Interval interval = boxes_.interval(position, axis);
      const auto ends = finite_interval({interval.low, interval.high});
      return test_.grown({ends.first, ends.second});
    };
  }

  // Says that a pair is one if there are so many that all features may meet others.
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    do_meet_[i].store(true, std::memory_order_relaxed);
    do_meet_[j].store(true, std::memory_order_relaxed);
    return pairs_.fetch_add(1, std::memory_order_relaxed) > 64 * boxes_.size();
  }

private:
  const Feature_boxes& boxes_;
  const Test& test_;
  mutable std::vector<std::atomic<bool>> do_meet_;
  mutable std::atomic<std::size_t> pairs_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MEETING_FEATURES_H
