// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points or atoms in .xyz; see xyz_reader.h.

#include "xyz_reader.h"

#include "error.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace near_pairs {
namespace {

const char* const blank_letters = " \t";

// The value of a key among words key=value, where a value may have quotes around it. It is empty if
// there is no such key.
std::string value_of(const std::string& comment, const std::string& wanted)
{
  for(std::size_t end = 0; ; ) {
    const std::size_t begin = comment.find_first_not_of(blank_letters, end);
    if(begin == std::string::npos)
      return "";
    end = std::min(comment.find_first_of(" \t=", begin), comment.size());
    const std::string key = comment.substr(begin, end - begin);
    if(end == comment.size() || comment[end] != '=')
      continue;
    std::size_t value = end + 1;
    const bool is_quoted = value < comment.size() && comment[value] == '"';
    value += is_quoted;
    end = std::min(comment.find_first_of(is_quoted ? "\"" : blank_letters, value), comment.size());
    if(key == wanted)
      return comment.substr(value, end - value);
    end = std::min(end + 1, comment.size());
  }
}

} // namespace

Xyz_reader::Xyz_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
  words_ = dimension;
  is_held_ = take_line();
  if(!is_held_)
    return;
  const std::vector<std::string> texts = words(line_, 2);
  if(texts.size() == 1)
    promised_ = parse_count(texts.front());
  if(promised_)
    read_head();
}

// Takes the next line that is neither blank nor a comment.
bool Xyz_reader::take_line()
{
  while(lines_.next(line_)) {
    const std::vector<std::string> texts = words(line_, 1);
    if(!texts.empty() && texts.front().front() != '#')
      return true;
  }
  return false;
}

void Xyz_reader::read_head()
{
  is_held_ = false;
  lines_.next(comment_);
  line_of_comment_ = lines_.number();
  const std::string properties = value_of(comment_, "Properties");
  read_properties(properties.empty() ? "species:S:1:pos:R:3" : properties);
}

// A list of a name, a letter for the type and the number of words, for each property of an atom.
void Xyz_reader::read_properties(const std::string& properties)
{
  std::istringstream list(properties);
  std::size_t column = 0;
  bool has_place = false;
  for(std::string name, type, text; std::getline(list, name, ':'); ) {
    std::getline(list, type, ':');
    std::getline(list, text, ':');
    const auto count = parse_count(text);
    if(!count || *count > 1000)
      throw Error(lines_.file(), line_of_comment_, "Properties: '" + text + "' is no count");
    if(name == "pos" && *count >= std::size_t(dimension)) {
      has_place = true;
      first_ = column;
      words_ = std::max(words_, column + dimension);
    }
    if(name == "species" && *count == 1) {
      has_ids = true;
      element_ = column;
      words_ = std::max(words_, column + 1);
    }
    column += *count;
  }
  if(!has_place)
    throw Error(lines_.file(), line_of_comment_, "Properties: no pos of "
                + plural(dimension, "coordinate"));
}

bool Xyz_reader::next(Row& row)
{
  if(promised_ == atoms_)
    return false;
  if(!is_held_ && !(promised_ ? lines_.next(line_) : take_line())) {
    if(promised_)
      throw Error(lines_.file(), "the file ends after " + plural(atoms_, "atom") + " of "
                  + std::to_string(*promised_));
    return false;
  }
  is_held_ = false;
  const std::vector<std::string> texts = words(line_, words_);
  row.line = lines_.number();
  if(texts.size() < words_)
    throw Error(lines_.file(), row.line, plural(texts.size(), promised_ ? "word" : "number")
                + " where " + std::to_string(words_) + " are needed");
  std::copy_n(texts.begin() + static_cast<std::ptrdiff_t>(first_), dimension,
              row.coordinates.begin());
  if(has_ids)
    row.id = texts[element_];
  ++atoms_;
  return true;
}

std::optional<Cell> Xyz_reader::cell() const
{
  const std::string lattice = value_of(comment_, "Lattice");
  if(lattice.empty())
    return std::nullopt;
  return lattice_cell(lattice, value_of(comment_, "pbc"));
}

} // namespace near_pairs
