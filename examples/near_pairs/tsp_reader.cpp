// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// TSPLIB; see tsp_reader.h.

#include "tsp_reader.h"

#include "decimal.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace near_pairs {
namespace {

// The key of a line of the head, or the name of a section, in lower case.
std::string key_of(const std::string& line)
{
  return lower_case(std::string(trimmed(line.substr(0, line.find(':')))));
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// What TSPLIB 95 makes of 38.59, which is 38 degrees and 59 minutes. What is beyond the doubles
// stays as it is, for the message about it.
std::string degrees_of(const std::string& text)
{
  const double value = nearest_double(text), degrees = std::trunc(value);
  return std::isfinite(value) ? shortest_text(degrees + (value - degrees) * 5 / 3) : text;
}

} // namespace

Tsp_reader::Tsp_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  read_head();
  take_line();
  const std::size_t words_of_first = words(line_, 5).size();
  dimension = ends_with(weight_type_, "_3d") || (weight_type_.empty() && words_of_first == 4)
                ? 3 : 2;
  words_per_node_ = 1 + dimension;
  if(options.dimension > dimension)
    throw error("the nodes have no third coordinate");
  if(options.dimension != 0 && !options.geographic)
    dimension = options.dimension;
  if(weight_type_ != "geo")
    return;
  if(!options.geographic)
    throw error("the nodes are degrees and minutes (EDGE_WEIGHT_TYPE GEO); --geographic puts them "
                "on a sphere");
  latitude_axis = 0;
  names = {"latitude", "longitude", ""};
}

bool Tsp_reader::next(Row& row)
{
  const std::string key = key_of(line_);
  if(!more_ || key == "eof" || key == "-1" || ends_with(key, "_section")) {
    check_end();
    return false;
  }
  const std::vector<std::string> texts = words(line_, words_per_node_ + 1);
  if(texts.size() != words_per_node_)
    throw error("a node has " + plural(words_per_node_, "word") + ", and this line has not");
  if(!parse_count(texts.front()))
    throw error("'" + texts.front() + "' is no number of a node");
  row.line = lines_.number();
  std::copy_n(texts.begin() + 1, dimension, row.coordinates.begin());
  for(int axis = 0; latitude_axis != -1 && axis < dimension; ++axis)
    if(parse_decimal(row.coordinates[axis]))
      row.coordinates[axis] = degrees_of(row.coordinates[axis]);
  ++count_;
  take_line();
  return true;
}

void Tsp_reader::read_head()
{
  bool is_in_section = false; // of other data than the nodes
  for(take_line(); more_; take_line()) {
    const std::string key = key_of(line_);
    const std::size_t colon = line_.find(':');
    if(key == "node_coord_section")
      return;
    if(key == "eof")
      break;
    is_in_section = ends_with(key, "_section") || (is_in_section && colon == std::string::npos);
    if(is_in_section)
      continue;
    if(colon == std::string::npos)
      throw error("neither 'KEY : value' nor a section");
    read_value(key, std::string(trimmed(line_.substr(colon + 1))));
  }
  throw Error(lines_.file(), "no NODE_COORD_SECTION");
}

void Tsp_reader::read_value(const std::string& key, const std::string& value)
{
  if(key == "edge_weight_type")
    weight_type_ = lower_case(value);
  if(key != "dimension")
    return;
  promised_ = parse_count(value);
  if(!promised_)
    throw error("DIMENSION: '" + value + "' is no count");
}

// Takes the next line that is not blank.
void Tsp_reader::take_line()
{
  do
    more_ = lines_.next(line_);
  while(more_ && words(line_, 1).empty());
}

// Behind EOF there is nothing, and behind the nodes there may be other sections.
void Tsp_reader::check_end()
{
  if(promised_ && count_ != *promised_)
    throw error(plural(count_, "node") + " where DIMENSION says " + std::to_string(*promised_));
  if(!more_ || key_of(line_) != "eof")
    return;
  take_line();
  if(more_)
    throw error("there is text behind EOF");
}

Error Tsp_reader::error(const std::string& what) const
{
  return Error(lines_.file(), lines_.number(), what);
}

} // namespace near_pairs
