// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXED_OBJECTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXED_OBJECTS_H

// Objects with boxes, as the box route sees them: the boxes that it moves into pieces, the lanes
// that find pairs, and the test that decides the found pairs.

#include <CGAL/Uncertain.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/has_groups.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Box_run.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Flush.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/with_lanes.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Objects` has
//
//   size(), dimension()
//   intervals(position)        a functor: of an axis, gives the closed interval of doubles that
//                              encloses the object along it
//   are_exact()                whether two objects intersect iff their intervals meet along all
//                              axes
//   do_intersect(i, j)         asked about pairs whose boxes meet
//   Box_filter                 decides about most of these pairs by their boxes, as Ball_box_filter
//                              does; or void
//   prefetch(i)                 may ask for the memory that do_intersect() will read; not called if
//                              there is a filter
//
// Objects may have groups (has_groups.h). Then they are not exact, they have no filter, and
// do_intersect() is asked about wanted pairs only.
//
// Boxes have `Axes` of the axes. If there are more axes, the intervals along the others are read
// when a pair has met along those of the boxes.
template <int Axes, class Objects>
class Boxed_objects
{
  using Box_filter = typename Objects::Box_filter;

public:
  using Box = Piece_box<Axes>;
  using Run = Box_run<Axes>;
  static constexpr bool has_groups = has_groups_v<Objects>;

  // The axes are distinct; those of boxes come first.
  Boxed_objects(const Objects& objects, std::vector<int> axes)
    : objects_(objects), axes_(std::move(axes)), are_exact_(objects.are_exact())
  {}

  std::size_t size() const { return objects_.size(); }
  int dimension() const { return static_cast<int>(axes_.size()); }

  // Makes the box of an object. Boxes of fewer dimensions are [0, 0] along the other axes.
  void put(std::size_t position, Box& box) const
  {
    const auto intervals = objects_.intervals(position);
    for(int axis = 0; axis < Axes; ++axis) {
      const Interval interval = axis < dimension() ? intervals(axes_[axis]) : Interval{0, 0};
      box.low[axis] = interval.low;
      box.high[axis] = interval.high;
    }
    box.position = static_cast<Place>(position);
    box.sides = 0;
  }

  template <class Function>
  void collect_between(const Run& a, const Run& b, Found_pairs& found, const Function& flush) const
  {
    with_lanes([&](auto set) { set.collect_meeting(a, b, found, Flush(flush)); });
  }

  // Whether lanes tell that boxes meet, but not whether they are a pair.
  bool are_undecided(const Run& a, const Run& b) const
  {
    return !do_lanes_decide() || (a.has_copies && b.has_copies);
  }

  // Whether a pair that is found is one unless it is found in another piece as well.
  bool are_copies(const Run& a, const Run& b) const
  {
    return do_lanes_decide() && a.has_copies && b.has_copies;
  }

  // Whether a pair belongs to this piece: to the one where not both boxes go on beyond the same
  // side.
  static bool is_of_piece(const Run& a, const Run& b, Found_pair pair)
  {
    return (a.sides[pair.i] & b.sides[pair.j]) == 0;
  }

  void prefetch(const Run& a, const Run& b, Found_pair pair) const
  {
    if constexpr(std::is_void_v<Box_filter>) {
      objects_.prefetch(a.positions[pair.i]);
      objects_.prefetch(b.positions[pair.j]);
    }
  }

  std::size_t group_of(Place position) const { return objects_.group_of(position); }

  bool is_wanted([[maybe_unused]] Place i, [[maybe_unused]] Place j) const
  {
    if constexpr(has_groups)
      return objects_.is_wanted(i, j);
    else
      return true;
  }

  bool is_pair(const Run& a, const Run& b, Found_pair pair) const
  {
    if(!is_of_piece(a, b, pair))
      return false;
    if constexpr(!std::is_void_v<Box_filter>)
      if(dimension() == Axes) {
        const Uncertain<bool> answer
          = Box_filter::do_intersect(box_at(a, pair.i), box_at(b, pair.j));
        if(is_certain(answer))
          return get_certain(answer);
      }
    return do_intersect(a.positions[pair.i], b.positions[pair.j]);
  }

  // Whether two objects whose boxes meet intersect.
  bool do_intersect(Place i, Place j) const
  {
    if(!are_exact_)
      return objects_.do_intersect(i, j);
    for(int axis = Axes; axis < dimension(); ++axis)
      if(!do_meet(objects_.intervals(i)(axes_[axis]), objects_.intervals(j)(axes_[axis])))
        return false;
    return true;
  }

private:
  bool do_lanes_decide() const { return are_exact_ && dimension() <= Axes; }

  // The axes are in another order, but in the same one for all boxes.
  static std::array<Interval, Axes> box_at(const Run& run, Place place)
  {
    std::array<Interval, Axes> box;
    for(std::size_t axis = 0; axis < Axes; ++axis)
      box[axis] = {run.low[axis][place], run.high[axis][place]};
    return box;
  }

  const Objects& objects_;
  const std::vector<int> axes_;
  const bool are_exact_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXED_OBJECTS_H
