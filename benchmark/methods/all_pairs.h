// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Two loops and a predicate; and the predicate of the package, the fastest exact one there is. All
// methods use it that have no exact predicate of their own.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_ALL_PAIRS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_ALL_PAIRS_H

#include <CGAL/Thick_point_traits_d.h>

#include <array>
#include <vector>

namespace thick_benchmark {

template <class Point>
constexpr int dimension_of = CGAL::Ambient_dimension<Point>::value;
template <std::size_t Dimension>
constexpr int dimension_of<std::array<double, Dimension>> = static_cast<int>(Dimension);

// Returns whether the points at two positions are within r, as a function object.
template <class Point>
auto is_near_exactly(const std::vector<Point>& points, double r, int dimension)
{
  const CGAL::Thick_point_traits_d<Point> traits(CGAL::within_distance(r), dimension);
  const auto is_near = traits.do_intersect_d_object();
  return [&points, is_near](std::size_t i, std::size_t j) -> bool {
    return is_near(points[i], points[j]);
  };
}

template <class Point>
auto is_near_exactly(const std::vector<Point>& points, double r)
{
  return is_near_exactly(points, r, dimension_of<Point>);
}

template <class Is_near, class Answer>
void all_pairs(std::size_t n, const Is_near& is_near, Answer& answer)
{
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = i + 1; j < n; ++j)
      if(is_near(i, j))
        answer(i, j);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_ALL_PAIRS_H
