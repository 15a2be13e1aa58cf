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
  for(std::string line; next_line(line); ) {
    const std::vector<std::string> texts = words(line, 9);
    if(texts.empty() || texts.front() != "v")
      continue;
    row.line = lines_.number();
    const std::size_t count = texts.size() - 1;
    if(count < 3)
      throw Error(lines_.file(), row.line, plural(count, "number") + " where 3 are needed");
    if(count == 5 || count > 7)
      throw Error(lines_.file(), row.line, "a vertex has 3 numbers, perhaps with a weight or three "
                  "of a color, and no other ones");
    std::copy_n(texts.begin() + 1, dimension, row.coordinates.begin());
    has_vertices_ = true;
    return true;
  }
  if(!has_vertices_)
    throw Error(lines_.file(), "no line of a vertex, which begins with v");
  return false;
}

// The next line without its comment, and with those that it goes on in.
bool Obj_reader::next_line(std::string& line)
{
  line.clear();
  for(std::string part; lines_.next(part); line.back() = ' ') {
    line += part.erase(std::min(part.find('#'), part.size()));
    if(line.empty() || line.back() != '\\')
      return true;
  }
  return !line.empty();
}

} // namespace near_pairs
