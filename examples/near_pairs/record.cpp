// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The fields of a record; see record.h.

#include "record.h"

#include "decimal.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace near_pairs {
namespace {

bool is_separator(char letter, char separator)
{
  return letter == separator || (separator == blanks && letter == '\t');
}

// The place of the next separator, or the end.
std::size_t find_separator(const std::string& record, char separator, std::size_t position)
{
  const std::size_t place = separator == blanks ? record.find_first_of(" \t", position)
                                                : record.find(separator, position);
  return std::min(place, record.size());
}

std::size_t behind_blanks(const std::string& record, std::size_t position)
{
  return std::min(record.find_first_not_of(" \t", position), record.size());
}

// Takes one field off the record at `position`, which is moved behind it (to its separator or the
// end; beyond the end if a quote is not closed).
std::string take_field(const std::string& record, char separator, std::size_t& position)
{
  if(position == record.size() || record[position] != '"') {
    const std::size_t end = find_separator(record, separator, position);
    const std::string field(trimmed(std::string_view(record).substr(position, end - position)));
    position = end;
    return field;
  }
  std::string field;
  while(true) {
    const std::size_t quote = record.find('"', ++position);
    if(quote == std::string::npos) {
      position = record.size() + 1;
      return field;
    }
    field.append(record, position, quote - position);
    position = quote + 1;
    if(position == record.size() || record[position] != '"')
      return field;
    field.push_back('"');
  }
}

} // namespace

char found_separator(const std::string& record, const std::string& candidates)
{
  std::vector<std::size_t> counts(candidates.size());
  bool is_quoted = false;
  for(char letter : record) {
    is_quoted ^= letter == '"';
    const std::size_t candidate = is_quoted ? std::string::npos : candidates.find(letter);
    if(candidate != std::string::npos)
      ++counts[candidate];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return *most == 0 ? blanks : candidates[most - counts.begin()];
}

bool has_odd_quotes(const std::string& line)
{
  return std::count(line.begin(), line.end(), '"') % 2 != 0;
}

bool split_record(const std::string& record, char separator, std::vector<std::string>& fields)
{
  fields.clear();
  std::size_t position = separator == blanks ? behind_blanks(record, 0) : 0;
  while(true) {
    fields.push_back(take_field(record, separator, position));
    if(position < record.size() && !is_separator(record[position], separator))
      return false;
    if(separator == blanks && position < record.size()) {
      position = behind_blanks(record, position);
      if(position == record.size())
        return true;
      continue;
    }
    if(position >= record.size())
      return position == record.size();
    ++position;
  }
}

} // namespace near_pairs
