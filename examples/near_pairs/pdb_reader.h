// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The atoms of a molecule in the format PDB.

#ifndef NEAR_PAIRS_PDB_READER_H
#define NEAR_PAIRS_PDB_READER_H

#include "cell.h"
#include "input.h"
#include "row_reader.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace near_pairs {

// The records ATOM and HETATM of a model, which ends at ENDMDL or END. The serial number of an atom
// is its id. CRYST1 is the cell, and SCALE tells how it is turned. Matrices that make copies of the
// molecule are not looked at. This is not left to the library gemmi, which reads other things at
// once, but takes a coordinate that is no number as 0, and one that is not in its columns by those
// of its digits that are.
class Pdb_reader : public Row_reader
{
public:
  Pdb_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;
  std::optional<Cell> cell() const override;

private:
  void take_cell(std::string_view name);
  bool takes_atom();
  void read_atom(Row& row) const;
  std::vector<std::string> fractions() const;

  Lines lines_;
  std::string line_;
  bool is_in_model_ = false;
  std::string crystal_;              // the line of the cell
  std::array<std::string, 3> scale_; // those of its matrix
};

} // namespace near_pairs

#endif // NEAR_PAIRS_PDB_READER_H
