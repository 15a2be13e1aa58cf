// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Two loops and the exact predicate.

#ifndef THICK_INTERSECTION_BENCHMARK_RIVALS_ALL_PAIRS_H
#define THICK_INTERSECTION_BENCHMARK_RIVALS_ALL_PAIRS_H

#include "near_points.h"

#include <vector>

namespace thick_benchmark {

template <class Point, class Callback>
void all_pairs(const std::vector<Point>& points, double r, Callback& callback)
{
  const Is_near<Point> is_near = make_is_near<Point>(r);
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = i + 1; j < points.size(); ++j)
      if(is_near(points[i], points[j]))
        callback(i, j);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_RIVALS_ALL_PAIRS_H
