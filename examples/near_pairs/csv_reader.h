// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Comma-separated values with a header line. Fields may be quoted; then commas, line ends and
// doubled quotes inside them are text.

#ifndef NEAR_PAIRS_CSV_READER_H
#define NEAR_PAIRS_CSV_READER_H

#include "row_reader.h"

namespace near_pairs {

class Csv_reader : public Row_reader
{
public:
  explicit Csv_reader(const Options& options);

  bool next(Row& row) override;

private:
  bool next_record(std::vector<std::string>& fields);
  void choose_columns(const Options& options);
  std::size_t named_column(const std::string& name) const;
  bool find_column(const std::string& name, std::size_t& column) const;
  bool find_column_beginning_with(const std::string& prefix, std::size_t& column) const;
  bool find_plane_columns(int wanted);
  bool find_degree_columns(bool latitude_first);

  Lines lines_;
  std::size_t first_line_ = 0; // of the record in hand
  std::vector<std::string> header_;
  std::vector<std::string> fields_;
  std::vector<std::size_t> columns_;
  std::size_t id_column_ = 0;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_CSV_READER_H
