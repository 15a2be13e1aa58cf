// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The atoms of a molecule in the format mmCIF, which is one of CIF.

#ifndef NEAR_PAIRS_CIF_READER_H
#define NEAR_PAIRS_CIF_READER_H

#include "cell.h"
#include "input.h"
#include "row_reader.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace near_pairs {

// The category atom_site, whose Cartn_x, Cartn_y and Cartn_z are the coordinates, and whose id is
// that of an atom. Each model of each data block with atoms is a frame. The category cell of the
// block is the cell. The file is kept in memory, as are the atoms.
class Cif_reader : public Row_reader
{
public:
  Cif_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;
  std::optional<Cell> cell() const override;

private:
  std::vector<Row> rows_;
  std::size_t next_ = 0;
  std::optional<Crystal> crystal_;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_CIF_READER_H
