// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The rows of a reader that have all their coordinates: meshes and clouds of points write NaN for a
// point that was not measured.

#ifndef NEAR_PAIRS_PRESENT_ROWS_H
#define NEAR_PAIRS_PRESENT_ROWS_H

#include "row_numbers.h"
#include "row_reader.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace near_pairs {

class Present_rows : public Row_reader
{
public:
  explicit Present_rows(std::unique_ptr<Row_reader> reader)
    : Row_reader(*reader), reader_(std::move(reader))
  {}

  bool next(Row& row) override
  {
    while(reader_->next(row)) {
      row.position = position_++;
      if(std::none_of(row.coordinates.begin(), row.coordinates.begin() + dimension, is_missing))
        return true;
      ++skipped;
    }
    frame = reader_->frame;
    line_of_cell = reader_->line_of_cell;
    return false;
  }

  std::optional<Cell> cell() const override { return reader_->cell(); }

private:
  std::unique_ptr<Row_reader> reader_;
  std::size_t position_ = 0; // of the next row
};

} // namespace near_pairs

#endif // NEAR_PAIRS_PRESENT_ROWS_H
