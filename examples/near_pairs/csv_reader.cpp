// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Comma-separated values; see csv_reader.h.

#include "csv_reader.h"

#include "decimal.h"
#include "error.h"

#include <algorithm>
#include <cctype>

namespace near_pairs {
namespace {

std::string lower_case(std::string text)
{
  for(char& letter : text)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

// Takes one field off the record at `position`, which is moved behind it (to its comma or the end;
// beyond the end if a quote is not closed).
std::string take_field(const std::string& record, std::size_t& position)
{
  if(position == record.size() || record[position] != '"') {
    const std::size_t end = std::min(record.find(',', position), record.size());
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

bool has_odd_quotes(const std::string& line)
{
  return std::count(line.begin(), line.end(), '"') % 2 != 0;
}

// Cuts a record into its fields; returns false if a quoted field does not end at a comma.
bool split(const std::string& record, std::vector<std::string>& fields)
{
  fields.clear();
  for(std::size_t position = 0; ; ++position) {
    fields.push_back(take_field(record, position));
    if(position == record.size())
      return true;
    if(position > record.size() || record[position] != ',')
      return false;
  }
}

std::string joined(const std::vector<std::string>& names)
{
  std::string list;
  for(const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

} // namespace

Csv_reader::Csv_reader(const Options& options)
  : lines_(options.file)
{
  if(!next_record(header_))
    throw Error(options.file, "is empty");
  choose_columns(options);
  dimension = static_cast<int>(columns_.size());
  for(std::size_t axis = 0; axis < columns_.size(); ++axis)
    names[axis] = header_[columns_[axis]];
  has_ids = find_column("id", id_column_);
}

bool Csv_reader::next(Row& row)
{
  if(!next_record(fields_))
    return false;
  row.line = first_line_;
  if(fields_.size() != header_.size())
    throw Error(lines_.file(), row.line, std::to_string(fields_.size()) + " fields, but the header "
                "has " + std::to_string(header_.size()));
  for(std::size_t axis = 0; axis < columns_.size(); ++axis)
    row.coordinates[axis] = fields_[columns_[axis]];
  if(has_ids)
    row.id = fields_[id_column_];
  return true;
}

// Reads the next record that is not blank; a line end inside quotes is part of it.
bool Csv_reader::next_record(std::vector<std::string>& fields)
{
  std::string record;
  do {
    if(!lines_.next(record))
      return false;
  } while(trimmed(record).empty());
  first_line_ = lines_.number();
  // Each line is looked at once, so that a stray quote costs no more than any other letter.
  bool is_open = has_odd_quotes(record);
  for(std::string line; is_open; is_open ^= has_odd_quotes(line)) {
    if(!lines_.next(line))
      throw Error(lines_.file(), first_line_, "a quote is not closed");
    record.append(1, '\n').append(line);
  }
  if(!split(record, fields))
    throw Error(lines_.file(), first_line_, "a quoted field does not end at a comma");
  return true;
}

void Csv_reader::choose_columns(const Options& options)
{
  for(const std::string& name : options.columns)
    columns_.push_back(named_column(name));
  if(!columns_.empty())
    return;
  if(options.geographic ? find_degree_columns(true)
                        : find_plane_columns(options.dimension) ||
                          (options.dimension != 3 && find_degree_columns(false)))
    return;
  const std::string wanted = options.geographic ? "lat* and lon*"
                           : options.dimension == 3 ? "x, y, z" : "x, y or lat*, lon*";
  throw Error(lines_.file(), first_line_, "no columns " + wanted + "; choose with --columns among "
              + joined(header_));
}

std::size_t Csv_reader::named_column(const std::string& name) const
{
  std::size_t column = 0;
  if(find_column(name, column))
    return column;
  const bool is_number = !name.empty() && name.size() < 6 &&
                         name.find_first_not_of("0123456789") == std::string::npos;
  if(is_number && std::stoul(name) >= 1 && std::stoul(name) <= header_.size())
    return std::stoul(name) - 1;
  throw Error(lines_.file(), first_line_, "no column '" + name + "' among " + joined(header_));
}

bool Csv_reader::find_column(const std::string& name, std::size_t& column) const
{
  const auto is_it = [&](const std::string& other) {
    return lower_case(other) == lower_case(name);
  };
  column = std::find_if(header_.begin(), header_.end(), is_it) - header_.begin();
  return column < header_.size();
}

bool Csv_reader::find_column_beginning_with(const std::string& prefix, std::size_t& column) const
{
  const auto is_it = [&](const std::string& name) {
    return lower_case(name).compare(0, prefix.size(), prefix) == 0;
  };
  column = std::find_if(header_.begin(), header_.end(), is_it) - header_.begin();
  return column < header_.size();
}

// Takes x, y and, if it exists and is wanted (0: yes), z.
bool Csv_reader::find_plane_columns(int wanted)
{
  std::size_t x = 0, y = 0, z = 0;
  if(!find_column("x", x) || !find_column("y", y))
    return false;
  columns_ = {x, y};
  if(wanted != 2 && find_column("z", z))
    columns_.push_back(z);
  return wanted != 3 || columns_.size() == 3;
}

// In the plane, longitude comes first: it is the one that runs to the right.
bool Csv_reader::find_degree_columns(bool latitude_first)
{
  std::size_t latitude = 0, longitude = 0;
  if(!find_column_beginning_with("lat", latitude) ||
     !find_column_beginning_with("lon", longitude))
    return false;
  columns_ = {latitude, longitude};
  if(!latitude_first)
    std::swap(columns_[0], columns_[1]);
  unit = "deg";
  return true;
}

} // namespace near_pairs
