// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The kd-tree of ANN (Mount, Arya), asked for the ball around each point without approximation. Its
// squared distances are doubles, compared with the rounded square of r: it is not exact.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_ANN_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_ANN_H

#include "all_pairs.h"

#include <ANN/ANN.h>

#include <vector>

namespace thick_benchmark {

template <class Point, class Answer>
void ann_search(const std::vector<Point>& points, double r, Answer& answer)
{
  std::vector<double> coordinates;
  for(const Point& p : points)
    for(int axis = 0; axis < dimension_of<Point>; ++axis)
      coordinates.push_back(p.cartesian(axis));
  std::vector<ANNpoint> rows;
  for(std::size_t i = 0; i < points.size(); ++i)
    rows.push_back(coordinates.data() + i * dimension_of<Point>);

  ANNkd_tree tree(rows.data(), static_cast<int>(rows.size()), dimension_of<Point>);
  std::vector<ANNidx> found(64);
  std::vector<ANNdist> distances(found.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto search = [&] {
      return static_cast<std::size_t>(
        tree.annkFRSearch(rows[i], r * r, static_cast<int>(found.size()), found.data(),
                          distances.data()));
    };
    std::size_t count = search();
    if(count > found.size()) { // it counts all, but keeps the nearest only
      found.resize(2 * count);
      distances.resize(found.size());
      count = search();
    }
    for(std::size_t f = 0; f < count; ++f)
      answer.neighbour(i, static_cast<std::size_t>(found[f]));
  }
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_ANN_H
