// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes in the format OFF; see off_reader.h.

#include "off_reader.h"

#include "error.h"

#include <algorithm>

namespace near_pairs {
namespace {

bool is_keyword(std::string word)
{
  for(const std::string prefix : {"ST", "C", "N"})
    if(word.compare(0, prefix.size(), prefix) == 0)
      word.erase(0, prefix.size());
  return word == "OFF";
}

} // namespace

Off_reader::Off_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
  read_head();
}

bool Off_reader::next(Row& row)
{
  if(count_ == promised_)
    return false;
  std::vector<std::string> texts;
  if(!next_words(texts, 3))
    throw Error(lines_.file(), lines_.number(), "the file ends after vertex "
                + std::to_string(count_) + " of " + std::to_string(promised_));
  row.line = lines_.number();
  if(texts.size() < 3)
    throw Error(lines_.file(), row.line, plural(texts.size(), "number") + " where 3 are needed");
  std::copy_n(texts.begin(), dimension, row.coordinates.begin());
  ++count_;
  return true;
}

void Off_reader::read_head()
{
  std::vector<std::string> head, texts;
  while(head.size() < 4 && next_words(texts, 5))
    head.insert(head.end(), texts.begin(), texts.end());
  if(head.empty() || !is_keyword(head.front()))
    throw Error(lines_.file(), "does not begin with OFF, COFF, NOFF, CNOFF, or ST before them");
  const bool are_counts = head.size() == 4 &&
    std::all_of(head.begin() + 1, head.end(), [](const auto& text) { return parse_count(text); });
  if(!are_counts)
    throw Error(lines_.file(), lines_.number(), head.front() + " is not followed by the numbers of "
                "vertices, faces and edges");
  promised_ = *parse_count(head[1]);
}

// Reads the first words of the next line that has any.
bool Off_reader::next_words(std::vector<std::string>& texts, std::size_t most)
{
  for(std::string line; lines_.next(line); ) {
    line.erase(std::min(line.find('#'), line.size()));
    texts = words(line, most);
    if(!texts.empty())
      return true;
  }
  return false;
}

} // namespace near_pairs
