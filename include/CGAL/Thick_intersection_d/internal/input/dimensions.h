// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_DIMENSIONS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_DIMENSIONS_H

// The dimension of points, where it has to be a constant.

#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The dimension of points, as a tag. Points of CGAL say it themselves. Their kernel says it as well
// unless it is `Epeck_d`.
template <class Point, class = void>
struct Point_dimension
{
  using type = typename Ambient_dimension<Point>::type;
};
template <class Point>
struct Point_dimension<Point, std::void_t<typename Point::Ambient_dimension>>
{
  using type = typename Point::Ambient_dimension;
};

template <class Point>
using Point_dimension_t = typename Point_dimension<Point>::type;

template <class T, class = void>
struct Is_weighted_point : std::false_type {};
template <class T>
struct Is_weighted_point<T, std::void_t<typename T::Weight, typename T::Point>>
  : std::bool_constant<!Is_kernel_point<T>::value> {};

template <class T, class = void>
struct Is_point : std::false_type {};
template <class T>
struct Is_point<T, std::void_t<decltype(std::declval<const T&>().cartesian(0)),
                               decltype(std::declval<const T&>().dimension()),
                               Point_dimension_t<T>>>
  : std::bool_constant<!Is_weighted_point<T>::value> {};

// Returns the dimension of a type of points, or `fallback` if only the points know their dimension.
template <class Point>
constexpr int dimension_or(int fallback)
{
  using Dimension = Point_dimension_t<Point>;
  if constexpr(std::is_same_v<Dimension, Dynamic_dimension_tag>)
    return fallback;
  else
    return Dimension::value;
}

// If the dimension D of the points is 2 or 3, calls f(std::integral_constant<int, D>()). Otherwise
// calls otherwise().
template <class Point, class Function, class Otherwise>
auto for_plane_and_space(int dimension, const Function& f, const Otherwise& otherwise)
{
  if constexpr(dimension_or<Point>(2) == 2)
    if(dimension == 2)
      return f(std::integral_constant<int, 2>());
  if constexpr(dimension_or<Point>(3) == 3)
    if(dimension == 3)
      return f(std::integral_constant<int, 3>());
  return otherwise();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_DIMENSIONS_H
