// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tables: values separated by commas, semicolons, tabs, bars or blanks, with or without a header.

#ifndef NEAR_PAIRS_CSV_READER_H
#define NEAR_PAIRS_CSV_READER_H

#include "columns.h"
#include "error.h"
#include "input.h"
#include "record.h"
#include "row_reader.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace near_pairs {

// Names of columns and of points may be in UTF-8 or in Latin-1, and are UTF-8 from here on.
//
// The first record is a point, and no header, if the user says so, or if numbers stand where the
// coordinates are. Then the comment before it is taken as the header if it names the coordinates,
// unless the user does so.
class Csv_reader : public Row_reader
{
public:
  Csv_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  Error error(const std::string& what) const;

  void choose_columns(const Read_options& options);
  void choose_columns_by_number(const Read_options& options);
  Column_guess guess_in_header(const Read_options& options) const;
  bool take_guess(const Read_options& options);
  bool has_header_in_comment(const Read_options& options);
  bool are_numbers(const std::vector<std::string>& wanted) const;
  void put_latitude_first();
  void choose_more_columns(const Read_options& options);
  void check_columns_differ() const;
  std::optional<std::size_t> find_column(const std::string& name) const;
  std::size_t named_column(const std::string& name) const;

  bool next_row();
  bool next_record();
  bool is_comment() const;
  bool is_any_missing() const;
  void check_fields();
  std::string number_text(const std::string& field) const;
  std::string number_in(std::size_t column, const std::string& name) const;
  void read_motion(Row& row) const;

  Records records_;
  const bool comma_numbers_;
  const bool skip_missing_;
  const bool has_times_;
  std::vector<std::string> header_; // empty if there is none
  std::vector<std::string> fields_; // of the record in hand
  bool is_first_row_ready_ = false; // in fields_
  std::size_t fields_per_row_ = 0;
  bool has_row_ = false; // behind the header, perhaps an empty one
  std::size_t rows_ = 0; // up to now, with those that are skipped
  std::vector<std::size_t> columns_;
  std::vector<std::size_t> motion_columns_;
  std::optional<std::size_t> id_column_;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_CSV_READER_H
