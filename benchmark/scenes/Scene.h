// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A scene: points, and the distance that counts as near.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_SCENE_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_SCENE_H

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace thick_benchmark {

struct Scene
{
  std::string name;
  int dimension;
  std::vector<double> coordinates; // point by point
  double r;
  std::string square = {}; // of the distance, as text, where r is its rounded root

  std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dimension); }
  const double* point(std::size_t i) const
  {
    return coordinates.data() + i * static_cast<std::size_t>(dimension);
  }
};

// The type of the points of a scene in a kernel.
template <class Kernel, int Dimension>
using Point_t = std::conditional_t<Dimension == 2, typename Kernel::Point_2,
                                   typename Kernel::Point_3>;

// Stands for a kernel where none is needed.
struct Arrays
{
  using FT = double;
  using Point_2 = std::array<double, 2>;
  using Point_3 = std::array<double, 3>;
};

template <class Kernel, int Dimension>
std::vector<Point_t<Kernel, Dimension>> make_points(const Scene& scene)
{
  using FT = typename Kernel::FT;
  using Point = Point_t<Kernel, Dimension>;
  std::vector<Point> points;
  points.reserve(scene.size());
  for(const double* x = scene.coordinates.data(); points.size() < scene.size(); x += Dimension)
    if constexpr(Dimension == 2)
      points.push_back(Point{FT(x[0]), FT(x[1])});
    else
      points.push_back(Point{FT(x[0]), FT(x[1]), FT(x[2])});
  return points;
}

// The coordinates along the first axis.
inline std::vector<double> x_coordinates(const Scene& scene)
{
  std::vector<double> x;
  x.reserve(scene.size());
  for(std::size_t i = 0; i < scene.size(); ++i)
    x.push_back(*scene.point(i));
  return x;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_SCENE_H
