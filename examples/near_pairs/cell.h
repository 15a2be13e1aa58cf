// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The cell of a scene that repeats: what --periodic and files tell of it.

#ifndef NEAR_PAIRS_CELL_H
#define NEAR_PAIRS_CELL_H

#include "exact_number.h"

#include <array>
#include <string>
#include <vector>

namespace near_pairs {

// How many times each vector of a cell is added to a point. All zeros is the point itself.
using Offset = std::array<int, 3>;

struct Cell
{
  std::vector<std::vector<Exact_number>> vectors; // two in the plane, three in space
  std::array<bool, 3> repeats = {true, true, true};
  bool is_rounded = false; // the vectors are computed from angles
  std::string space_group; // whose copies are not in the file; empty: there are none
};

// Reads two or three sides, or the four or nine numbers of vectors.
Cell parse_cell(const std::string& text);

// Reads the nine numbers of Lattice, or the three sides of a box, and the words of pbc: one for
// each axis or one for all; without them, all axes repeat.
Cell lattice_cell(const std::vector<std::string>& lattice, const std::vector<std::string>& pbc);

// The cell of a crystal as text, as in the files of PDB.
struct Crystal
{
  std::array<std::string, 3> sides, degrees;
  std::string space_group;

  // Nine numbers, or none: the matrix, row after row, that makes fractions of the sides of
  // coordinates. It tells how the cell is turned against the axes.
  std::vector<std::string> fractions;
};

// `what` is what the file calls the cell. The vectors are exact if all angles are right, and the
// cell is not turned.
Cell crystal_cell(const Crystal& crystal, const std::string& what);

// Sides if the cell is a box, or else vectors.
std::string cell_in_words(const Cell& cell);

} // namespace near_pairs

#endif // NEAR_PAIRS_CELL_H
