// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The vertices of a mesh in the format OBJ.

#ifndef NEAR_PAIRS_OBJ_READER_H
#define NEAR_PAIRS_OBJ_READER_H

#include "input.h"
#include "row_reader.h"

namespace near_pairs {

// The first three numbers of each line that begins with the word v; behind them may be a weight,
// and three numbers of a color. Other lines are not looked at. A line goes on in the next one if a
// backslash ends it, and a comment begins with #.
class Obj_reader : public Row_reader
{
public:
  Obj_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  bool next_line(std::string& line);

  Lines lines_;
  bool has_vertices_ = false;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_OBJ_READER_H
