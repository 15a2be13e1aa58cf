// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Molecules in the format PDB; see pdb_reader.h.

#include "pdb_reader.h"

#include "decimal.h"
#include "error.h"
#include "text.h"

#include <string_view>

namespace near_pairs {
namespace {

// Whether a line has the serial number of an atom at once behind ATOM or HETATM, or blanks: large
// numbers begin early, and end late.
bool is_atom(const std::string& line)
{
  return (line.compare(0, 4, "ATOM") == 0 && line.find_first_not_of(" 0123456789", 4) != 4)
         || line.compare(0, 6, "HETATM") == 0;
}

bool is_of_number(char letter)
{
  return letter == '.' || (letter >= '0' && letter <= '9');
}

// Whether a line is that of an atom, but not as the format has it.
bool is_misspelt_atom(const std::string& line)
{
  const std::string word = lower_case(std::string(trimmed(line.substr(0, 8))));
  return word.compare(0, 4, "atom") == 0 || word.compare(0, 6, "hetatm") == 0;
}

// The number in these columns, which are counted from 0. Lines may be shifted, as those of a long
// serial number often are: then the point is not where it should be, and digits may be outside.
std::string number_in(const std::string& line, std::size_t begin, std::size_t width,
                      std::size_t decimals)
{
  const std::size_t end = begin + width;
  const auto cuts = [&](std::size_t at) {
    return at < line.size() && (is_of_number(line[at - 1]) || line[at - 1] == '-')
           && is_of_number(line[at]);
  };
  if(line[end - decimals - 1] != '.' && (cuts(begin) || cuts(end)))
    throw Error("columns " + std::to_string(begin + 1) + " to " + std::to_string(end)
                + " have a part of a number, so the line is shifted");
  return std::string(trimmed(std::string_view(line).substr(begin, width)));
}

} // namespace

Pdb_reader::Pdb_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
  frame.number = options.frame;
  frame.count = 0;
  unit = "\u00C5";
  has_ids = true;
}

bool Pdb_reader::next(Row& row)
{
  while(lines_.next(line_)) {
    const std::string_view name = trimmed(std::string_view(line_).substr(0, 6));
    if(name == "MODEL" || name == "ENDMDL" || name == "END")
      is_in_model_ = false;
    else if(is_atom(line_)) {
      if(!takes_atom())
        continue;
      read_atom(row);
      return true;
    }
    else if(is_misspelt_atom(line_))
      throw Error(lines_.file(), lines_.number(), "the line of an atom begins with ATOM or HETATM");
    else if(frame.count + !is_in_model_ <= frame.number)
      take_cell(name);
  }
  if(frame.count == 0)
    throw Error(lines_.file(), "no line of an atom, which begins with ATOM or HETATM");
  require_frame(lines_.file());
  return false;
}

void Pdb_reader::take_cell(std::string_view name)
{
  if(name == "CRYST1") {
    crystal_ = line_;
    line_of_cell = lines_.number();
    scale_.fill("");
  }
  if(name == "SCALE1" || name == "SCALE2" || name == "SCALE3")
    scale_[name.back() - '1'] = line_;
}

// Whether the atom in hand, which may be the first one of a model, is of the one that is read.
bool Pdb_reader::takes_atom()
{
  frame.count += !is_in_model_;
  is_in_model_ = true;
  return frame.count == frame.number;
}

void Pdb_reader::read_atom(Row& row) const
{
  const std::size_t x = 30, width = 8, decimals = 3, name = 12; // columns, from 0
  row.line = lines_.number();
  if(line_.size() < x + 3 * width)
    throw Error(lines_.file(), row.line,
                "the line of an atom ends before column 54, and its coordinates do not");
  try {
    for(int axis = 0; axis < dimension; ++axis)
      row.coordinates[axis] = number_in(line_, x + axis * width, width, decimals);
  }
  catch(const Error& error) {
    throw Error(lines_.file(), row.line, error.what());
  }
  const std::size_t serial = line_[0] == 'A' ? 4 : 6;
  row.id = trimmed(std::string_view(line_).substr(serial, name - serial));
}

// The numbers of SCALE1, SCALE2 and SCALE3, or none.
std::vector<std::string> Pdb_reader::fractions() const
{
  std::vector<std::string> result;
  if(scale_ == std::array<std::string, 3>())
    return result;
  const std::size_t begin = 10, width = 10, decimals = 6; // columns, from 0
  for(const std::string& line : scale_) {
    if(line.size() < begin + 3 * width)
      throw Error("SCALE: one of three lines is missing or ends before column 40");
    for(std::size_t axis = 0; axis < 3; ++axis)
      result.push_back(number_in(line, begin + axis * width, width, decimals));
  }
  return result;
}

std::optional<Cell> Pdb_reader::cell() const
{
  if(crystal_.empty())
    return std::nullopt;
  const std::size_t side = 6, side_width = 9, angle_width = 7, group_width = 11;
  const std::size_t angle = side + 3 * side_width, group = angle + 3 * angle_width + 1;
  if(crystal_.size() < group - 1)
    throw Error("CRYST1: the line ends before column 54, and its angles do not");
  Crystal crystal;
  for(std::size_t k = 0; k < 3; ++k) {
    crystal.sides[k] = number_in(crystal_, side + k * side_width, side_width, 3);
    crystal.degrees[k] = number_in(crystal_, angle + k * angle_width, angle_width, 2);
  }
  if(crystal_.size() > group)
    crystal.space_group = trimmed(std::string_view(crystal_).substr(group, group_width));
  crystal.fractions = fractions();
  return crystal_cell(crystal, "CRYST1");
}

} // namespace near_pairs
