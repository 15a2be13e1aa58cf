// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Features as an SVG drawing, in the plane of the file; those in a pair stand out.

#ifndef NEAR_PAIRS_FEATURE_PICTURE_H
#define NEAR_PAIRS_FEATURE_PICTURE_H

#include "feature.h"
#include "options.h"

#include <cstddef>
#include <ostream>
#include <vector>

namespace near_pairs {

// `in_pairs` tells of each feature of each file whether it is in a pair.
void draw_features(std::ostream& svg, const std::vector<std::vector<Feature>>& files,
                   const std::vector<std::vector<bool>>& in_pairs, const Options& options,
                   std::size_t pairs);

} // namespace near_pairs

#endif // NEAR_PAIRS_FEATURE_PICTURE_H
