// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tables; see csv_reader.h.

#include "csv_reader.h"

#include "decimal.h"
#include "error.h"
#include "row_numbers.h"
#include "text.h"

#include <algorithm>
#include <utility>

namespace near_pairs {
namespace {

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

std::string joined(const std::vector<std::string>& texts)
{
  std::string list;
  for(const std::string& text : texts)
    list += (list.empty() ? "" : ", ") + text;
  return list;
}

} // namespace

Csv_reader::Csv_reader(const Input& input, const Read_options& options)
  : records_(input, options.separator, options.comma_numbers),
    comma_numbers_(options.comma_numbers), skip_missing_(options.skip_missing),
    has_times_(!options.time.empty())
{
  is_table = true;
  may_skip_missing = options.may_skip_missing;
  if(!records_.next(fields_))
    throw Error(records_.file(), "is empty");
  fields_per_row_ = fields_.size();
  is_first_row_ready_ = options.no_header || are_numbers(options.columns);
  if(!is_first_row_ready_)
    header_ = in_utf8(fields_);
  if(!header_.empty() || has_header_in_comment(options))
    choose_columns(options);
  else
    choose_columns_by_number(options);
  check_columns_differ();
  choose_more_columns(options);
  dimension = static_cast<int>(columns_.size());
  id_column_ = options.id.empty() ? find_column("id") : named_column(options.id);
  has_ids = id_column_.has_value();
}

// ---- columns ------------------------------------------------------------------------------------

Error Csv_reader::error(const std::string& what) const
{
  return Error(records_.file(), records_.line(), what);
}

void Csv_reader::choose_columns(const Read_options& options)
{
  for(const std::string& name : options.columns)
    columns_.push_back(named_column(name));
  if(columns_.empty() && !take_guess(options)) {
    if(std::any_of(header_.begin(), header_.end(), is_no_text))
      throw error("is no text, so it is no table");
    const std::string wanted = options.geographic ? "lat and lon"
                             : options.dimension == 3 ? "x, y, z" : "x, y or lat, lon";
    const bool has_number = std::any_of(header_.begin(), header_.end(), parse_decimal);
    throw error("no columns " + wanted + "; choose with --columns among " + joined(header_)
                + (has_number ? ", and with --no-header if this is a point" : ""));
  }
  if(options.geographic)
    put_latitude_first();
  for(std::size_t axis = 0; axis < columns_.size(); ++axis)
    names[axis] = header_[columns_[axis]];
  are_guessed = options.columns.empty();
}

// Without a header, the columns that are not given are the first two or three, if the file has no
// others.
void Csv_reader::choose_columns_by_number(const Read_options& options)
{
  for(const std::string& name : options.columns)
    columns_.push_back(named_column(name));
  if(options.geographic) {
    names = {"latitude", "longitude", ""};
    latitude_axis = 0;
  }
  if(!columns_.empty())
    return;
  const std::size_t wanted = options.dimension == 0 ? fields_per_row_ : options.dimension;
  if(options.geographic || wanted < 2 || wanted > 3 || wanted > fields_per_row_)
    throw error("no header, and " + plural(fields_per_row_, "field")
                + "; choose the coordinates with --columns, by number from 1"
                + (options.geographic ? ", the latitude first" : ""));
  for(std::size_t column = 0; column < wanted; ++column)
    columns_.push_back(column);
}

Column_guess Csv_reader::guess_in_header(const Read_options& options) const
{
  return guess_columns(header_, options.geographic, options.geographic ? 2 : options.dimension);
}

// Takes the columns that the names in the header tell; returns false if they do not tell.
bool Csv_reader::take_guess(const Read_options& options)
{
  const Column_guess guess = guess_in_header(options);
  if(!guess.rivals.empty()) {
    std::vector<std::string> rivals;
    for(std::size_t column : guess.rivals)
      rivals.push_back(header_[column] + " (" + std::to_string(column + 1) + ")");
    throw error("several columns may be the coordinates: " + joined(rivals)
                + "; choose with --columns, by name or by number");
  }
  columns_ = guess.columns;
  if(guess.are_degrees) {
    unit = "deg";
    latitude_axis = 1;
  }
  return !columns_.empty();
}

bool Csv_reader::has_header_in_comment(const Read_options& options)
{
  if(options.no_header || !options.columns.empty())
    return false;
  try {
    header_ = in_utf8(records_.fields_of(records_.comment()));
  }
  catch(const Error&) { // the comment is no record, so it is no header
    return false;
  }
  const bool is_header
    = header_.size() == fields_per_row_ && !guess_in_header(options).columns.empty();
  if(!is_header)
    header_.clear();
  return is_header;
}

// Whether the first record has numbers in all columns, or in those wanted if they are given by
// number.
bool Csv_reader::are_numbers(const std::vector<std::string>& wanted) const
{
  const auto is_number
    = [&](const std::string& field) { return parse_decimal(number_text(field)).has_value(); };
  if(wanted.empty())
    return std::all_of(fields_.begin(), fields_.end(), is_number);
  return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
    const std::optional<std::size_t> column = numbered_column(name, fields_.size());
    return column && is_number(fields_[*column]);
  });
}

