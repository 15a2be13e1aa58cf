// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A share of a file of points, for programs of several processes that read a file together.

#ifndef NEAR_PAIRS_FILE_SHARE_H
#define NEAR_PAIRS_FILE_SHARE_H

#include <array>
#include <string>
#include <vector>

namespace near_pairs {

// Reads part `part` of `part_count` parts of the file. The parts follow each other in the file, and
// have about as many bytes each.
//
// A .bin file has three doubles per point, least byte first. Any other file has a point on each
// line, as two or three decimals with commas, semicolons, tabs or blanks between them. Blank lines
// and lines that begin with # are skipped, and so is the first line if it has no number.
//
// Throws Error if the file cannot be read, or if something in the part cannot be taken at its word.
// That the file has no point at all is for the caller to see.
std::vector<std::array<double, 3>> read_share(const std::string& file, int part, int part_count);

} // namespace near_pairs

#endif // NEAR_PAIRS_FILE_SHARE_H
