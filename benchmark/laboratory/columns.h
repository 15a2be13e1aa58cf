// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Methods that report all near pairs of a scene, ours and others, with one interface.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_COLUMNS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_COLUMNS_H

#include "methods/distance_forms.h"

#include "support/pairs.h"
#include "support/point_scene.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace lab {

using test_support::Pair;
using test_support::Pairs;
using test_support::Point_scene;

// What a method reports. If it asks for the neighbours of one point after the other, (i, j) means
// that j was found from i, and both ways are there. Otherwise i < j.
struct Found
{
  Pairs pairs;
  bool is_directed = false;
  double seconds = 0; // from the points in the method's own type to the last pair
};

struct Method
{
  std::string name;
  std::string group; // "form", "library", "grid", "boxes", "ours"
  std::function<Found(const Point_scene&)> find;
};

// The methods for points of a dimension, 2 or 3, in the order in which tables have them.
std::vector<Method> plain_methods(int dimension);   // forms, grids, nanoflann, Boost
std::vector<Method> cgal_methods(int dimension);    // Kd_tree, Delaunay, boxes, squared distances
std::vector<Method> delaunay_methods_3();           // those of cgal_methods() in space
std::vector<Method> package_methods(int dimension); // ours

inline std::vector<Method> all_methods(int dimension)
{
  std::vector<Method> methods = plain_methods(dimension);
  for(const auto& make : {cgal_methods, package_methods})
    for(Method& method : make(dimension))
      methods.push_back(std::move(method));
  return methods;
}

// The radius that a method gets which takes a length as a double.
inline double length_of(const test_support::Radius& radius)
{
  return radius.length() ? *radius.length() : std::sqrt(std::stod(radius.square_text()));
}

template <std::size_t Dimension>
std::vector<Array_point<Dimension>> array_points(const Point_scene& scene)
{
  std::vector<Array_point<Dimension>> points(scene.points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    std::copy_n(scene.points[i].begin(), Dimension, points[i].begin());
  return points;
}

// Runs search(pairs), which appends what it finds, and takes the time.
template <class Search>
Found timed(bool is_directed, const Search& search)
{
  using Clock = std::chrono::steady_clock;
  Found found;
  found.is_directed = is_directed;
  const Clock::time_point start = Clock::now();
  search(found.pairs);
  found.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return found;
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_COLUMNS_H
