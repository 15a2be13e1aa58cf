// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The drawing of solids as SVG, from above and from the front: their outlines and their sharp
// edges. Those in pairs have the color of a pair.

#ifndef NEAR_PAIRS_SOLID_PICTURE_H
#define NEAR_PAIRS_SOLID_PICTURE_H

#include "feature.h"
#include "options.h"

#include <cstddef>
#include <ostream>
#include <vector>

namespace near_pairs {

void draw_solids(std::ostream& svg, const std::vector<std::vector<Feature>>& sets,
                 const std::vector<std::vector<bool>>& in_pairs, const Options& options,
                 std::size_t pairs);

} // namespace near_pairs

#endif // NEAR_PAIRS_SOLID_PICTURE_H
