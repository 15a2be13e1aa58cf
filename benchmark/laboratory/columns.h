// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The columns of the tables: methods that report all near pairs of a scene, ours and others.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_COLUMNS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_COLUMNS_H

#include "methods/Method.h"
#include "scenes/from_tests.h"

#include "support/exact_points.h"
#include "support/pairs.h"

#include <algorithm>
#include <string>
#include <vector>

namespace lab {

using namespace thick_benchmark;
using test_support::Pair;
using test_support::Pairs;
using test_support::Point_scene;

// What a method reports. If it asks for the neighbours of one point after the other, (i, j) means
// that j was found from i, and both ways are there. Otherwise i < j.
struct Found
{
  Pairs pairs;
  bool is_directed = false;

  void operator()(std::size_t i, std::size_t j) { pairs.push_back(std::minmax(i, j)); }
  void neighbour(std::size_t i, std::size_t j)
  {
    is_directed = true;
    if(i != j)
      pairs.emplace_back(i, j);
  }
};

template <class Scene>
struct Column_for : Method<Found, Scene>
{
  std::string group; // "form", "library", "grid", "boxes", "ours"
};

using Column = Column_for<Scene>;

using Columns = std::vector<Column>;

// In the order in which tables have them.
Columns plain_columns();    // forms, grids, nanoflann
Columns cgal_columns();     // squared distances, Kd_tree, boxes
Columns delaunay_columns(); // CGAL, too
Columns package_columns();  // ours

inline Columns all_columns()
{
  Columns all;
  for(const auto& make : {plain_columns, cgal_columns, delaunay_columns, package_columns})
    for(Column& column : make())
      all.push_back(std::move(column));
  return all;
}

// Decides exactly whether two points of a scene are near.
inline test_support::Exact_points exact_points(const Scene& scene)
{
  return test_support::Exact_points(points_of(scene), radius_of(scene));
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_COLUMNS_H
