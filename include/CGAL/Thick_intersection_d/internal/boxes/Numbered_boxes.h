// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_NUMBERED_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_NUMBERED_BOXES_H

// The boxes of one or two ranges of the user, read through box traits and checked once. The default
// traits read a box by its member functions.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

// The boxes of CGAL know their dimension as an argument of the template of their base class. Their
// function dimension() is no constant expression. Their header is under the GPL, so it is not
// included.
namespace Box_intersection_d {
struct ID_NONE;
template <class NT, int Dimension, class IdPolicy>
class Box_d;
} // namespace Box_intersection_d

namespace Thick_intersection_d {
namespace internal {

template <class Handle, class = void>
struct Is_box : std::false_type {};
template <class Handle>
struct Is_box<Handle, std::void_t<decltype(std::declval<const Handle&>().min_coord(0))>>
  : std::true_type {};

// Returns the box itself, or the box that a pointer points to.
template <class Handle>
decltype(auto) as_box(const Handle& handle)
{
  if constexpr(Is_box<Handle>::value)
    return (handle);
  else
    return (*handle);
}

template <class Box, class NT, int Dimension,
          class Base = Box_intersection_d::Box_d<NT, Dimension, Box_intersection_d::ID_NONE>>
std::integral_constant<int, (&Box::dimension == &Base::dimension) ? Dimension : 0>
dimension_by_base(const Box_intersection_d::Box_d<NT, Dimension, Box_intersection_d::ID_NONE>*);

// The dimension of boxes that are derived from those of CGAL. It is 0 for others, and for boxes
// with a function dimension() of their own.
template <class Box, class = void>
struct Inherited_dimension : std::integral_constant<int, 0> {};
template <class Box>
struct Inherited_dimension<
  Box, std::void_t<decltype(dimension_by_base<Box>(std::declval<const Box*>()))>>
  : decltype(dimension_by_base<Box>(std::declval<const Box*>())) {};

// `BoxHandle` knows the dimension. The boxes of a second range may have another type.
template <class BoxHandle>
class Box_members
{
  using Box = std::decay_t<decltype(as_box(std::declval<const BoxHandle&>()))>;

public:
  // A constant expression if that of the box is one, or if the box is one of CGAL.
  static constexpr int dimension()
  {
    if constexpr(Inherited_dimension<Box>::value != 0)
      return Inherited_dimension<Box>::value;
    else
      return Box::dimension();
  }

  template <class Handle>
  static decltype(auto) min_coord(const Handle& handle, int axis)
  {
    return as_box(handle).min_coord(axis);
  }
  template <class Handle>
  static decltype(auto) max_coord(const Handle& handle, int axis)
  {
    return as_box(handle).max_coord(axis);
  }

  // Exists if the box has an id.
  template <class Handle>
  static auto id(const Handle& handle) -> decltype(as_box(handle).id())
  {
    return as_box(handle).id();
  }
};

// Whether box traits have ids.
template <class Traits, class A, class = void>
struct Has_id : std::false_type {};
template <class Traits, class A>
struct Has_id<Traits, A,
              std::void_t<decltype(std::declval<const Traits&>().id(std::declval<A>()))>>
  : std::true_type {};

// Numbers the boxes from 0, those of the first range first. An empty box has no number: its lower
// end is above its upper end along an axis, so it meets no box. The number of a box is its position
// if no box is empty. The boxes of the two ranges may have different types.
template <class First, class Second, class Traits>
class Numbered_boxes
{
public:
  // Throws if a coordinate is NaN.
  Numbered_boxes(const First& first, const Second& second, const Traits& traits)
    : first_(first), second_(second), traits_(traits), dimension_(traits.dimension()),
      size_(first.size() + second.size()), first_size_(first.size())
  {
    if(dimension_ < 1)
      throw std::invalid_argument("The dimension of boxes must be 1 or more.");
    if constexpr(Has_id<Traits, decltype(std::declval<const First&>()[0])>::value)
      have_distinct_ids_ = do_ids_ascend();
    number_boxes();
  }

  std::size_t size() const { return size_; }
  std::size_t first_size() const { return first_size_; }
  int dimension() const { return dimension_; }
  const Traits& traits() const { return traits_; }

  // Whether all ends are doubles.
  bool have_double_ends() const { return have_double_ends_; }

