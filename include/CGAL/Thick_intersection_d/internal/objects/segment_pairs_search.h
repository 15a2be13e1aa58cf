// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_SEGMENT_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_SEGMENT_PAIRS_SEARCH_H

// The search of two sets of objects, some of which may be segments: long ones are cut where that is
// expected to be faster.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Stretches.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/objects/Stretched_objects.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether objects of a kind are segments, thickened or not.
template <class Kind>
struct Is_segment : std::bool_constant<Vertex_count<Hull_points_t<Kind>>::value == 2> {};

// Whether objects of the first set, and of the second one, may be segments.
template <class Object>
struct Has_segments
{
  static constexpr bool in_first = Kinds<Object>::template is_any<Is_segment>;
  static constexpr bool in_second = in_first;
  static constexpr bool value = in_first;
};
template <class A, class B>
struct Has_segments<One_of_two<A, B>>
{
  static constexpr bool in_first = Has_segments<std::decay_t<A>>::value;
  static constexpr bool in_second = Has_segments<std::decay_t<B>>::value;
  static constexpr bool value = in_first || in_second;
};

// `Objects` are Objects_in_boxes, and have the boxes of `Elements`, or boxes that are longer by a
// reach.
template <class Objects, class Elements>
class Segments_and_others
{
  using Box = Interval_box<Objects::static_dimension>;

public:
  using Object = typename Elements::value_type;
  static constexpr int dimension = Objects::static_dimension;

  Segments_and_others(const Objects& objects, const Elements& elements)
    : objects_(objects), elements_(elements)
  {}

  std::size_t size() const { return objects_.size(); }
  auto intervals(std::size_t position) const { return objects_.intervals(position); }
  double reach() const { return objects_.reach(); }

  bool is_segment(std::size_t position) const
  {
    return with_kind(elements_[position], [](const auto& kind) {
      return Is_segment<std::decay_t<decltype(kind)>>::value;
    });
  }

  Box box(const Stretch& stretch) const
  {
    Box box;
    if(stretch.count == 1) {
      const auto intervals = objects_.intervals(stretch.object);
      for(int axis = 0; axis < dimension; ++axis)
        box[axis] = intervals(axis);
    }
    else
      with_kind(elements_[stretch.object], [&](const auto& kind) {
        if constexpr(Is_segment<std::decay_t<decltype(kind)>>::value)
          for(int axis = 0; axis < dimension; ++axis)
            box[axis] = objects_.with_reach(interval_along(kind, axis, stretch));
      });
    return box;
  }

  void prefetch(std::size_t position) const { objects_.prefetch(position); }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    return objects_.do_intersect(i, j);
  }

private:
  template <class Kind>
  static Interval interval_along(const Kind& kind, int axis, const Stretch& stretch)
  {
    const auto& segment = hull_points(kind);
    const Interval thin = interval_of_stretch(end_of(segment, 0, axis), end_of(segment, 1, axis),
                                              stretch.index, stretch.count);
    if constexpr(!Is_thickened<Kind>::value)
      return thin;
    else {
      const auto thick = finite_interval(thickened_interval({thin.low, thin.high}, kind.second));
      return {thick.first, thick.second};
    }
  }

  template <class Segment>
  static Interval end_of(const Segment& segment, int end, int axis)
  {
    const std::pair<double, double> bounds = finite_interval(vertex_bounds(segment, end, axis));
    return {bounds.first, bounds.second};
  }

  const Objects& objects_;
  const Elements& elements_;
};

// How to cut the objects of one set.
struct Stretch_counts
{
  std::size_t first = 0;     // the position of the first object of the set
  std::vector<Place> counts; // of the stretches of each
  std::size_t added = 0;     // how many more stretches than objects there are
};

// Returns how to cut the objects at the positions [first, last), which are searched together with
// those at [others_first, others_last). The more memory all stretches would take, the more each of
// them costs.
template <class Segments>
Stretch_counts count_stretches(const Segments& segments, std::size_t first, std::size_t last,
                               std::size_t others_first, std::size_t others_last,
                               const Threads& threads)
{
  constexpr std::size_t most_added = 8; // for each object
  Stretch_counts stretches{first, std::vector<Place>(last - first, 1), 0};
  const Stretch_planner<Segments::dimension> planner(segments, others_first, others_last);
  double cost = 2; // of a stretch, in that of a pair of boxes that meet
  do {
    threads.run_blocks(last - first, [&](std::size_t i, std::size_t end) {
      for(; i != end; ++i)
        if(segments.is_segment(first + i))
          stretches.counts[i] = planner.best_count(segments.box({first + i, 0, 1}), cost);
    });
    stretches.added = std::accumulate(stretches.counts.begin(), stretches.counts.end(),
                                      std::size_t(0)) - stretches.counts.size();
    cost *= 2;
  } while(stretches.added > most_added * segments.size());
  return stretches;
}

// Returns the counts of the set that gains more.
template <class Segments>
Stretch_counts plan_stretches(const Segments& segments, const Two_sets& sets,
                              const Threads& threads)
{
  const std::size_t middle = sets.first_size, last = segments.size();
  if(middle == 0 || middle == last)
    return {};
  Stretch_counts first, second;
  if constexpr(Has_segments<typename Segments::Object>::in_first)
    first = count_stretches(segments, 0, middle, middle, last, threads);
  if constexpr(Has_segments<typename Segments::Object>::in_second)
    second = count_stretches(segments, middle, last, 0, middle, threads);
  return second.added > first.added ? second : first;
}

// Reports the pairs of two sets of objects.
template <class Objects, class Elements, class Callback, class Progress>
bool report_segment_pairs(const Objects& objects, const Elements& elements, const Two_sets& sets,
                          Callback& callback, Progress& progress, const Threads& threads)
{
  if(!fits_box_route(objects.size()))
    throw_too_many_objects(objects.size());
  const Segments_and_others<Objects, Elements> segments(objects, elements);
  const Stretch_counts stretches = plan_stretches(segments, sets, threads);
  if(stretches.added == 0 || !fits_box_route(segments.size() + stretches.added))
    return report_meeting_boxes(objects, sets, callback, progress, threads);
  const Stretched_objects stretched(segments, sets, stretches.first, stretches.counts);
  const auto take = [&](std::size_t i, std::size_t j) {
    const auto pair = stretched.objects_of(i, j);
    return goes_on_after(callback, pair.first, pair.second);
  };
  progress.restart(stretched.size());
  return report_meeting_boxes(stretched, stretched.sets(), take, progress, threads);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_SEGMENT_PAIRS_SEARCH_H
