// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes in the format OBJ: vertices and faces.

#ifndef NEAR_PAIRS_OBJ_READER_H
#define NEAR_PAIRS_OBJ_READER_H

#include "input.h"
#include "mesh_reader.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace near_pairs {

// The first three numbers of each line that begins with the word v; behind them may be a weight,
// and three numbers of a color. If faces are wanted, lines that begin with f have their corners,
// and o and g name what they belong to: each object is a solid, or each group if there are no
// objects. Other lines are not looked at. A line goes on in the next one if a backslash ends it,
// and a comment begins with #.
class Obj_reader : public Mesh_reader
{
public:
  Obj_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  bool next_line(std::string& line);
  void read_vertex(const std::string& line, Row& row);
  void read_face(const std::string& line);
  std::size_t vertex_at(const std::string& corner) const;
  void begin_solid(const std::string& line, bool is_object);

  Lines lines_;
  std::size_t vertices_ = 0; // how many were read
  bool has_objects_ = false;
  std::size_t solid_ = 0;                       // of the faces that follow
  std::map<std::string, std::size_t> numbers_; // of solids, by their names
};

} // namespace near_pairs

#endif // NEAR_PAIRS_OBJ_READER_H
