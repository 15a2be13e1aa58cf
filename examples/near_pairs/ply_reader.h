// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The vertices of a mesh or a point cloud in the format PLY, as text or in binary.

#ifndef NEAR_PAIRS_PLY_READER_H
#define NEAR_PAIRS_PLY_READER_H

#include "numbers.h"
#include "row_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace near_pairs {

struct Ply_property
{
  std::string name; // in lower case
  Number_type type;
  std::optional<Number_type> count_type; // of a list: the type of its length
  int axis = -1;                         // of a coordinate
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

// The properties x, y and, if it is there, z of the element "vertex". Numbers may stand on any
// lines. All elements are read, so that nothing is left over: a file with more numbers than its
// head promises has vertices in other places.
class Ply_reader : public Row_reader
{
public:
  Ply_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  void read_head();
  void read_format(const std::string& name);
  Ply_property property_of(const std::vector<std::string>& texts) const;
  Number_type type_named(const std::string& name) const;
  Error wrong_line(const std::string& what) const;
  void choose_coordinates(int wanted);
  void skip_items(const Ply_element& element);
  void read_item(const Ply_element& element, Row* row);

  const std::string file_;
  Numbers numbers_;
  std::vector<Ply_element> elements_;
  std::size_t vertices_ = 0; // the element that has them
  std::size_t count_ = 0;    // of those read
};

} // namespace near_pairs

#endif // NEAR_PAIRS_PLY_READER_H
