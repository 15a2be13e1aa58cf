// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_MEETING_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_MEETING_BOXES_H

// Which boxes meet, by the rules of CGAL::box_intersection_d(): closed or half-open boxes, told by
// their ids. Nothing but comparisons of coordinates and of ids decides, so numbers of any type are
// decided exactly.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Numbered_boxes.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Traits, class A, class B>
bool have_same_id([[maybe_unused]] const Traits& traits, A& a, B& b)
{
  if constexpr(Has_id<Traits, A&>::value)
    return traits.id(a) == traits.id(b);
  else
    return false;
}

// `Boxes` are Numbered_boxes. `Dimension` is their dimension, or 0 if it is known at run time only.
template <int Dimension, class Boxes>
class Meeting_boxes : public Objects_in_boxes<Dimension>
{
public:
  Meeting_boxes(const Boxes& boxes, bool are_closed)
    : boxes_(boxes), are_closed_(are_closed),
      are_exact_(boxes.have_double_ends() && (are_closed || !boxes.has_degenerate_box()))
  {}

  std::size_t size() const { return boxes_.size(); }
  int dimension() const { return Dimension != 0 ? Dimension : boxes_.dimension(); }

  // Whether two boxes meet iff their intervals meet along all axes. Otherwise boxes whose intervals
  // meet may be apart. Boxes whose intervals do not meet are apart in either case.
  bool are_exact() const { return are_exact_; }

  // Gives a closed interval of doubles per axis.
  auto intervals(std::size_t i) const
  {
    return [this, i](int axis) {
      const Interval interval = boxes_.interval(i, axis);
      return are_exact_ && !are_closed_ ? half_open(interval) : interval;
    };
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    for(int axis = 0; axis < dimension(); ++axis)
      if(!do_overlap(i, j, axis))
        return false;
    return true;
  }

  // Orders boxes by their lower ends along an axis, and by their ids if these ends are equal.
  bool comes_before(std::size_t i, std::size_t j, int axis) const
  {
    return with_boxes(i, j, [&](auto&& a, auto&& b) {
      const auto& low_a = traits().min_coord(a, axis);
      const auto& low_b = traits().min_coord(b, axis);
      return low_a < low_b || (!(low_b < low_a) && has_lower_id(traits(), a, b, i, j));
    });
  }

  // Whether two boxes are one and the same, by their ids.
  bool are_same(std::size_t i, std::size_t j) const
  {
    return !boxes_.have_distinct_ids()
           && with_boxes(i, j, [&](auto&& a, auto&& b) { return have_same_id(traits(), a, b); });
  }

private:
  const auto& traits() const { return boxes_.traits(); }

  template <class Task>
  bool with_boxes(std::size_t i, std::size_t j, const Task& task) const
  {
    return boxes_.with_box(i, [&](auto&& a) -> bool {
      return boxes_.with_box(j, [&](auto&& b) -> bool { return task(a, b); });
    });
  }

  // Positions take the place of ids that boxes do not have. A box and its copy have the same
  // position in their ranges; then the first range comes first.
  template <class Traits, class A, class B>
  bool has_lower_id(const Traits& traits, A& a, B& b, std::size_t i, std::size_t j) const
  {
    if constexpr(Has_id<Traits, A&>::value)
      return traits.id(a) < traits.id(b);
    else
      return std::pair(boxes_.position_in_range(i), i) < std::pair(boxes_.position_in_range(j), j);
  }

  // A half-open interval [x, x) meets what holds x in its interior. Along the first axis it also
  // meets an interval that begins at x, if that has the lower id. This is what CGAL's search
  // reports.
  bool do_overlap(std::size_t i, std::size_t j, int axis) const
  {
    if(are_closed_)
      return !is_above(i, j, axis) && !is_above(j, i, axis);
    if(axis == 0)
      return comes_before(i, j, 0) ? begins_within(j, i, 0) : begins_within(i, j, 0);
    return begins_within(i, j, axis) && begins_within(j, i, axis);
  }

  bool is_above(std::size_t i, std::size_t j, int axis) const
  {
    return with_boxes(i, j, [&](auto&& a, auto&& b) {
      return traits().max_coord(b, axis) < traits().min_coord(a, axis);
    });
  }

  // Whether box i begins before the upper end of box j.
  bool begins_within(std::size_t i, std::size_t j, int axis) const
  {
    return with_boxes(i, j, [&](auto&& a, auto&& b) {
      return traits().min_coord(a, axis) < traits().max_coord(b, axis);
    });
  }

  const Boxes& boxes_;
  bool are_closed_;
  bool are_exact_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_MEETING_BOXES_H
