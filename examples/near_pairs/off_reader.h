// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The vertices of a mesh in the format OFF, as text.

#ifndef NEAR_PAIRS_OFF_READER_H
#define NEAR_PAIRS_OFF_READER_H

#include "input.h"
#include "row_reader.h"

namespace near_pairs {

// The word OFF, perhaps after ST, C and N (textures, colors and normals follow the coordinates
// then, and are skipped), and the numbers of vertices, faces and edges; then a vertex on each line.
// A comment begins with #. Faces are not looked at.
//
// CGAL's reader is not used: it trusts the counts and the numbers of a file, also as sizes and as
// places in memory. To check a file for it takes more than to read the vertices.
class Off_reader : public Row_reader
{
public:
  Off_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  void read_head();
  bool next_words(std::vector<std::string>& texts, std::size_t most);

  Lines lines_;
  std::size_t promised_ = 0;
  std::size_t count_ = 0;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_OFF_READER_H
