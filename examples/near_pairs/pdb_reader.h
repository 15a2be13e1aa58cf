// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The atoms of a molecule in the format PDB.

#ifndef NEAR_PAIRS_PDB_READER_H
#define NEAR_PAIRS_PDB_READER_H

#include "cell.h"
#include "input.h"
#include "row_reader.h"

#include <optional>
#include <string>

namespace near_pairs {

// The records ATOM and HETATM, up to the end of the first model. The serial number of an atom is
// its id. CRYST1 is the cell. Matrices that make copies of the molecule are not looked at.
class Pdb_reader : public Row_reader
{
public:
  Pdb_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;
  std::optional<Cell> cell() const override;

private:
  Lines lines_;
  bool has_atoms_ = false;
  std::string crystal_; // the line of the cell
};

} // namespace near_pairs

#endif // NEAR_PAIRS_PDB_READER_H
