// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes in the format OBJ; see obj_reader.h.

#include "obj_reader.h"

#include "decimal.h"
#include "error.h"

#include <algorithm>
#include <string_view>

namespace near_pairs {

Obj_reader::Obj_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
}

bool Obj_reader::next(Row& row)
{
  for(std::string line; next_line(line); ) {
    const std::vector<std::string> texts = words(line, 1);
    const std::string keyword = texts.empty() ? "" : texts.front();
    if(keyword == "v") {
      read_vertex(line, row);
      return true;
    }
    if(take_face && keyword == "f")
      read_face(line);
    else if(take_face && (keyword == "o" || keyword == "g"))
      begin_solid(line, keyword == "o");
  }
  if(vertices_ == 0)
    throw Error(lines_.file(), "no line of a vertex, which begins with v");
  return false;
}

void Obj_reader::read_vertex(const std::string& line, Row& row)
{
  const std::vector<std::string> texts = words(line, 9);
  row.line = lines_.number();
  const std::size_t count = texts.size() - 1;
  if(count < 3)
    throw Error(lines_.file(), row.line, plural(count, "number") + " where 3 are needed");
  if(count == 5 || count > 7)
    throw Error(lines_.file(), row.line, "a vertex has 3 numbers, perhaps with a weight or three "
                "of a color, and no other ones");
  std::copy_n(texts.begin() + 1, dimension, row.coordinates.begin());
  ++vertices_;
}

void Obj_reader::read_face(const std::string& line)
{
  Face face;
  face.line = lines_.number();
  face.solid = solid_;
  const std::vector<std::string> texts = words(line, most_corners + 2);
  for(auto corner = texts.begin() + 1; corner != texts.end(); ++corner)
    face.corners.push_back(vertex_at(*corner));
  take_face(face);
}

// A corner is the number of a vertex, from 1, or from -1 backwards; a texture and a normal may
// follow behind slashes.
std::size_t Obj_reader::vertex_at(const std::string& corner) const
{
  const bool is_backward = corner.front() == '-';
  const std::string text = corner.substr(is_backward, corner.find('/') - is_backward);
  const std::size_t number = parse_count(text).value_or(0);
  if(number == 0 || (is_backward && number > vertices_))
    throw Error(lines_.file(), lines_.number(), "'" + corner + "' is no corner of a face");
  return is_backward ? vertices_ - number : number - 1;
}

// A name that was there before goes on.
void Obj_reader::begin_solid(const std::string& line, bool is_object)
{
  has_objects_ = has_objects_ || is_object;
  if(has_objects_ && !is_object)
    return;
  const std::size_t begin = line.find_first_of("og") + 1;
  const std::string name(trimmed(std::string_view(line).substr(begin)));
  const auto [solid, is_new] = numbers_.emplace(name, solids.size());
  if(is_new)
    solids.push_back(name);
  solid_ = solid->second;
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
