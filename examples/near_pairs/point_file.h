// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Files of points to a scene.

#ifndef NEAR_PAIRS_POINT_FILE_H
#define NEAR_PAIRS_POINT_FILE_H

#include "options.h"
#include "row_numbers.h"
#include "scene.h"

#include <functional>

namespace near_pairs {

// Throws Error, with file and line, if anything in the file cannot be taken at its word.
Scene read_scene(const Options& options);

// The same. Calls `and_then` for each row, when its point is the last one of the scene.
Scene read_scene(const Options& options, const std::function<void(const Place&)>& and_then);

} // namespace near_pairs

#endif // NEAR_PAIRS_POINT_FILE_H
