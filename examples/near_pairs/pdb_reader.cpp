// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Molecules in the format PDB; see pdb_reader.h.

#include "pdb_reader.h"

#include "decimal.h"
#include "error.h"

#include <string_view>

namespace near_pairs {

Pdb_reader::Pdb_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
  unit = "\u00C5";
  has_ids = true;
}

bool Pdb_reader::next(Row& row)
{
  constexpr std::size_t serial = 6, serial_width = 5, x = 30, width = 8; // columns, from 0
  for(std::string line; lines_.next(line); ) {
    const std::string name = line.substr(0, 6);
    if(name == "ENDMDL")
      break;
    if(name == "CRYST1")
      crystal_ = line;
    if(name != "ATOM  " && name != "HETATM")
      continue;
    row.line = lines_.number();
    if(line.size() < x + 3 * width)
      throw Error(lines_.file(), row.line,
                  "the line of an atom ends before column 54, and its coordinates do not");
    for(int axis = 0; axis < dimension; ++axis)
      row.coordinates[axis]
        = trimmed(std::string_view(line).substr(x + axis * width, width));
    row.id = trimmed(std::string_view(line).substr(serial, serial_width));
    has_atoms_ = true;
    return true;
  }
  if(!has_atoms_)
    throw Error(lines_.file(), "no line of an atom, which begins with ATOM or HETATM");
  return false;
}

std::optional<Cell> Pdb_reader::cell() const
{
  if(crystal_.empty())
    return std::nullopt;
  return crystal_cell(crystal_);
}

} // namespace near_pairs