  // Whether a box is a single number along an axis.
  bool has_degenerate_box() const { return has_degenerate_box_; }

  // Whether the ids show at once that no two boxes have the same one, as those of boxes that lie in
  // the order in which they were made.
  bool have_distinct_ids() const { return have_distinct_ids_; }

  // Returns doubles that enclose the box.
  Interval interval(std::size_t number, int axis) const
  {
    return with_box(number, [&](auto&& box) {
      return Interval{bounds(traits_.min_coord(box, axis)).first,
                      bounds(traits_.max_coord(box, axis)).second};
    });
  }

  // Returns the boxes as the iterators of the user give them.
  decltype(auto) of_first_range(std::size_t number) const { return first_[position(number)]; }
  decltype(auto) of_second_range(std::size_t number) const
  {
    return second_[position(number) - first_.size()];
  }

  // Returns task(box).
  template <class Task>
  auto with_box(std::size_t number, const Task& task) const
  {
    return at(position(number), task);
  }

  // Returns the position in the range of the box.
  std::size_t position_in_range(std::size_t number) const
  {
    return number < first_size_ ? position(number) : position(number) - first_.size();
  }

private:
  std::size_t position(std::size_t number) const
  {
    return positions_.empty() ? number : positions_[number];
  }

  template <class Task>
  auto at(std::size_t position, const Task& task) const
  {
    return position < first_.size() ? task(first_[position])
                                    : task(second_[position - first_.size()]);
  }

  void number_boxes()
  {
    bool has_empty_box = false;
    for(std::size_t position = 0; position < size_; ++position) {
      const bool is_empty = check(position);
      if(is_empty && !has_empty_box) {
        has_empty_box = true;
        positions_.resize(position);
        std::iota(positions_.begin(), positions_.end(), std::size_t(0));
      }
      if(!is_empty && has_empty_box)
        positions_.push_back(position);
    }
    if(has_empty_box) {
      size_ = positions_.size();
      first_size_ = static_cast<std::size_t>(
        std::lower_bound(positions_.begin(), positions_.end(), first_.size()) - positions_.begin());
    }
  }

  // Whether ids ascend from each box to the next one, and from the last box to the first one, but
  // for a single time.
  bool do_ids_ascend() const
  {
    const auto id_at = [&](std::size_t position) {
      return at(position, [&](auto&& box) { return traits_.id(box); });
    };
    if(size_ == 0)
      return true;
    auto last = id_at(size_ - 1);
    int descents = 0;
    for(std::size_t position = 0; position < size_ && descents <= 1; ++position) {
      const auto id = id_at(position);
      descents += !(last < id);
      last = id;
    }
    return descents <= 1;
  }

  // Looks at a box. Returns whether it is empty.
  bool check(std::size_t position)
  {
    return at(position, [&](auto&& box) {
      bool is_empty = false;
      for(int axis = 0; axis < dimension_; ++axis) {
        const auto& low = traits_.min_coord(box, axis);
        const auto& high = traits_.max_coord(box, axis);
        check_end(bounds(low), axis, position);
        check_end(bounds(high), axis, position);
        if(high < low)
          is_empty = true;
        else
          has_degenerate_box_ = has_degenerate_box_ || !(low < high);
      }
      return is_empty;
    });
  }

  // Appends the parts of the text, as coordinates.h does.
  [[noreturn]] static void throw_nan(int axis, std::size_t position)
  {
    std::string message("Coordinate ");
    message.append(std::to_string(std::size_t(axis))).append(" of box ");
    message.append(std::to_string(position)).append(" is NaN.");
    throw std::invalid_argument(message);
  }

  void check_end(const std::pair<double, double>& end, int axis, std::size_t position)
  {
    if(!(end.first <= end.second))
      throw_nan(axis, position);
    have_double_ends_ = have_double_ends_ && end.first == end.second;
  }

  const First& first_;
  const Second& second_;
  const Traits& traits_;
  int dimension_;
  std::size_t size_;
  std::size_t first_size_; // the boxes of the first range that have a number
  bool have_double_ends_ = true;
  bool has_degenerate_box_ = false;
  bool have_distinct_ids_ = false;
  std::vector<std::size_t> positions_; // without empty boxes; no positions if no box is empty
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_NUMBERED_BOXES_H