// The names of two columns may tell which is the longitude, though it was given first.
void Csv_reader::put_latitude_first()
{
  const std::string& first = header_[columns_[0]];
  const std::string& second = header_[columns_[1]];
  if((is_longitude(first) && !is_longitude(second)) || (is_latitude(second) && !is_latitude(first)))
    std::swap(columns_[0], columns_[1]);
  latitude_axis = 0;
}

// An altitude is one more coordinate, behind the degrees.
void Csv_reader::choose_more_columns(const Read_options& options)
{
  const auto name_of = [&](std::size_t column) {
    return header_.empty() ? "column " + std::to_string(column + 1) : header_[column];
  };
  if(!options.altitude.empty()) {
    columns_.push_back(named_column(options.altitude));
    names[2] = name_of(columns_.back());
    altitude_unit = options.altitude_unit;
  }
  std::vector<std::string> wanted = options.velocity;
  if(has_times_)
    wanted.push_back(options.time);
  for(const std::string& name : wanted) {
    motion_columns_.push_back(named_column(name));
    motion_names.push_back(name_of(motion_columns_.back()));
  }
}

void Csv_reader::check_columns_differ() const
{
  for(auto column = columns_.begin(); column != columns_.end(); ++column)
    if(std::find(columns_.begin(), column, *column) != column)
      throw error("--columns takes column " + std::to_string(*column + 1) + " twice");
}

// Case matters only if nothing else tells two columns apart.
std::optional<std::size_t> Csv_reader::find_column(const std::string& name) const
{
  const auto find = [&](auto is_wanted) -> std::optional<std::size_t> {
    const auto first = std::find_if(header_.begin(), header_.end(), is_wanted);
    if(first == header_.end())
      return std::nullopt;
    const auto second = std::find_if(first + 1, header_.end(), is_wanted);
    if(second != header_.end())
      throw error("columns " + std::to_string(first - header_.begin() + 1) + " and "
                  + std::to_string(second - header_.begin() + 1) + " are both named " + *second
                  + "; choose one by its number");
    return first - header_.begin();
  };
  const std::string wanted = utf8(name), in_lower_case = lower_case(wanted);
  const auto exact = find([&](const std::string& other) { return other == wanted; });
  return exact ? exact : find([&](const std::string& other) {
    return lower_case(other) == in_lower_case;
  });
}

std::size_t Csv_reader::named_column(const std::string& name) const
{
  const bool is_named = !name.empty(); // a column without a name has its number
  if(const std::optional<std::size_t> column = is_named ? find_column(name) : std::nullopt)
    return *column;
  if(const std::optional<std::size_t> number = numbered_column(name, fields_per_row_))
    return *number;
  throw error("no column '" + name + "' among "
              + (header_.empty() ? "1 to " + std::to_string(fields_per_row_) + ", without a header"
                                 : joined(header_)));
}

// ---- rows ---------------------------------------------------------------------------------------

bool Csv_reader::next(Row& row)
{
  do {
    if(!next_row())
      return false;
    row.position = rows_++;
    row.line = records_.line();
  } while(skip_missing_ && is_any_missing() && ++skipped);
  for(int axis = 0; axis < dimension; ++axis)
    row.coordinates[axis] = number_in(columns_[axis], names[axis]);
  if(id_column_)
    row.id = utf8(fields_[*id_column_]);
  read_motion(row);
  return true;
}

