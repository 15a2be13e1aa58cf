// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_ELEMENT_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_ELEMENT_POINTS_H

// The points of the user, as the search by slabs reads and asks them.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/Point_doubles.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether elements have numbers that they are reported by, instead of their positions. Then
// place(number) finds the position; that of a position is itself.
template <class Elements, class = void>
inline constexpr bool have_numbers = false;

template <class Elements>
inline constexpr bool have_numbers<Elements, std::void_t<decltype(&Elements::number)>> = true;

// Whether a point of a kernel has its coordinates in itself, as doubles. Those of kernels that
// count references have a pointer to them, and so have points whose type tells no dimension.
template <class Point>
constexpr bool has_doubles_inside()
{
  if constexpr(Is_kernel_point<Point>::value
               && std::is_same_v<decltype(coordinate(std::declval<const Point&>(), 0)),
                                 const double&>)
    return sizeof(Base_kind_t<Point>)
           >= static_cast<std::size_t>(dimension_or<Point>(0)) * sizeof(double);
  else
    return false;
}

// Whether an iterator is known to go through an array of such points.
template <class Iterator, class Point>
inline constexpr bool is_in_array_of_doubles
  = (std::is_pointer_v<Iterator>
     || std::is_same_v<Iterator, typename std::vector<Point>::const_iterator>)
    && has_doubles_inside<Point>();

// Whether elements are one array of points that hold doubles, or two.
template <class Elements>
inline constexpr bool are_array_of_doubles = false;

template <class Range>
inline constexpr bool are_array_of_doubles<Numbered_elements<Range, No_map>>
  = is_in_array_of_doubles<Iterator_of<Read_range<Range>>,
                           typename Numbered_elements<Range, No_map>::value_type>;

template <class First, class Second>
inline constexpr bool are_array_of_doubles<Joined_elements<First, Second>>
  = are_array_of_doubles<First> && are_array_of_doubles<Second>;

// Returns the view of an array of points that hold doubles.
template <int Dimension, class Elements>
Doubles_view<Dimension> view_of(const Elements& points)
{
  Doubles_view<Dimension> view = {};
  if(points.size() != 0)
    for(int axis = 0; axis < Dimension; ++axis) {
      view.x[axis] = reinterpret_cast<const char*>(&coordinate(points[0], axis));
      view.step[axis] = sizeof(points[0]);
    }
  return view;
}

// Returns the view of the columns of doubles that stand for coordinates.
template <int Dimension, class Elements>
Doubles_view<Dimension> view_of_columns(const Doubles<Elements>& doubles)
{
  Doubles_view<Dimension> view = {};
  for(int axis = 0; axis < Dimension; ++axis) {
    const std::pair<const double*, std::ptrdiff_t> column = doubles.column(axis);
    view.x[axis] = reinterpret_cast<const char*>(column.first);
    view.step[axis] = column.second;
  }
  return view;
}

template <int Dimension, class Elements, class Progress>
class Element_points final : public Near_points<Dimension>
{
  using Point = typename Elements::value_type;

  static constexpr bool are_held = is_held_by_double_v<Coordinate_t<Point>>;

public:
  // For a search that decides no near tie, and reads each point a few times.
  Element_points(const Elements& points, Progress& progress) : points_(points), progress_(progress)
  {
    this->size = points.size();
    this->are_numbered = internal::have_numbers<Elements>;
    if constexpr(are_array_of_doubles<Elements>) {
      this->are_viewed = true;
      this->first_size = points.first().size();
      this->views[0] = view_of<Dimension>(points.first());
      this->views[1] = view_of<Dimension>(points.second());
    }
  }

  Element_points(const Elements& points, const Doubles<Elements>& doubles,
                 const Is_within_distance<Point>& is_within, Progress& progress)
    : Element_points(points, progress)
  {
    is_within_ = &is_within;
    if constexpr(!are_held) {
      this->are_viewed = true;
      this->first_size = points.size();
      this->views[0] = view_of_columns<Dimension>(doubles);
    }
  }

  void read([[maybe_unused]] std::size_t first, [[maybe_unused]] std::size_t count,
            [[maybe_unused]] int axis, [[maybe_unused]] double* x) const override
  {
    if constexpr(!are_array_of_doubles<Elements>) {
      if(axis == Near_points<Dimension>::all_axes)
        for_each_below(count, [&](std::size_t i) {
          read_point(points_[first + i], x + i * Dimension);
        });
      else
        for_each_below(count, [&](std::size_t i) {
          x[i * Dimension + static_cast<std::size_t>(axis)]
            = coordinate_bounds(points_[first + i], axis).first;
        });
    }
  }

  void read_at(const Place* positions, std::size_t count, double* x) const override
  {
    for(std::size_t i = 0; i < count; ++i)
      read_point(points_[positions[i]], x + i * Dimension);
  }

  void prefetch(std::size_t position) const override { prefetch_point(points_, position); }

  void read_numbers([[maybe_unused]] std::size_t first, [[maybe_unused]] std::size_t count,
                    [[maybe_unused]] Place* numbers) const override
  {
    if constexpr(internal::have_numbers<Elements>)
      for(std::size_t i = 0; i < count; ++i)
        numbers[i] = points_.number(first + i);
  }

  std::size_t position(Place number) const override
  {
    if constexpr(internal::have_numbers<Elements>)
      return points_.place(number);
    else
      return number;
  }

  const Integer_distance* integers() const override { return is_within_->integers(); }

  bool is_pair(std::size_t i, std::size_t j, Decision_counts& counts) const override
  {
    return is_within_->decide_undecided(points_[i], points_[j], counts);
  }

  bool advance(std::size_t finished) override { return progress_.advance(finished); }

private:
  // Calls task(i) for each i in [0, count), four times in each step of the loop.
  template <class Task>
  static void for_each_below(std::size_t count, const Task& task)
  {
    std::size_t i = 0;
    for(; i + 4 <= count; i += 4) {
      task(i);
      task(i + 1);
      task(i + 2);
      task(i + 3);
    }
    for(; i < count; ++i)
      task(i);
  }

  static void read_point(const Point& point, double* x)
  {
    for(int axis = 0; axis < Dimension; ++axis)
      x[axis] = coordinate_bounds(point, axis).first;
  }

  const Elements& points_;
  const Is_within_distance<Point>* is_within_ = nullptr; // what decides near ties
  Progress& progress_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_ELEMENT_POINTS_H
