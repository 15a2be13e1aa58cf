// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points of an input, one at a time, as doubles: for inputs that are longer than the memory.

#ifndef NEAR_PAIRS_POINT_STREAM_H
#define NEAR_PAIRS_POINT_STREAM_H

#include "input.h"
#include "read_options.h"
#include "row_reader.h"

#include <array>
#include <cstddef>
#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace near_pairs {

// Reads rows of text, or three doubles per point, least byte first, if the input is binary.
class Point_stream
{
public:
  Point_stream(const Input& input, const Read_options& options);

  // Reads the next point; returns false at the end. Coordinates beyond the dimension are 0. Throws
  // Error if the point cannot be taken at its word.
  bool next(std::array<double, 3>& point);

  int dimension() const { return dimension_; }

  std::string unit() const { return options_.geographic ? "m" : reader_ ? reader_->unit : ""; }

  // The columns that were guessed, for a summary.
  std::string guessed() const { return reader_ ? guessed_columns(*reader_) : ""; }

  // Known from the end of the points.
  Frame frame() const { return reader_ ? reader_->frame : Frame(); }

private:
  bool next_row(std::array<double, 3>& point);
  bool next_binary(std::array<double, 3>& point);
  bool fill();

  const Input& input_;
  Read_options options_;
  int dimension_;

  std::unique_ptr<Row_reader> reader_; // of text
  Row row_;

  std::unique_ptr<std::istream> bytes_; // of binary points
  std::vector<char> block_;
  std::size_t block_size_ = 0;
  std::size_t bytes_read_ = 0;
  std::size_t at_ = 0;     // in the block
  std::size_t number_ = 0; // of the next point
};

} // namespace near_pairs

#endif // NEAR_PAIRS_POINT_STREAM_H
