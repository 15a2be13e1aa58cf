// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangles in the format STL, as text or in binary.

#ifndef NEAR_PAIRS_STL_READER_H
#define NEAR_PAIRS_STL_READER_H

#include "mesh_reader.h"
#include "numbers.h"

#include <optional>

namespace near_pairs {

// A binary file is told by its size, which its count of facets must fit: its title may begin with
// the word that a text begins with. A text may have several solids. Normals and attributes are not
// looked at.
class Stl_reader : public Mesh_reader
{
public:
  Stl_reader(const Input& input, const Read_options& options);

  bool next(Row& row) override;

private:
  bool begin_facet();
  bool begin_facet_of_text();
  void begin_solid();
  void end_facet();
  void expect(const char* word);
  void skip_line();

  Numbers numbers_;
  std::optional<std::size_t> facets_; // as the head of a binary file promises
  std::size_t facet_ = 0;             // how many were begun
  std::size_t vertex_ = 0;            // of the facet in hand: how many were read
  bool is_in_solid_ = false;
  Face face_;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_STL_READER_H
