// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tables: values separated by commas, semicolons, tabs or blanks, with or without a header.

#ifndef NEAR_PAIRS_CSV_READER_H
#define NEAR_PAIRS_CSV_READER_H

#include "input.h"
#include "row_reader.h"

#include <cstddef>
#include <string>
#include <vector>

namespace near_pairs {

// Blank lines are skipped, and so are lines that begin with #.
//
// Names of columns may be in UTF-8 or in Latin-1, and are UTF-8 from here on.
//
// The first record is a point, and no header, if the user says so, or if numbers stand where the
// coordinates are. Then the comment before it is taken as the header if it names the coordinates.
class Csv_reader : public Row_reader
{
public:
  Csv_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  bool next_record(std::vector<std::string>& fields);
  bool next_text(std::string& record);
  bool are_numbers(const std::vector<std::string>& wanted) const;
  bool is_coordinate_missing() const;
  void check_fields() const;
  std::string number_text(int axis) const;
  bool has_header_in_comment(const Read_options& options);
  void choose_columns(const Read_options& options);
  void choose_columns_by_number(const Read_options& options);
  void put_latitude_first();
  void check_columns_differ() const;
  bool find_usual_columns(const Read_options& options);
  std::size_t named_column(const std::string& name) const;
  bool find_column(const std::string& name, std::size_t& column) const;
  bool find_column_where(bool (*is_it)(const std::string&, const std::string&),
                         const std::string& prefix, std::size_t& column) const;
  bool find_plane_columns(int wanted);
  bool find_degree_columns(bool latitude_first);

  Lines lines_;
  char separator_;             // 0: to be found in the first record
  const bool comma_numbers_;
  const bool skip_missing_;
  std::size_t first_line_ = 0; // of the record in hand
  std::string comment_;        // the line before the record in hand, without its #, if it is one
  std::vector<std::string> header_; // empty if there is none
  std::vector<std::string> fields_;
  bool is_first_row_ready_ = false; // in fields_
  std::size_t fields_per_row_ = 0;
  std::size_t rows_ = 0; // up to now, with those that are skipped
  std::vector<std::size_t> columns_;
  std::size_t id_column_ = 0;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_CSV_READER_H
