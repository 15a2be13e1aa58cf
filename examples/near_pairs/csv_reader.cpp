// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tables; see csv_reader.h.

#include "csv_reader.h"

#include "decimal.h"
#include "error.h"
#include "record.h"
#include "row_numbers.h"
#include "text.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace near_pairs {
namespace {

std::string lower_case(std::string text)
{
  for(char& letter : text)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

bool begins_with(const std::string& text, const std::string& prefix)
{
  return text.compare(0, prefix.size(), prefix) == 0;
}

// Whether a word of the text begins with the prefix: "le_latitude_deg" has one that begins with
// "lat".
bool has_word(const std::string& text, const std::string& prefix)
{
  const auto is_inside_word = [&](std::size_t at) {
    return at != 0 && std::isalnum(static_cast<unsigned char>(text[at - 1]));
  };
  std::size_t at = text.find(prefix);
  while(at != std::string::npos && is_inside_word(at))
    at = text.find(prefix, at + 1);
  return at != std::string::npos;
}

bool is_latitude(const std::string& name)
{
  return has_word(lower_case(name), "lat") || lower_case(name) == "y";
}

bool is_longitude(const std::string& name)
{
  return has_word(lower_case(name), "lon") || has_word(lower_case(name), "lng")
         || lower_case(name) == "x";
}

// Whether the bytes may be those of a compressed file, or of a program.
bool is_no_text(const std::string& bytes)
{
  return std::any_of(bytes.begin(), bytes.end(), [](unsigned char byte) {
    return std::iscntrl(byte) != 0 && std::isspace(byte) == 0;
  });
}

// The column that a number from 1 names.
std::optional<std::size_t> numbered_column(const std::string& text, std::size_t columns)
{
  const std::optional<std::size_t> number = parse_count(text);
  if(!number || *number < 1 || *number > columns)
    return std::nullopt;
  return *number - 1;
}

std::vector<std::string> in_utf8(std::vector<std::string> names)
{
  std::transform(names.begin(), names.end(), names.begin(), utf8);
  return names;
}

std::string joined(const std::vector<std::string>& names)
{
  std::string list;
  for(const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

} // namespace

Csv_reader::Csv_reader(const Input& input, const Read_options& options)
  : lines_(input), separator_(options.separator), comma_numbers_(options.comma_numbers),
    skip_missing_(options.skip_missing)
{
  is_table = true;
  if(!next_record(fields_))
    throw Error(lines_.file(), "is empty");
  fields_per_row_ = fields_.size();
  is_first_row_ready_ = options.no_header || are_numbers(options.columns);
  if(!is_first_row_ready_)
    header_ = in_utf8(fields_);
  if(!header_.empty() || has_header_in_comment(options))
    choose_columns(options);
  else
    choose_columns_by_number(options);
  check_columns_differ();
  dimension = static_cast<int>(columns_.size());
  if(options.id.empty())
    has_ids = find_column("id", id_column_);
  else {
    id_column_ = named_column(options.id);
    has_ids = true;
  }
}

bool Csv_reader::next(Row& row)
{
  do {
    if(!is_first_row_ready_ && !next_record(fields_))
      return false;
    is_first_row_ready_ = false;
    check_fields();
    row.position = rows_++;
    row.line = first_line_;
  } while(skip_missing_ && is_coordinate_missing() && ++skipped);
  for(int axis = 0; axis < dimension; ++axis)
    row.coordinates[axis] = number_text(axis);
  if(has_ids)
    row.id = fields_[id_column_];
  return true;
}

void Csv_reader::check_fields() const
{
  if(fields_.size() != fields_per_row_)
    throw Error(lines_.file(), first_line_, plural(fields_.size(), "field") + ", but the "
                + (header_.empty() ? "first row" : "header") + " has "
                + std::to_string(fields_per_row_));
}

bool Csv_reader::is_coordinate_missing() const
{
  return std::any_of(columns_.begin(), columns_.end(),
                     [&](std::size_t column) { return is_missing(fields_[column]); });
}

// A coordinate of the row in hand, with the decimal point that all formats have.
std::string Csv_reader::number_text(int axis) const
{
  std::string text = fields_[columns_[axis]];
  if(!comma_numbers_)
    return text;
  if(text.find('.') != std::string::npos && parse_decimal(text))
    throw Error(lines_.file(), first_line_, names[axis] + ": '" + text + "' has a point, and "
                "--comma-numbers is for commas");
  if(has_decimal_comma(text))
    text[text.find(',')] = '.';
  return text;
}

// Reads the next record; a line end inside quotes is part of it.
bool Csv_reader::next_record(std::vector<std::string>& fields)
{
  std::string record;
  if(!next_text(record))
    return false;
  first_line_ = lines_.number();
  // Each line is looked at once, so that a stray quote costs no more than any other letter.
  bool is_open = has_odd_quotes(record);
  for(std::string line; is_open; is_open ^= has_odd_quotes(line)) {
    if(!lines_.next(line))
      throw Error(lines_.file(), first_line_, "a quote is not closed");
    record.append(1, '\n').append(line);
  }
  if(separator_ == 0)
    separator_ = found_separator(record, comma_numbers_ ? "\t;" : "\t;,");
  if(!split_record(record, separator_, fields))
    throw Error(lines_.file(), first_line_, "a quoted field does not end at a separator");
  return true;
}

// Reads the next line that is neither blank nor a comment.
bool Csv_reader::next_text(std::string& record)
{
  comment_.clear();
  while(lines_.next(record)) {
    const std::string_view text = trimmed(record);
    if(!text.empty() && text.front() != '#')
      return true;
    comment_ = text.empty() ? text : text.substr(1);
  }
  return false;
}

// Whether the first record has numbers in all columns, or in those wanted if they are given by
// number.
bool Csv_reader::are_numbers(const std::vector<std::string>& wanted) const
{
  const auto is_number = [&](const std::string& field) {
    return parse_decimal(field) || (comma_numbers_ && has_decimal_comma(field));
  };
  if(wanted.empty())
    return std::all_of(fields_.begin(), fields_.end(), is_number);
  return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
    const std::optional<std::size_t> column = numbered_column(name, fields_.size());
    return column && is_number(fields_[*column]);
  });
}

bool Csv_reader::has_header_in_comment(const Read_options& options)
{
  if(options.no_header || !options.columns.empty() ||
     !split_record(std::string(trimmed(comment_)), separator_, header_) ||
     header_.size() != fields_per_row_ || !find_usual_columns(options))
    header_.clear();
  header_ = in_utf8(header_);
  columns_.clear();
  return !header_.empty();
}

void Csv_reader::choose_columns(const Read_options& options)
{
  for(const std::string& name : options.columns)
    columns_.push_back(named_column(name));
  if(columns_.empty() && !find_usual_columns(options)) {
    if(std::any_of(header_.begin(), header_.end(), is_no_text))
      throw Error(lines_.file(), first_line_, "is no text, so it is no table");
    const std::string wanted = options.geographic ? "lat* and lon*"
                             : options.dimension == 3 ? "x, y, z" : "x, y or lat*, lon*";
    const bool has_number = std::any_of(header_.begin(), header_.end(), parse_decimal);
    throw Error(lines_.file(), first_line_, "no columns " + wanted + "; choose with --columns "
                "among " + joined(header_)
                + (has_number ? ", and with --no-header if this is a point" : ""));
  }
  if(options.geographic)
    put_latitude_first();
  for(std::size_t axis = 0; axis < columns_.size(); ++axis)
    names[axis] = header_[columns_[axis]];
}

// The names of two columns may tell which is the longitude, though it was given first.
void Csv_reader::put_latitude_first()
{
  const std::string& first = header_[columns_[0]];
  const std::string& second = header_[columns_[1]];
  if((is_longitude(first) && !is_longitude(second)) || (is_latitude(second) && !is_latitude(first)))
    std::swap(columns_[0], columns_[1]);
}

void Csv_reader::check_columns_differ() const
{
  for(auto column = columns_.begin(); column != columns_.end(); ++column)
    if(std::find(columns_.begin(), column, *column) != column)
      throw Error(lines_.file(), first_line_, "--columns takes column "
                  + std::to_string(*column + 1) + " twice");
}

// Without a header, the columns that are not given are the first two or three, if the file has no
// others.
void Csv_reader::choose_columns_by_number(const Read_options& options)
{
  for(const std::string& name : options.columns)
    columns_.push_back(named_column(name));
  if(options.geographic)
    names = {"latitude", "longitude", ""};
  if(!columns_.empty())
    return;
  const std::size_t wanted = options.dimension == 0 ? fields_per_row_ : options.dimension;
  if(options.geographic || wanted < 2 || wanted > 3 || wanted > fields_per_row_)
    throw Error(lines_.file(), first_line_, "no header, and " + plural(fields_per_row_, "field")
                + "; choose the coordinates with --columns, by number from 1"
                + (options.geographic ? ", the latitude first" : ""));
  for(std::size_t column = 0; column < wanted; ++column)
    columns_.push_back(column);
}

bool Csv_reader::find_usual_columns(const Read_options& options)
{
  return options.geographic ? find_degree_columns(true)
                            : find_plane_columns(options.dimension) ||
                              (options.dimension != 3 && find_degree_columns(false));
}

std::size_t Csv_reader::named_column(const std::string& name) const
{
  std::size_t column = 0;
  if(find_column(name, column))
    return column;
  if(const std::optional<std::size_t> number = numbered_column(name, fields_per_row_))
    return *number;
  throw Error(lines_.file(), first_line_, "no column '" + name + "' among "
              + (header_.empty() ? "1 to " + std::to_string(fields_per_row_) + ", without a header"
                                 : joined(header_)));
}

// Case matters only if nothing else tells two columns apart.
bool Csv_reader::find_column(const std::string& name, std::size_t& column) const
{
  const std::string wanted = utf8(name);
  const auto is_exact = [&](const std::string& other) { return other == wanted; };
  const auto is_it = [&](const std::string& other) {
    return lower_case(other) == lower_case(wanted);
  };
  const auto find = [&](auto is_wanted) {
    const auto first = std::find_if(header_.begin(), header_.end(), is_wanted);
    const auto second = first == header_.end() ? first : std::find_if(first + 1, header_.end(),
                                                                      is_wanted);
    if(second != header_.end())
      throw Error(lines_.file(), first_line_, "columns "
                  + std::to_string(first - header_.begin() + 1) + " and "
                  + std::to_string(second - header_.begin() + 1) + " are both named " + *second
                  + "; choose one by its number");
    column = first - header_.begin();
    return first != header_.end();
  };
  return find(is_exact) || find(is_it);
}

bool Csv_reader::find_column_where(bool (*is_it)(const std::string&, const std::string&),
                                   const std::string& prefix, std::size_t& column) const
{
  const auto is_this = [&](const std::string& name) { return is_it(lower_case(name), prefix); };
  const auto first = std::find_if(header_.begin(), header_.end(), is_this);
  return first != header_.end() && find_column(*first, column);
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

// Names that begin with the prefixes come before names that have them later. In the plane,
// longitude comes first: it is the one that runs to the right.
bool Csv_reader::find_degree_columns(bool latitude_first)
{
  std::size_t latitude = 0, longitude = 0;
  const auto find = [&](auto is_it) {
    return find_column_where(is_it, "lat", latitude)
           && (find_column_where(is_it, "lon", longitude)
               || find_column_where(is_it, "lng", longitude));
  };
  if((!find(begins_with) && !find(has_word)) || latitude == longitude)
    return false;
  columns_ = {latitude, longitude};
  if(!latitude_first)
    std::swap(columns_[0], columns_[1]);
  unit = "deg";
  return true;
}

} // namespace near_pairs
