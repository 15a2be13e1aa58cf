// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small scenes for any dimension: the empty and the tiny, uniform and clustered points, ties,
// duplicates, flat and stretched scenes. `small_scenes(d)` is all of them;
// `all_scenes(d)` has the families as well on which distances are computed wrongly.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_SCENES_H

#include "robustness_families.h"

namespace test_support {

inline Point_scene scene(std::string name, int dimension, Points points, Radius radius)
{
  return {std::move(name), dimension, std::move(points), std::move(radius), std::nullopt};
}

// A side that keeps a lattice of this dimension below about 800 points.
inline std::size_t lattice_side(int dimension)
{
  constexpr std::size_t sides[] = {200, 24, 8, 5};
  return dimension <= 4 ? sides[dimension - 1] : 3;
}

// A radius giving uniform points in the unit cube a few neighbours each.
inline double uniform_radius(int dimension)
{
  constexpr double radii[] = {1. / 512, 1. / 16, 5. / 32, 5. / 16};
  return dimension <= 4 ? radii[dimension - 1] : 0.5;
}

// At 5 exactly; oblique where there is more than one axis.
inline Points two_points_at_five(int dimension)
{
  Points points = identical_points(dimension, 2, -7);
  if(dimension == 1)
    points[1][0] += 5;
  else {
    points[1][0] += 3;
    points[1][dimension - 1] += 4;
  }
  return points;
}

inline void append_tiny_scenes(int d, Scenes& scenes)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Points two = two_points_at_five(d);
  scenes.push_back(scene("empty", d, {}, Radius::of_length(1)));
  scenes.push_back(scene("one point", d, identical_points(d, 1, 0.1), Radius::of_length(1)));
  scenes.push_back(scene("two points at exactly r", d, two, Radius::of_length(5)));
  scenes.push_back(scene("two points at exactly r, squared", d, two, Radius::of_square("25")));
  scenes.push_back(scene("two points just beyond r", d, two,
                         Radius::of_length(std::nextafter(5., 0.))));
  scenes.push_back(scene("two points just within r", d, two,
                         Radius::of_length(std::nextafter(5., infinity))));
  scenes.push_back(scene("two equal points, r = 0", d, identical_points(d, 2, 0.1),
                         Radius::of_length(0)));
  scenes.push_back(scene("plus and minus zero, r = 0", d,
                         {Coordinates(d, 0.), Coordinates(d, -0.)}, Radius::of_length(0)));
}

inline void append_random_scenes(int d, Scenes& scenes)
{
  const double r = uniform_radius(d);
  scenes.push_back(scene("uniform", d, uniform_points(d, 500, 0, 1, 11), Radius::of_length(r)));
  scenes.push_back(scene("uniform around the origin", d, uniform_points(d, 500, -0.5, 1, 12),
                         Radius::of_length(1.5 * r)));
  scenes.push_back(scene("uniform, everything near", d, uniform_points(d, 200, 0, 1, 13),
                         Radius::of_length(d)));
  scenes.push_back(scene("uniform, nothing near", d, uniform_points(d, 300, 0, 1e6, 14),
                         Radius::of_length(1e-3)));
  scenes.push_back(scene("clustered", d, clustered_points(d, 500, 12, 1. / 64, 15),
                         Radius::of_length(d / 128.)));
  scenes.push_back(scene("clustered, duplicates", d,
                         shuffled(repeated(clustered_points(d, 120, 5, 1. / 64, 16), 3), 17),
                         Radius::of_length(1. / 128)));
}

// Units that are no binary fraction and offsets of the other sign are what finds a bound that was
// rounded twice.
inline void append_lattice_scenes(int d, Scenes& scenes)
{
  const std::size_t m = lattice_side(d);
  const auto lattice = [&](double unit, double offset) {
    return shuffled(lattice_points(d, m, unit, offset), 21);
  };
  scenes.push_back(scene("unit lattice", d, lattice(1, -4), Radius::of_length(2)));
  scenes.push_back(scene("unit lattice in order", d, lattice_points(d, m, 1),
                         Radius::of_length(1)));
  scenes.push_back(scene("unit lattice, r^2 = 2", d, lattice(1, -4), Radius::of_square("2")));
  scenes.push_back(scene("half lattice, r^2 = 5/4", d, lattice(0.5, -3), Radius::of_square("5/4")));
  scenes.push_back(scene("lattice 0.1, r = 0.2", d, lattice(0.1, -0.9), Radius::of_length(0.2)));
  scenes.push_back(scene("lattice 1/3, r = 1/3", d, lattice(1 / 3., -2),
                         Radius::of_length(1 / 3.)));
  scenes.push_back(scene("lattice 0.7, r = 1.4", d, lattice(0.7, -30.1), Radius::of_length(1.4)));
  scenes.push_back(scene("unit lattice, r^2 = 1/3", d, lattice(1, 0), Radius::of_square("1/3")));
}

inline void append_duplicate_scenes(int d, Scenes& scenes)
{
  const Points some = uniform_points(d, 100, 0, 1, 31);
  const Points same = identical_points(d, 150, 0.3);
  scenes.push_back(scene("duplicates, r = 0", d, repeated(some, 4), Radius::of_length(0)));
  scenes.push_back(scene("duplicates", d, shuffled(repeated(some, 4), 32),
                         Radius::of_length(uniform_radius(d))));
  scenes.push_back(scene("all identical, r = 0", d, same, Radius::of_length(0)));
  scenes.push_back(scene("all identical", d, same, Radius::of_length(1)));
}

// Scenes that do not fill their dimension, or fill it very unevenly.
inline void append_flat_scenes(int d, Scenes& scenes)
{
  for(int axis = 0; axis < d; ++axis) {
    const std::string along = " along axis " + std::to_string(axis);
    scenes.push_back(scene("collinear" + along, d,
                           shuffled(axis_points(d, 200, axis, -9.9, 0.1), 41),
                           Radius::of_length(0.3)));
    Points plate = uniform_points(d, 300, 0, 1, 42 + static_cast<std::uint64_t>(axis));
    for(Coordinates& p : plate)
      p[axis] *= 1. / 1024;
    scenes.push_back(scene("thin" + along, d, plate, Radius::of_length(uniform_radius(d))));
  }
  Coordinates direction(d, 3);
  direction[d - 1] = -4;
  scenes.push_back(scene("collinear oblique", d, shuffled(oblique_points(direction, 200), 43),
                         Radius::of_length(15)));
  Points outlier = uniform_points(d, 300, 0, 1, 44);
  outlier[150] = Coordinates(d, 1e15 * uniform_radius(d));
  scenes.push_back(scene("outlier at 10^15 reaches", d, outlier,
                         Radius::of_length(uniform_radius(d))));
}

inline Scenes small_scenes(int dimension)
{
  Scenes scenes;
  append_tiny_scenes(dimension, scenes);
  append_random_scenes(dimension, scenes);
  append_lattice_scenes(dimension, scenes);
  append_duplicate_scenes(dimension, scenes);
  append_flat_scenes(dimension, scenes);
  return scenes;
}

inline Scenes all_scenes(int dimension)
{
  Scenes scenes = small_scenes(dimension);
  if(dimension == 2 || dimension == 3)
    for(const Point_scene& family : robustness_families(dimension))
      scenes.push_back(family);
  return scenes;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SCENES_H
