// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MEETING_FEATURES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MEETING_FEATURES_H

// Where the box of a feature in space meets that of another one. Elsewhere, its faces are in no
// pair, and need not be read.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_boxes.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <cstddef>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The features, as the box route reads them. `Test` is like Pieces_intersect.
template <class Test>
class Meeting_features : public Objects_in_boxes
{
public:
  static constexpr int static_dimension = 3;

  Meeting_features(const Feature_boxes& boxes, const Test& test, const Threads& threads)
    : boxes_(boxes), test_(test), are_threads_many_(threads.are_many()), common_(boxes.size())
  {
    for(std::size_t position = 0; position < boxes.size(); ++position)
      if(!boxes.is_finite(position))
        common_[position].extend(box_at(position));
  }

  // Finds where the boxes of features meet those of others.
  template <class Sets>
  void search(const Sets& sets, const Threads& threads)
  {
    Unwatched_progress progress;
    const auto stop = [](std::size_t, std::size_t) { return false; };
    if(!report_meeting_boxes(*this, sets, stop, progress, threads))
      for(std::size_t position = 0; position < boxes_.size(); ++position)
        common_[position].extend(box_at(position));
  }

  // ---- where pieces are taken, as in Everywhere -------------------------------------------------

  static constexpr bool takes_all = false;

  bool takes(std::size_t feature) const
  {
    return common_[feature].low[0] <= common_[feature].high[0];
  }

  template <class Point>
  bool takes_face(std::size_t feature, const Point& p, const Point& q, const Point& r) const
  {
    Box_of_numbers box;
    for(const Point* vertex : {&p, &q, &r})
      box.add(*vertex);
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Interval interval
        = grown(boxes_.thickened(feature, {box.low[axis], box.high[axis]}));
      if(interval.high < common_[feature].low[axis] || interval.low > common_[feature].high[axis])
        return false;
    }
    return true;
  }

  // What is inside another feature is in the common part of their boxes.
  template <class Face>
  bool is_beyond(std::size_t feature, const Face& face) const
  {
    for(int v = 0; v < 3; ++v)
      for(std::size_t axis = 0; axis < 3; ++axis) {
        const auto x = vertex_bounds(face, v, static_cast<int>(axis));
        if(x.second < common_[feature].low[axis] || x.first > common_[feature].high[axis])
          return true;
      }
    return false;
  }

  // ---- for the box route ------------------------------------------------------------------------

  std::size_t size() const { return boxes_.size(); }
  int dimension() const { return 3; }

  auto intervals(std::size_t position) const
  {
    return [box = box_at(position)](int axis) {
      const auto k = static_cast<std::size_t>(axis);
      return Interval{box.low[k], box.high[k]};
    };
  }

  // Says that a pair is one if there are so many that features may meet others everywhere.
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    Box_of_numbers common = box_at(i);
    common.clip(box_at(j));
    std::unique_lock<std::mutex> lock(mutex_, std::defer_lock);
    if(are_threads_many_)
      lock.lock();
    common_[i].extend(common);
    common_[j].extend(common);
    return ++pair_count_ > most_pairs_each * boxes_.size();
  }

private:
  static constexpr std::size_t most_pairs_each = 64;

  Interval grown(const Interval& interval) const
  {
    const auto ends = finite_interval({interval.low, interval.high});
    return test_.grown({ends.first, ends.second});
  }

  Box_of_numbers box_at(std::size_t position) const
  {
    Box_of_numbers box;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Interval interval = grown(boxes_.interval(position, static_cast<int>(axis)));
      box.low[axis] = interval.low;
      box.high[axis] = interval.high;
    }
    return box;
  }

  const Feature_boxes& boxes_;
  const Test& test_;
  const bool are_threads_many_;
  mutable std::mutex mutex_;
  mutable std::vector<Box_of_numbers> common_; // encloses where a feature may meet others
  mutable std::size_t pair_count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MEETING_FEATURES_H
