// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_COORDINATES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_COORDINATES_H

// Reads points, for `Point_2`, `Point_3` and `Point_d` of every kernel: Cartesian coordinates,
// double bounds of their differences, exact squared distances. The package reads coordinates by
// these functions only.

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The compiler leaves the precondition of cartesian() out, if it knows that it holds. No other code
// of a search has preconditions, so their exceptions are not compiled either.
template <class Point>
decltype(auto) coordinate(const Point& p, int i)
{
  if constexpr(dimension_or<Point>(0) != 0)
    CGAL_assume(0 <= i && i < dimension_or<Point>(0));
  return as_base(p).cartesian(i); // a class that derives from that of points may hide it
}

template <class Point>
int dimension_of(const Point& p)
{
  return as_base(p).dimension();
}

// The number type of the coordinates of Point.
template <class Point>
using Coordinate_t = std::decay_t<decltype(coordinate(std::declval<const Point&>(), 0))>;

template <class Point>
using Approximate_coordinate_t = decltype(std::declval<const Point&>().approx().cartesian(0));

// Whether points hold intervals of their coordinates, as points of lazy kernels do.
template <class Point, class = void>
struct Has_approximation : std::false_type {};
template <class Point>
struct Has_approximation<Point, std::void_t<Approximate_coordinate_t<Point>>> : std::true_type {};

template <class Elements, class = void>
struct Can_prefetch : std::false_type {};
template <class Elements>
struct Can_prefetch<Elements, std::void_t<decltype(std::declval<const Elements&>().prefetch(0))>>
  : std::true_type {};

// Asks for what a scan will read of a point, where the points do not lie in the order of their
// positions: what the range says, or the approximation of a lazy point, if the range holds the
// point. A handle to this memory is all that the point itself holds.
template <class Elements>
void prefetch_approximation([[maybe_unused]] const Elements& points,
                           [[maybe_unused]] std::size_t position)
{
  if constexpr(Can_prefetch<Elements>::value)
    points.prefetch(position);
  else if constexpr(Has_approximation<typename Elements::value_type>::value
                    && std::is_lvalue_reference_v<decltype(points[position])>)
    prefetch_to_read(points[position].for_compact_container());
}

// Prefetches a point, if the range holds it: for the cache lines of its two ends.
template <class Elements>
void prefetch_point([[maybe_unused]] const Elements& points, [[maybe_unused]] std::size_t position)
{
  if constexpr(std::is_lvalue_reference_v<decltype(points[position])>) {
    const auto* const point = std::addressof(points[position]);
    prefetch_to_read(point);
    prefetch_to_read(reinterpret_cast<const char*>(point + 1) - 1);
  }
}

// Returns doubles that enclose coordinate i of p. A lazy point has them in its approximation. Its
// coordinate would be a new lazy number, with memory of its own.
template <class Point>
std::pair<double, double> coordinate_bounds(const Point& p, int i)
{
  if constexpr(Has_approximation<Point>::value) {
    const auto x = p.approx().cartesian(i);
    return {x.inf(), x.sup()};
  }
  else
    return bounds(coordinate(p, i));
}

// Doubles that enclose the distance of two numbers. Each results from the bounds of the numbers by
// one rounded subtraction, so its relative error is at most one unit in the last place.
struct Gap
{
  double inf;
  double sup;
};

inline Gap gap(const std::pair<double, double>& a, const std::pair<double, double>& b)
{
  return {(std::max)({a.first - b.second, b.first - a.second, 0.}),
          (std::max)(a.second - b.first, b.second - a.first)};
}

template <class NT>
Gap gap(const NT& x, const NT& y)
{
  if constexpr(is_held_by_double_v<NT>) {
    const double difference = std::fabs(static_cast<double>(x) - static_cast<double>(y));
    return {difference, difference};
  }
  else
    return gap(bounds(x), bounds(y));
}

// Returns doubles that enclose the distance of two points along axis i.
template <class Point>
Gap gap_along(const Point& p, const Point& q, int i)
{
  if constexpr(is_held_by_double_v<Coordinate_t<Point>>)
    return gap(coordinate(p, i), coordinate(q, i));
  else
    return gap(coordinate_bounds(p, i), coordinate_bounds(q, i));
}

// Returns doubles that enclose |pq|^2, up to relative_error().
template <class Point>
Gap squared_distance_bounds(const Point& p, const Point& q, int dimension)
{
  Gap sum = {0, 0};
  for(int axis = 0; axis < dimension; ++axis) {
    const Gap g = gap_along(p, q, axis);
    sum.inf += g.inf * g.inf;
    sum.sup += g.sup * g.sup;
  }
  return sum;
}

// Returns true if |x - y| <= reach. May return true for other numbers too. One rounded subtraction
// never makes it false for numbers within reach: rounding is monotone, and fixes the reach.
template <class NT>
bool is_within_reach(const NT& x, const NT& y, double reach)
{
  return gap(x, y).inf <= reach;
}

// Adds the square of a difference to a sum, without error.
template <class Exact, class NT>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED void add_exact_square(Exact& sum, const NT& x, const NT& y)
{
  const Exact difference = to_exact<Exact>(x) - to_exact<Exact>(y);
  sum += difference * difference;
}

// Returns |pq|^2 without error. Degree 2.
template <class Point>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
auto exact_squared_distance(const Point& p, const Point& q, int dimension)
{
  Exact_number_t<Coordinate_t<Point>> sum(0);
  for(int i = 0; i < dimension; ++i)
    add_exact_square(sum, coordinate(p, i), coordinate(q, i));
  return sum;
}

template <class Exact>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED Sign compare_exactly(const Exact& a, const Exact& b)
{
  return a < b ? SMALLER : b < a ? LARGER : EQUAL;
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template void add_exact_square(Exact_of_doubles&, const double&, const double&);
extern template Sign compare_exactly(const Exact_of_doubles&, const Exact_of_doubles&);
#endif

// Texts are made only for an error, and appended, because sums of texts take long to compile.
[[noreturn]] CGAL_THICK_INTERSECTION_D_RARELY_CALLED inline
void throw_wrong_dimension(const char* name, std::size_t position, int dimension, int expected)
{
  std::string message(name);
  message.append(" ").append(std::to_string(position));
  message.append(" has dimension ").append(std::to_string(std::size_t(dimension)));
  message.append(" instead of ").append(std::to_string(std::size_t(expected))).append(".");
  throw std::invalid_argument(message);
}

[[noreturn]] CGAL_THICK_INTERSECTION_D_RARELY_CALLED inline
void throw_not_finite(const char* name, std::size_t position, int axis)
{
  std::string message("Coordinate ");
  message.append(std::to_string(std::size_t(axis))).append(" of ").append(name).append(" ");
  message.append(std::to_string(position)).append(" is NaN or infinite.");
  throw std::invalid_argument(message);
}

// Throws if a coordinate of `p` is NaN or infinite, or if its dimension is not `dimension`.
template <class Point>
void check_point(const Point& p, int dimension, const char* name, std::size_t position)
{
  if(dimension_of(p) != dimension)
    throw_wrong_dimension(name, position, dimension_of(p), dimension);
  for(int i = 0; i < dimension; ++i)
    if(!is_finite_number(coordinate(p, i)))
      throw_not_finite(name, position, i);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_COORDINATES_H
