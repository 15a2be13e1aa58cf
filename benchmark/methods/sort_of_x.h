// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// std::sort of the x-coordinates, the measure of all methods. It finds nothing.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_SORT_OF_X_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_SORT_OF_X_H

#include "Method.h"

#include <algorithm>

namespace thick_benchmark {

template <class Answer>
Run<Answer> sort_of_x(const Scene& scene)
{
  return [unsorted = x_coordinates(scene)] {
    std::vector<double> x = unsorted;
    std::sort(x.begin(), x.end());
    return Answer();
  };
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_SORT_OF_X_H
