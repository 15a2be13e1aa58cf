// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points as slabs ask for them, and scenes that are hard to cut.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_POINT_SOURCE_H
#define THICK_INTERSECTION_TEST_SUPPORT_POINT_SOURCE_H

#include "point_generators.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;

// Reads the points in blocks. Nothing decides pairs that lanes leave undecided.
template <int Dimension>
class Point_source : public internal::Near_points<Dimension>
{
public:
  using Task = internal::Near_task<Dimension>;
  using Reader = internal::Point_reader<Dimension, double>;

  explicit Point_source(const Points& points) : points_(points) { this->size = points.size(); }

  void read(std::size_t first, std::size_t count, int axis, double* x) const override
  {
    for(std::size_t i = 0; i < count; ++i, x += Dimension)
      for(int a = 0; a < Dimension; ++a)
        if(axis == a || axis == internal::Near_points<Dimension>::all_axes)
          x[a] = points_[first + i][static_cast<std::size_t>(a)];
  }
  void read_at(const internal::Place* positions, std::size_t count, double* x) const override
  {
    for(std::size_t i = 0; i < count; ++i)
      read(positions[i], 1, internal::Near_points<Dimension>::all_axes, x + i * Dimension);
  }
  void prefetch(std::size_t) const override {}
  void read_numbers(std::size_t, std::size_t, internal::Place*) const override {}
  std::size_t position(internal::Place number) const override { return number; }
  const internal::Integer_distance* integers() const override { return nullptr; }
  bool is_pair(std::size_t, std::size_t, internal::Decision_counts&) const override
  {
    return false;
  }
  bool advance(std::size_t) override { return true; }

  // The filter leaves all pairs undecided.
  Task task(double reach = 0) const
  {
    Task task;
    for(const Coordinates& c : points_)
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        task.box[axis].add(c[axis]);
    task.near = {1, reach, {}};
    return task;
  }

  Reader reader() const { return Reader(*this, task()); }

private:
  const Points& points_;
};

template <int Dimension>
std::vector<internal::Slab_point<Dimension, double>> slab_points(const Points& points)
{
  std::vector<internal::Slab_point<Dimension, double>> result(points.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    std::copy_n(points[i].begin(), Dimension, result[i].x.begin());
    result[i].position = static_cast<internal::Place>(i);
  }
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
inline internal::Slab_tuning tuning_for_few_points()
{
  internal::Slab_tuning tuning;
  tuning.points_per_slab = 8;
  tuning.points_per_strip = 2;
  tuning.points_per_sorted_strip = 3;
  tuning.max_slab_size = 64;
  return tuning;
}

// The slabs of points that are searched for near ones.
template <int Dimension>
internal::Slabs<internal::Slab_point<Dimension, double>>
slabs_of(const Points& points, double reach,
         const internal::Slab_tuning& tuning = tuning_for_few_points())
{
  return {Point_source<Dimension>(points).reader(), reach, internal::Point_sets(),
          internal::Threads(), tuning};
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_POINT_SOURCE_H
