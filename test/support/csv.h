// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Comma-separated lines, with fields that may be quoted; a quote inside quotes is doubled.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CSV_H
#define THICK_INTERSECTION_TEST_SUPPORT_CSV_H

#include "standard_library.h"

#include <fstream>

namespace test_support {

inline std::vector<std::string> split_csv_line(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for(std::size_t i = 0; i < line.size(); ++i) {
    if(line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if(line[i] == '"')
      is_quoted = !is_quoted;
    else if(line[i] == ',' && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  return fields;
}

// The lines of a text file, without their ends.
inline std::vector<std::string> read_lines(const std::string& path)
{
  std::ifstream in(path);
  if(!in)
    throw std::runtime_error("cannot read " + path);
  std::vector<std::string> lines;
  for(std::string line; std::getline(in, line);) {
    if(!line.empty() && line.back() == '\r')
      line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

// A table with its column names in the first line.
class Csv_table
{
public:
  explicit Csv_table(const std::string& path)
  {
    for(const std::string& line : read_lines(path))
      rows_.push_back(split_csv_line(line));
    if(rows_.empty())
      throw std::runtime_error("no header in " + path);
    header_ = rows_.front();
    rows_.erase(rows_.begin());
  }

  std::size_t column(const std::string& name) const
  {
    const auto found = std::find(header_.begin(), header_.end(), name);
    if(found == header_.end())
      throw std::runtime_error("no column " + name);
    return static_cast<std::size_t>(found - header_.begin());
  }

  const std::vector<std::vector<std::string>>& rows() const { return rows_; }

  // The named columns, in the order of the names.
  std::vector<std::vector<std::string>> columns(const std::vector<std::string>& names) const
  {
    std::vector<std::vector<std::string>> selection(rows_.size());
    for(const std::string& name : names)
      for(std::size_t i = 0, c = column(name); i < rows_.size(); ++i)
        selection[i].push_back(rows_[i].at(c));
    return selection;
  }

private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CSV_H
