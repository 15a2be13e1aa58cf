// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes in the format OBJ; see obj_reader.h.

#include "obj_reader.h"

#include "error.h"

#include <algorithm>

namespace near_pairs {

Obj_reader::Obj_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
}

bool Obj_reader::next(Row& row)
{
  for(std::string line; lines_.next(line); ) {
    const std::vector<std::string> texts = words(line, 4);
    if(texts.empty() || texts.front() != "v")
      continue;
    row.line = lines_.number();
    if(texts.size() < 4)
      throw Error(lines_.file(), row.line, plural(texts.size() - 1, "number")
                  + " where 3 are needed");
    std::copy_n(texts.begin() + 1, dimension, row.coordinates.begin());
    has_vertices_ = true;
    return true;
  }
  if(!has_vertices_)
    throw Error(lines_.file(), "no line of a vertex, which begins with v");
  return false;
}

} // namespace near_pairs
