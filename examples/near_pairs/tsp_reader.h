// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Nodes of TSPLIB files (.tsp), as TSPLIB 95 describes them.

#ifndef NEAR_PAIRS_TSP_READER_H
#define NEAR_PAIRS_TSP_READER_H

#include "error.h"
#include "input.h"
#include "row_reader.h"

#include <cstddef>
#include <optional>
#include <string>

namespace near_pairs {

// A head of lines "KEY : value" and of sections of other data, then NODE_COORD_SECTION with a node
// number and its coordinates on each line, up to EOF or the next section.
class Tsp_reader : public Row_reader
{
public:
  Tsp_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  void read_head();
  void read_value(const std::string& key, const std::string& value);
  void take_line();
  void check_end();
  Error error(const std::string& what) const;

  Lines lines_;
  std::string line_; // the next one, if more_
  bool more_ = false;
  std::string weight_type_; // EDGE_WEIGHT_TYPE, in lower case
  std::size_t words_per_node_ = 0;
  std::size_t count_ = 0;
  std::optional<std::size_t> promised_; // DIMENSION
};

} // namespace near_pairs

#endif // NEAR_PAIRS_TSP_READER_H
