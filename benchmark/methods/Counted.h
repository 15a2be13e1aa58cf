// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A way to the pairs of a scene that tells how many there are.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_COUNTED_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_COUNTED_H

#include <cstddef>
#include <functional>
#include <string>

namespace thick_benchmark {

struct Counted
{
  std::string name;
  std::function<std::size_t()> count; // searches anew in each call
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_COUNTED_H
