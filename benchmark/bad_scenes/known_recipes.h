// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes that were bad once.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_KNOWN_RECIPES_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_KNOWN_RECIPES_H

#include "bad_scenes/Recipe.h"

namespace thick_benchmark {

// Those for some search, with n objects.
std::vector<Recipe> known_recipes(const std::string& search, std::size_t n);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_KNOWN_RECIPES_H
