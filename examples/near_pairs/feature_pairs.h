// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for pairs of features that are within a distance of each other, or that intersect, or
// for pairs of polygons that overlap. Solids are features in space.

#ifndef NEAR_PAIRS_FEATURE_PAIRS_H
#define NEAR_PAIRS_FEATURE_PAIRS_H

#include "feature.h"
#include "options.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace near_pairs {

// Receives each pair once, as positions in the files. It is never called by two threads at once.
using Feature_pair_sink = std::function<void(std::size_t i, std::size_t j)>;

// Searches the features of one file, or those of the first against those of the second. This calls
// the library, and takes long to compile.
void search_features(const std::vector<std::vector<Feature>>& files, const Options& options,
                     const Feature_pair_sink& sink);

// Whether rounding of decimals to doubles may have moved pairs over the bound, within which so many
// were found: a longer bound has more, or a shorter one has fewer if the bound is open.
bool has_moved_ties(const std::vector<std::vector<Feature>>& files, const Options& options,
                    std::size_t pairs);

// Whether one of the files has features, or solids.
bool have_features(const Options& options);

// Reads, searches, writes the pairs and the picture if they are wanted, and prints the summary.
void run_features(const Options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_FEATURE_PAIRS_H
