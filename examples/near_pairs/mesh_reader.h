// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Files of meshes: their vertices, as rows, and their faces.

#ifndef NEAR_PAIRS_MESH_READER_H
#define NEAR_PAIRS_MESH_READER_H

#include "row_reader.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace near_pairs {

struct Face
{
  std::size_t line = 0;             // 0: the file is binary
  std::vector<std::size_t> corners; // positions of vertices, which may not be there
  std::size_t solid = 0;            // position in the names of solids
};

// Faces of more corners are refused: to cut one into triangles takes the square of them. A reader
// may leave out corners beyond the one that is too many.
constexpr std::size_t most_corners = 10000;

class Mesh_reader : public Row_reader
{
public:
  // Receives each face while the rows are read, if it is set.
  std::function<void(const Face&)> take_face;

  // Known from the end of the rows. A file that names no solids has one without a name.
  std::vector<std::string> solids = {""};
};

// Returns nothing if the format is none of meshes.
std::unique_ptr<Mesh_reader> make_mesh_reader(const std::string& format, const Input& input,
                                              const Read_options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_MESH_READER_H
