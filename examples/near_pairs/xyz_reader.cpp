// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points or atoms in .xyz; see xyz_reader.h.

#include "xyz_reader.h"

#include "decimal.h"
#include "error.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <vector>

namespace near_pairs {
namespace {

// Fortran writes 1.0D-3, which extended XYZ allows.
std::string without_fortran(const std::string& word)
{
  const std::size_t letter = word.find_first_of("dD");
  if(letter == std::string::npos)
    return word;
  const std::string number = std::string(word).replace(letter, 1, 1, 'e');
  return parse_decimal(number) ? number : word;
}

// The words of the value of a key, which is a list or a square of lists.
std::vector<std::string> words_of(const std::string& key, const std::string& value)
{
  try {
    std::vector<std::string> result;
    const std::vector<std::vector<std::string>> rows = rows_of(value);
    if(rows.size() != 1 && rows.size() != rows.front().size())
      throw Error("there are not as many lists as words in each of them");
    for(const std::vector<std::string>& row : rows)
      std::transform(row.begin(), row.end(), std::back_inserter(result), without_fortran);
    return result;
  }
  catch(const Error& error) {
    throw Error(key + ": " + error.what());
  }
}

} // namespace

Xyz_reader::Xyz_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
  frame.number = options.frame;
  words_ = dimension;
  is_held_ = take_line();
  if(!is_held_)
    throw Error(input.name(), "is empty");
  const std::vector<std::string> texts = words(line_, 2);
  has_frames_ = texts.size() == 1 && parse_count(texts.front());
  if(!has_frames_)
    return;
  frame.count = 0;
  while(take_head() && frame.count < frame.number)
    skip_atoms();
  if(frame.count == frame.number)
    read_comment();
}

// Takes the next line that is neither blank nor a comment.
bool Xyz_reader::take_line()
{
  while(!is_held_ && lines_.next(line_)) {
    const std::vector<std::string> texts = words(line_, 1);
    is_held_ = !texts.empty() && texts.front().front() != '#';
  }
  return is_held_;
}

// Takes the count and the comment of the next frame. Returns false at the end of the file.
bool Xyz_reader::take_head()
{
  if(!take_line())
    return false;
  is_held_ = false;
  const std::vector<std::string> texts = words(line_, 2);
  const auto count = parse_count(texts.front());
  if(texts.size() != 1 || !count)
    throw Error(lines_.file(), lines_.number(), "'" + line_ + "' behind the "
                + plural(promised_, "atom") + " of frame " + std::to_string(frame.count)
                + ", where the count of another frame may be");
  ++frame.count;
  promised_ = *count;
  atoms_ = 0;
  text_.clear();
  lines_.next(text_);
  return true;
}

void Xyz_reader::read_comment()
{
  line_of_cell = lines_.number();
  try {
    comment_ = parse_comment(text_);
    may_have_more_ = !comment_.properties;
    read_properties(comment_.properties.value_or("species:S:1:pos:R:3"));
  }
  catch(const Error& error) {
    throw Error(lines_.file(), lines_.number(), error.what());
  }
}

// A list of a name, a letter for the type and the number of words, for each property of an atom.
void Xyz_reader::read_properties(const std::string& properties)
{
  std::istringstream list(properties);
  words_ = 0;
  bool has_place = false;
  for(std::string name, type, text; std::getline(list, name, ':'); ) {
    std::getline(list, type, ':');
    std::getline(list, text, ':');
    const auto count = parse_count(text);
    if(!count || *count == 0 || *count > 1000)
      throw Error("Properties: '" + text + "' is no count");
    if(type.size() != 1 || std::string("SIRL").find(type) == std::string::npos)
      throw Error("Properties: '" + type + "' is no type, which is S, I, R or L");
    if((name == "pos" && has_place) || (name == "species" && has_ids))
      throw Error("Properties: " + name + " is there twice");
    if(name == "pos" && *count >= std::size_t(dimension)) {
      has_place = true;
      first_ = words_;
    }
    if(name == "species" && *count == 1) {
      has_ids = true;
      element_ = words_;
    }
    words_ += *count;
  }
  if(!has_place)
    throw Error("Properties: no pos of " + plural(dimension, "coordinate"));
}

bool Xyz_reader::next(Row& row)
{
  if(!(has_frames_ ? take_atom_of_frame() : take_line())) {
    require_frame(lines_.file());
    return false;
  }
  is_held_ = false;
  read_row(row);
  return true;
}

// Takes the next atom of the frame that is read. Behind the last one, it goes on to the end of the
// file, for the count of frames.
bool Xyz_reader::take_atom_of_frame()
{
  if(frame.count == frame.number && atoms_ < promised_) {
    take_atom();
    return true;
  }
  while(take_head())
    skip_atoms();
  return false;
}

void Xyz_reader::skip_atoms()
{
  while(atoms_ < promised_)
    take_atom();
}

void Xyz_reader::take_atom()
{
  if(!lines_.next(line_))
    throw Error(lines_.file(), lines_.number(), "the file ends after " + plural(atoms_, "atom")
                + " of " + std::to_string(promised_));
  ++atoms_;
}

void Xyz_reader::read_row(Row& row) const
{
  const std::vector<std::string> texts = words(line_, words_ + 1);
  row.line = lines_.number();
  if(texts.size() < words_)
    throw Error(lines_.file(), row.line, plural(texts.size(), has_frames_ ? "word" : "number")
                + " where " + std::to_string(words_) + " are needed");
  if(texts.size() > words_ && !may_have_more_)
    throw Error(lines_.file(), row.line, "more than the " + plural(words_, "word")
                + " of Properties");
  for(int axis = 0; axis < dimension; ++axis)
    row.coordinates[axis] = without_fortran(texts[first_ + axis]);
  if(has_ids)
    row.id = texts[element_];
}

std::optional<Cell> Xyz_reader::cell() const
{
  if(!comment_.lattice)
    return std::nullopt;
  return lattice_cell(words_of("Lattice", *comment_.lattice),
                      comment_.pbc ? words_of("pbc", *comment_.pbc) : std::vector<std::string>{});
}

} // namespace near_pairs
