// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes in the format OFF of Geomview, as text or in binary: vertices and faces.

#ifndef NEAR_PAIRS_OFF_READER_H
#define NEAR_PAIRS_OFF_READER_H

#include "mesh_reader.h"
#include "numbers.h"

namespace near_pairs {

// Numbers may stand on any lines, apart from two places where the format looks at line ends: behind
// the counts, and at the colors of faces. Faces are read so that nothing is left over: a file with
// more numbers than its head promises has vertices in other places.
class Off_reader : public Mesh_reader
{
public:
  Off_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  void read_keyword();
  void read_counts();
  std::size_t take_count();
  void read_faces();
  void read_color();

  Numbers numbers_;
  bool has_normals_ = false, has_colors_ = false, has_textures_ = false;
  std::size_t coordinates_ = 3; // of a vertex in the file
  std::size_t colors_ = 0;      // numbers of the color of a vertex; 0: not known yet
  std::size_t vertices_ = 0, faces_ = 0;
  std::size_t count_ = 0; // of the vertices read
};

} // namespace near_pairs

#endif // NEAR_PAIRS_OFF_READER_H
