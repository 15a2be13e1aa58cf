// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The vertices of a mesh or a point cloud in the format PLY, as text or in binary.

#ifndef NEAR_PAIRS_PLY_READER_H
#define NEAR_PAIRS_PLY_READER_H

#include "input.h"
#include "row_reader.h"

namespace near_pairs {

struct Ply_type; // a type of numbers

struct Ply_property
{
  std::string name;
  const Ply_type* type;
  const Ply_type* count_type; // of a list: the type of its length; otherwise null
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

// The properties x, y and, if it is there, z of the element "vertex". What stands before that
// element is skipped, what stands behind it is not looked at.
//
// CGAL's reader is not used: it trusts the header, and takes the lengths of lists and the types of
// the coordinates for granted. To check a file for it takes more than to read the vertices.
class Ply_reader : public Row_reader
{
public:
  Ply_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  enum class Format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

  void read_header();
  Format format_named(const std::string& name) const;
  Ply_property property_of(const std::vector<std::string>& texts) const;
  const Ply_type& type_named(const std::string& name) const;
  void skip_to_vertices();
  void skip_item(const Ply_element& element);
  void choose_coordinates(int wanted);
  void read_text(Row& row);
  void read_binary(Row& row);
  double number_at(std::size_t offset, const Ply_type& type) const;
  void cut_off() const;

  Lines lines_;
  Format format_ = Format::ASCII;
  std::vector<Ply_element> elements_; // after skip_to_vertices(), the first one has the vertices
  std::size_t columns_[3];            // of the coordinates among the properties
  std::size_t offsets_[3];            // of the coordinates among the bytes of a vertex
  std::size_t bytes_per_vertex_ = 0;
  std::size_t count_ = 0;
  std::string bytes_;                 // of the vertex in hand, or of a number
};

} // namespace near_pairs

#endif // NEAR_PAIRS_PLY_READER_H
