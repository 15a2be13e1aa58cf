// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The columns of the table of sizes: methods that report all intersecting pairs of rectangles,
// cuboids or balls, ours and others.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_COLUMNS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_COLUMNS_H

#include "columns.h"

#include "measuring/Tally.h"
#include "scenes/Object_scene.h"

#include <functional>
#include <vector>

namespace lab {

// A search that stores its pairs, and the same search that counts them, for its time: to store a
// pair takes longer than to find it.
struct Object_column : Column_for<Object_scene>
{
  std::function<Run<Tally>(const Object_scene&)> prepare_count;
};

// In the order in which the table has them. Columns about the rounding of balls are for balls only.
std::vector<Object_column> object_columns(Shape shape);

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_COLUMNS_H
