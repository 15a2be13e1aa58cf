// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXED_OBJECTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXED_OBJECTS_H

// Objects with boxes, and the callback and progress of the user, as the search by boxes reads, asks
// and calls them.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_client.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// What most objects do not say otherwise. Derived classes have besides:
//
//   size()
//   intervals(position)  a functor: of an axis, gives the closed interval of doubles that encloses
//                        the object along it
//   do_intersect(i, j)   asked about pairs whose boxes meet, and that are wanted
//
// `Dimension` is 0 if it is known at run time only. Then they have dimension() as well.
template <int Dimension>
struct Objects_in_boxes
{
  static constexpr int static_dimension = Dimension;
  int dimension() const { return Dimension; }

  // Decides about most pairs by their boxes, as Ball_box_filter does; or void.
  using Box_filter = void;

  // Whether objects may have groups, as Box_client says. Then they are not exact, and have no
  // filter, and have_groups() says whether they have.
  static constexpr bool may_have_groups = false;

  bool have_groups() const { return true; }
  std::size_t group_of(std::size_t) const { return 0; }
  bool is_wanted(std::size_t, std::size_t) const { return true; }

  // Whether two objects intersect iff their intervals meet along all axes.
  bool are_exact() const { return false; }

  // May prefetch what do_intersect() will read. Not called if there is a filter.
  void prefetch(std::size_t) const {}
};

// Boxes have `Axes` of the axes of objects. If there are more axes, the intervals along the others
// are read when a pair has met along those of the boxes.
template <int Axes, class Objects, class Callback, class Progress>
class Boxed_objects final : public Box_client<Axes>
{
  using Box = Piece_box<Axes>;
  using Run = Box_run<Axes>;
  using Box_filter = typename Objects::Box_filter;

public:
  // The axes are distinct; those of boxes come first.
  Boxed_objects(const Objects& objects, std::vector<int> axes, Callback& callback,
                Progress& progress)
    : objects_(objects), axes_(std::move(axes)), are_exact_(objects.are_exact()),
      callback_(callback), progress_(progress)
  {
    this->size = objects.size();
    this->are_decided = are_exact_ && dimension() <= Axes;
    this->have_groups = Objects::may_have_groups && objects.have_groups();
  }

  // Makes the objects two sets, of which the first has so many.
  void divide(std::size_t size_of_first)
  {
    this->first_size = static_cast<Place>(size_of_first);
    first_of_second_ = size_of_first;
  }

  // Boxes of fewer dimensions are [0, 0] along the other axes.
  void read(std::size_t first, std::size_t last, Box* boxes) const override
  {
    for(std::size_t position = first; position != last; ++position, ++boxes) {
      const auto intervals = objects_.intervals(position);
      for(int axis = 0; axis < Axes; ++axis) {
        const Interval interval = axis < dimension() ? intervals(axes_[axis]) : Interval{0, 0};
        boxes->low[axis] = interval.low;
        boxes->high[axis] = interval.high;
      }
      boxes->position = static_cast<Place>(position);
      boxes->sides = 0;
    }
  }

  // The loop that calls the user stores nothing. This makes short callbacks fast.
  bool take(const Run& a, const Run& b, Found_pair* pairs, Place count,
            std::uint64_t& wanted_count) override
  {
    if(!this->are_decided)
      count = remove_others(a, b, pairs, count, wanted_count);
    const Place* const p = a.positions;
    const Place* const q = b.positions;
    const std::size_t second = first_of_second_;
    for(const Found_pair* const end = pairs + count; pairs != end; ++pairs)
      if(!report(p[pairs->i], q[pairs->j], second))
        return false;
    return true;
  }

  bool take_row(Place i, const Place* others) override
  {
    const std::size_t second = first_of_second_;
    for(Place lane = 0; lane < lanes; ++lane)
      if(!report(i, others[lane], second))
        return false;
    return true;
  }

  bool take_pair(Place i, Place j) override
  {
    return !objects_.is_wanted(i, j) || !do_intersect(i, j)
           || report(i, j, first_of_second_);
  }

  std::size_t group_of(Place position) const override { return objects_.group_of(position); }

  bool is_wanted(Place i, Place j) const override { return objects_.is_wanted(i, j); }

  bool advance(std::size_t finished) override { return progress_.advance(finished); }

private:
  int dimension() const { return static_cast<int>(axes_.size()); }

  // Moves the pairs of objects that intersect to the front. Returns their number.
  Place remove_others(const Run& a, const Run& b, Found_pair* pairs, Place count,
                      std::uint64_t& wanted_count) const
  {
    Place pair_count = 0;
    for(Place c = 0; c < count; ++c) {
      if constexpr(std::is_void_v<Box_filter>)
        if(c + prefetch_distance < count) {
          objects_.prefetch(a.positions[pairs[c + prefetch_distance].i]);
          objects_.prefetch(b.positions[pairs[c + prefetch_distance].j]);
        }
      pairs[pair_count] = pairs[c];
      pair_count += is_pair(a, b, pairs[c], wanted_count);
    }
    return pair_count;
  }

  bool is_pair(const Run& a, const Run& b, Found_pair pair,
               [[maybe_unused]] std::uint64_t& wanted_count) const
  {
    const Place i = a.positions[pair.i], j = b.positions[pair.j];
    if constexpr(Objects::may_have_groups) {
      if(!objects_.is_wanted(i, j))
        return false;
      ++wanted_count;
    }
    if constexpr(!std::is_void_v<Box_filter>)
      if(dimension() == Axes) {
        const Uncertain<bool> answer
          = Box_filter::do_intersect(box_at(a, pair.i), box_at(b, pair.j));
        if(is_certain(answer))
          return get_certain(answer);
      }
    return do_intersect(i, j);
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

  // Calls the user with the smaller position first, and the other one less the first position of
  // its set.
  bool report(Place i, Place j, std::size_t first_of_second)
  {
    const Place swapped = (i ^ j) & (Place(0) - static_cast<Place>(j < i)); // no branch
    return goes_on_after(callback_, std::size_t(i ^ swapped),
                         std::size_t(j ^ swapped) - first_of_second);
  }

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
  Callback& callback_;
  Progress& progress_;
  std::size_t first_of_second_ = 0;
};

// Points in any dimension, or objects, as the box route reads them. The intervals of two of them
// are within the reach along an axis iff they meet when each is longer by the reach.
//
// `Test` tells the dimension and the reach, the interval of an object along an axis, and whether
// two objects are near.
template <int Dimension, class Elements, class Test>
class Near_object_boxes : public Objects_in_boxes<Dimension>
{
public:
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

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXED_OBJECTS_H
