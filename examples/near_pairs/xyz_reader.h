// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points or atoms in the formats that go by the name .xyz.

#ifndef NEAR_PAIRS_XYZ_READER_H
#define NEAR_PAIRS_XYZ_READER_H

#include "cell.h"
#include "input.h"
#include "row_reader.h"
#include "xyz_comment.h"

#include <cstddef>
#include <optional>
#include <string>

namespace near_pairs {

// The numbers of a point on each line; lines that begin with # and blank lines are skipped. Or, if
// the first line is a count and nothing else, frames: a count, a comment, and so many atoms, each
// with its element and its coordinates. A comment of extended XYZ tells where these are
// (Properties), and the cell (Lattice, pbc). The element of an atom is its id.
class Xyz_reader : public Row_reader
{
public:
  Xyz_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;
  std::optional<Cell> cell() const override;

private:
  bool take_line();
  bool take_head();
  void read_comment();
  void read_properties(const std::string& properties);
  bool take_atom_of_frame();
  void skip_atoms();
  void take_atom();
  void read_row(Row& row) const;

  Lines lines_;
  std::string line_;      // the next one, if it is held
  bool is_held_ = false;
  bool has_frames_ = false;
  std::size_t words_ = 0; // of a row, that are read
  bool may_have_more_ = true; // words, behind them
  std::size_t first_ = 0; // the word that is the first coordinate
  std::size_t element_ = 0;
  std::size_t promised_ = 0; // atoms of the frame in hand
  std::size_t atoms_ = 0;    // of it, up to now
  std::string text_;         // of its comment
  Xyz_comment comment_;      // of the frame that is read
};

} // namespace near_pairs

#endif // NEAR_PAIRS_XYZ_READER_H
