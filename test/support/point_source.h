// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points as slabs ask for them, and scenes that are hard to cut.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_POINT_SOURCE_H
#define THICK_INTERSECTION_TEST_SUPPORT_POINT_SOURCE_H

#include "point_generators.h"

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

template <int Dimension>
class Point_source
{
public:
  explicit Point_source(const Points& points) : points_(points) {}

  CGAL::Thick_intersection_d::internal::Interval interval(int axis) const
  {
    CGAL::Thick_intersection_d::internal::Interval interval;
    for(const Coordinates& c : points_)
      interval.add(c[static_cast<std::size_t>(axis)]);
    return interval;
  }
  double coordinate(std::size_t position, int axis) const
  {
    return points_[position][static_cast<std::size_t>(axis)];
  }
  void put(std::size_t position,
           CGAL::Thick_intersection_d::internal::Slab_point<Dimension, double>& place) const
  {
    std::copy_n(points_[position].begin(), Dimension, place.x.begin());
    place.position = static_cast<CGAL::Thick_intersection_d::internal::Place>(position);
  }

private:
  const Points& points_;
};

template <int Dimension>
std::vector<CGAL::Thick_intersection_d::internal::Slab_point<Dimension, double>>
slab_points(const Points& points)
{
  using Point = CGAL::Thick_intersection_d::internal::Slab_point<Dimension, double>;
  const Point_source<Dimension> source(points);
  std::vector<Point> result(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    source.put(i, result[i]);
  return result;
}

// Coordinates 2^-k along the last axis: equal slabs leave nearly all points in the lowest one.
inline Points geometric_points(int dimension, std::size_t n)
{
  Points points;
  for(std::size_t i = 0; i < n; ++i)
    points.push_back(Coordinates(static_cast<std::size_t>(dimension),
                                 std::ldexp(1., -static_cast<int>(i % 900))));
  return points;
}

// Scenes by name: even and crowded, with an outlier, with many equal points, on a line across the
// slabs, and of all magnitudes.
inline std::vector<std::pair<std::string, Points>> scenes_to_cut(int dimension, std::size_t n)
{
  const Points uniform = uniform_points(dimension, n, 0, 1, 1);
  Points outlier = uniform, line = uniform;
  outlier[n / 2].back() = 1e15;
  for(Coordinates& c : line)
    std::fill(c.begin(), c.end() - 1, 0.5);
  return {{"uniform", uniform},
          {"clusters", clustered_points(dimension, n, 3, 1. / 256, 3)},
          {"outlier", outlier},
          {"lattice", lattice_points(dimension, dimension == 2 ? 50 : 13, 0.1)},
          {"one place", identical_points(dimension, n, 1)},
          {"line", line},
          {"flight", flight_points(dimension, n)},
          {"geometric", geometric_points(dimension, n)}};
}

// A tuning that cuts few points often.
inline CGAL::Thick_intersection_d::internal::Slab_tuning tuning_for_few_points()
{
  CGAL::Thick_intersection_d::internal::Slab_tuning tuning;
  tuning.points_per_slab = 8;
  tuning.points_per_strip = 2;
  tuning.points_per_sorted_strip = 3;
  tuning.max_slab_size = 64;
  return tuning;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_POINT_SOURCE_H