// Reads the next row. Empty rows count if another one follows: spreadsheets write them behind
// tables.
bool Csv_reader::next_row()
{
  std::size_t empty_rows = 0, first_empty_line = 0;
  while(next_record()) {
    check_fields();
    const bool is_empty = std::all_of(fields_.begin(), fields_.end(),
                                      [](const std::string& field) { return field.empty(); });
    if(is_empty && empty_rows++ == 0)
      first_empty_line = records_.line();
    if(is_empty)
      continue;
    if(empty_rows != 0 && !skip_missing_)
      throw Error(records_.file(), first_empty_line, "the row is empty" + advice_on_missing());
    rows_ += empty_rows;
    skipped += empty_rows;
    return true;
  }
  return false;
}

bool Csv_reader::next_record()
{
  if(std::exchange(is_first_row_ready_, false))
    return true;
  do
    if(!records_.next(fields_))
      return false;
  while(records_.begins_with_hash() && is_comment());
  return true;
}

// Inside a table, what begins with # may be a name. It is none where a number is to stand, or if it
// is not one of as many fields as rows have.
bool Csv_reader::is_comment() const
{
  return fields_.size() != fields_per_row_ || (records_.has_blanks_between() && fields_[0] == "#")
         || std::count(columns_.begin(), columns_.end(), 0u) != 0;
}

// Some programs end all rows with a separator, but not the header.
void Csv_reader::check_fields()
{
  const bool is_first = !std::exchange(has_row_, true);
  if(is_first && fields_.size() == header_.size() + 1 && fields_.back().empty())
    ++fields_per_row_;
  if(fields_.size() != fields_per_row_)
    throw error(plural(fields_.size(), "field") + ", but the "
                + (fields_per_row_ == header_.size() ? "header" : "first row") + " has "
                + std::to_string(fields_per_row_));
}

// Whether a row has no place, or no time or track if it needs them. A latitude of 91 says so, in
// messages of ships (ITU-R M.1371).
bool Csv_reader::is_any_missing() const
{
  if(latitude_axis != -1) {
    const auto latitude = parse_decimal(number_text(fields_[columns_[latitude_axis]]));
    if(latitude && latitude->digits == "91" && latitude->exponent == 0 && !latitude->negative)
      return true;
  }
  const auto is_empty = [&](std::size_t column) { return is_missing(fields_[column]); };
  const bool has_no_time
    = has_times_ && (is_empty(motion_columns_.front()) || (id_column_ && is_empty(*id_column_)));
  return has_no_time || std::any_of(columns_.begin(), columns_.end(), is_empty);
}

// The text of a number as all formats have it, with a point, a minus of ASCII, and no D before an
// exponent; of what is no number, the text as it is.
std::string Csv_reader::number_text(const std::string& field) const
{
  const auto is_usual = [](char letter) {
    return (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' || letter == 'e';
  };
  if(std::all_of(field.begin(), field.end(), is_usual)) // nearly always
    return field;
  const std::string text(trimmed(field)); // there may be blanks inside quotes
  const std::string minus = "\u2212";
  std::string number = text;
  for(std::size_t at = 0; (at = number.find(minus, at)) != std::string::npos; )
    number.replace(at, minus.size(), "-");
  std::replace(number.begin(), number.end(), 'D', 'e');
  std::replace(number.begin(), number.end(), 'd', 'e');
  if(comma_numbers_ && number.find('.') == std::string::npos)
    std::replace(number.begin(), number.end(), ',', '.');
  return parse_decimal(number) ? number : text;
}

// The text of a number of the record in hand, or of a clock or a date, which may have a point.
std::string Csv_reader::number_in(std::size_t column, const std::string& name) const
{
  const std::string& field = fields_[column];
  if(comma_numbers_ && field.find('.') != std::string::npos && parse_decimal(number_text(field)))
    throw error(name + ": '" + field + "' has a point, and --comma-numbers is for commas");
  return number_text(field);
}

void Csv_reader::read_motion(Row& row) const
{
  row.motion.clear();
  for(std::size_t k = 0; k < motion_columns_.size(); ++k)
    row.motion.push_back(number_in(motion_columns_[k], motion_names[k]));
}

} // namespace near_pairs
