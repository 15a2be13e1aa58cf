// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_POINT_READER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_POINT_READER_H

// Reads points in blocks, and turns their doubles into the numbers that slabs have: scaled doubles
// or 32-bit integers.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns where a double of a point is. \pre points.are_viewed
template <int Dimension>
const double* address_of_double(const Near_points<Dimension>& points, std::size_t position,
                                int axis)
{
  return position < points.first_size ? points.views[0].at(position, axis)
                                      : points.views[1].at(position - points.first_size, axis);
}

// Returns the doubles of a point.
template <int Dimension>
std::array<double, Dimension> doubles_of(const Near_points<Dimension>& points, std::size_t position)
{
  std::array<double, Dimension> x;
  if(!points.are_viewed)
    points.read(position, 1, Near_points<Dimension>::all_axes, x.data());
  else
    for(int axis = 0; axis < Dimension; ++axis)
      x[axis] = *address_of_double(points, position, axis);
  return x;
}

// Prefetches the doubles of a point.
template <int Dimension>
void prefetch_doubles(const Near_points<Dimension>& points, std::size_t position)
{
  if(!points.are_viewed)
    points.prefetch(position);
  else
    for(int axis = 0; axis < Dimension; ++axis)
      prefetch_to_read(address_of_double(points, position, axis));
}

// Consecutive points: their doubles, with the coordinates of a point behind each other.
struct Point_block
{
  static constexpr Place max_size = 256;

  std::size_t first;
  std::size_t size;
  const char* x;        // where the first point is
  std::ptrdiff_t step;  // from one point to the next
  const Place* numbers; // what the points are reported by; not of a block of one axis

  const double* point(std::size_t place) const
  {
    return reinterpret_cast<const double*>(x + static_cast<std::ptrdiff_t>(place) * step);
  }
};

// Turns the doubles of points into numbers: doubles, or steps of a Narrow_scale. Loops have a copy,
// which stays in registers.
template <int Dimension, class Number>
struct To_number
{
  double scale;
  std::array<double, Dimension> low;
  double steps;

  Number operator()(double x, int axis) const
  {
    if constexpr(std::is_same_v<Number, double>)
      return x * scale;
    else
      return static_cast<Number>((x * scale - low[axis]) * steps);
  }
};

// Reads blocks, whatever numbers are made of them.
template <int Dimension>
class Block_reader
{
public:
  static constexpr int all_axes = Near_points<Dimension>::all_axes;

  explicit Block_reader(const Near_points<Dimension>& points) : points_(points) {}

  // Calls task(block) for blocks of the points [first, last). They have the doubles along one axis
  // or along all of them.
  template <class Task>
  void read_blocks(std::size_t first, std::size_t last, int axis, const Task& task) const
  {
    Copies copies;
    while(first != last) {
      const Point_block block = read(first, last, axis, copies);
      task(block);
      first += block.size;
    }
  }

protected:
  const Near_points<Dimension>& points_;

private:
  // The doubles of a block, unless they are where points have them one behind the other.
  struct Copies
  {
    double x[Point_block::max_size * Dimension];
    Place numbers[Point_block::max_size];
  };

  // Returns a block from the point `first` on.
  BOOST_NOINLINE Point_block read(std::size_t first, std::size_t last, int axis,
                                  Copies& copies) const
  {
    const bool is_first = first < points_.first_size;
    std::size_t size = (std::min)(last - first, std::size_t(Point_block::max_size));
    if(points_.are_viewed && is_first)
      size = (std::min)(size, points_.first_size - first);
    if(axis == all_axes)
      set_numbers(first, size, copies.numbers);
    Point_block block = {first, size, reinterpret_cast<const char*>(copies.x),
                         Dimension * sizeof(double), copies.numbers};
    const Doubles_view<Dimension>& view = points_.views[is_first ? 0 : 1];
    if(!points_.are_viewed)
      points_.read(first, size, axis, copies.x);
    else if(axis != all_axes || view.is_packed()) {
      const int a = axis == all_axes ? 0 : axis;
      block.x = reinterpret_cast<const char*>(address_of_double(points_, first, a) - a);
      block.step = view.step[a];
    }
    else
      for(int a = 0; a < Dimension; ++a)
        copy(reinterpret_cast<const char*>(address_of_double(points_, first, a)), view.step[a],
             size, copies.x + a);
    return block;
  }

  // The loop is the same for all blocks, so compilers count several numbers at once.
  void set_numbers(std::size_t first, std::size_t size, Place* numbers) const
  {
    if(points_.are_numbered)
      points_.read_numbers(first, size, numbers);
    else {
      const Place position = static_cast<Place>(first);
      for(Place i = 0; i < Point_block::max_size; ++i)
        numbers[i] = position + i;
    }
  }

  // Copies four doubles in each step of the loop, and then the rest.
  static void copy(const char* x, std::ptrdiff_t step, std::size_t size, double* to)
  {
    const auto at = [&](std::ptrdiff_t i) {
      return *reinterpret_cast<const double*>(x + i * step);
    };
    for(; size >= 4; size -= 4, x += 4 * step, to += 4 * Dimension) {
      to[0] = at(0);
      to[Dimension] = at(1);
      to[2 * Dimension] = at(2);
      to[3 * Dimension] = at(3);
    }
    for(; size != 0; --size, x += step, to += Dimension)
      *to = at(0);
  }
};

template <int Dimension, class Number>
class Point_reader : public Block_reader<Dimension>
{
  using Block_reader<Dimension>::points_;

public:
  Point_reader(const Near_points<Dimension>& points, const Near_task<Dimension>& task)
    : Block_reader<Dimension>(points), box_(task.box),
      to_number_{task.near.scale, task.scale.low(), task.scale.steps()}
  {}

  std::size_t size() const { return points_.size; }
  bool are_numbered() const { return points_.are_numbered; }
  const To_number<Dimension, Number>& to_number() const { return to_number_; }

  // Returns the interval of the numbers along an axis.
  Interval interval(int axis) const
  {
    const Interval& interval = box_[axis];
    return {double(to_number_(interval.low, axis)), double(to_number_(interval.high, axis))};
  }

  Number coordinate(std::size_t position, int axis) const
  {
    return to_number_(doubles_of(points_, position)[axis], axis);
  }

private:
  const std::array<Interval, Dimension> box_;
  const To_number<Dimension, Number> to_number_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_POINT_READER_H
