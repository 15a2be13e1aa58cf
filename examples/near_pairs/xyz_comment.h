// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The comment line of a frame of .xyz, which tells what its numbers are if it is extended XYZ.

#ifndef NEAR_PAIRS_XYZ_COMMENT_H
#define NEAR_PAIRS_XYZ_COMMENT_H

#include <optional>
#include <string>
#include <vector>

namespace near_pairs {

// The values of the keys that points depend on, without their quotes. Other keys only have to be
// written as the specification of extended XYZ says.
struct Xyz_comment
{
  std::optional<std::string> properties, lattice, pbc;
};

// The comment of plain .xyz is any text, and tells nothing. A text that names one of the keys, with
// an equals sign behind it, is meant as extended XYZ: throws Error, with the column, if it is none.
Xyz_comment parse_comment(const std::string& text);

// The words of a value that is a list or a list of lists, in brackets or without, separated by
// blanks or by commas. Throws Error if it is not.
std::vector<std::vector<std::string>> rows_of(const std::string& value);

} // namespace near_pairs

#endif // NEAR_PAIRS_XYZ_COMMENT_H
