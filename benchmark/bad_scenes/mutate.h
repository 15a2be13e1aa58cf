// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Random changes of recipes.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_MUTATE_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_MUTATE_H

#include "bad_scenes/Recipe.h"

#include <random>

namespace thick_benchmark {

// Makes one to three random changes of a recipe for objects of some dimension. They may take the
// changes of `other` as well.
Recipe mutate(Recipe recipe, const Recipe& other, int dimension, std::mt19937_64& random);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_MUTATE_H
