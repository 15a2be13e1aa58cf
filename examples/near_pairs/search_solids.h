// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for pairs of solids, which takes long to compile.

#ifndef NEAR_PAIRS_SEARCH_SOLIDS_H
#define NEAR_PAIRS_SEARCH_SOLIDS_H

#include "bound.h"
#include "feature.h"
#include "locked_functor.h"

#include <vector>

namespace near_pairs {

// Searches the solids of one set, or those of the first against those of the second. Returns false
// iff the search was stopped.
bool report_solid_pairs(const std::vector<std::vector<Feature>>& sets, const Exact_bound& bound,
                        const Search_options& options, const Pair_functor& functor);

} // namespace near_pairs

#endif // NEAR_PAIRS_SEARCH_SOLIDS_H
