// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes and point clouds in the format PLY, as text or in binary: vertices and faces.

#ifndef NEAR_PAIRS_PLY_READER_H
#define NEAR_PAIRS_PLY_READER_H

#include "mesh_reader.h"
#include "numbers.h"

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
  bool has_corners = false;              // of a face
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

// The properties x, y and, if it is there, z of the element "vertex", and the list vertex_indices
// or vertex_index of the element "face". Numbers may stand on any lines. All elements are read, so
// that nothing is left over: a file with more numbers than its head promises has vertices in other
// places.
class Ply_reader : public Mesh_reader
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
  void choose_corners();
  void skip_items(const Ply_element& element);
  void read_item(const Ply_element& element, Row* row);
  void read_face(const Ply_property& property);

  const std::string file_;
  Numbers numbers_;
  std::vector<Ply_element> elements_;
  std::size_t vertices_ = 0; // the element that has them
  std::size_t before_ = 0;   // how many elements before it were read
  std::size_t count_ = 0;    // of the vertices read
};

} // namespace near_pairs

#endif // NEAR_PAIRS_PLY_READER_H
