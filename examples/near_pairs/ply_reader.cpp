// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes and point clouds in the format PLY; see ply_reader.h.

#include "ply_reader.h"

#include "error.h"
#include "text.h"

#include <algorithm>
#include <cctype>

namespace near_pairs {
namespace {

struct Named_type
{
  const char* name;
  const char* other_name;
  Number_type type;
};

const Named_type types[] = {
  {"uchar", "uint8", {1, Number_type::UNSIGNED}}, {"char", "int8", {1, Number_type::SIGNED}},
  {"ushort", "uint16", {2, Number_type::UNSIGNED}}, {"short", "int16", {2, Number_type::SIGNED}},
  {"uint", "uint32", {4, Number_type::UNSIGNED}}, {"int", "int32", {4, Number_type::SIGNED}},
  {"float", "float32", {4, Number_type::FLOATING}},
  {"double", "float64", {8, Number_type::FLOATING}}};

} // namespace

Ply_reader::Ply_reader(const Input& input, const Read_options& options)
  : file_(input.name()), numbers_(input, options)
{
  read_head();
  const auto has_vertices = [](const Ply_element& element) {
    return element.name == "vertex" || element.name == "vertices";
  };
  vertices_ = std::find_if(elements_.begin(), elements_.end(), has_vertices) - elements_.begin();
  if(vertices_ == elements_.size())
    throw Error(file_, "the header has no element vertex");
  if(std::count_if(elements_.begin(), elements_.end(), has_vertices) > 1)
    throw Error(file_, "the header has several elements of vertices");
  choose_coordinates(options.dimension);
  if(options.solids)
    choose_corners();
}

bool Ply_reader::next(Row& row)
{
  const Ply_element& vertices = elements_[vertices_];
  for(; before_ < vertices_; ++before_)
    skip_items(elements_[before_]);
  if(count_ == vertices.count) {
    for(std::size_t element = vertices_ + 1; element < elements_.size(); ++element)
      skip_items(elements_[element]);
    elements_.resize(vertices_ + 1);
    numbers_.expect_end();
    return false;
  }
  numbers_.begin("vertex", count_++, vertices.count);
  read_item(vertices, &row);
  row.line = numbers_.line();
  return true;
}

void Ply_reader::read_head()
{
  std::string line;
  if(!numbers_.next_line(line) || words(line, 2) != std::vector<std::string>{"ply"})
    throw Error(file_, "does not begin with a line 'ply'");
  bool has_format = false;
  while(numbers_.next_line(line)) {
    const std::vector<std::string> texts = words(line, 6);
    const std::string keyword = texts.empty() ? "comment" : texts.front();
    if(keyword == "end_header" && !has_format)
      throw wrong_line("the header has no format");
    if(keyword == "end_header")
      return;
    if(keyword == "format" && texts.size() == 3) {
      read_format(texts[1]);
      has_format = true;
    }
    else if(keyword == "element" && texts.size() == 3 && parse_count(texts[2]))
      elements_.push_back({texts[1], *parse_count(texts[2]), {}});
    else if(keyword == "property" && !elements_.empty())
      elements_.back().properties.push_back(property_of(texts));
    else if(keyword != "comment" && keyword != "obj_info")
      throw wrong_line("no line of a header: '" + line + "'");
  }
  throw Error(file_, "no end_header");
}

void Ply_reader::read_format(const std::string& name)
{
  if(name == "binary_little_endian")
    numbers_.become_binary(Numbers::LEAST_FIRST);
  else if(name == "binary_big_endian")
    numbers_.become_binary(Numbers::MOST_FIRST);
  else if(name != "ascii")
    throw wrong_line("unknown format '" + name + "'");
}

// Reads "property <type> <name>" or "property list <type> <type> <name>".
Ply_property Ply_reader::property_of(const std::vector<std::string>& texts) const
{
  if(texts.size() == 3)
    return {lower_case(texts[2]), type_named(texts[1]), {}};
  if(texts.size() != 5 || texts[1] != "list")
    throw wrong_line("a property has a type and a name");
  const Number_type count_type = type_named(texts[2]);
  if(count_type.kind == Number_type::FLOATING)
    throw wrong_line("the length of a list is no integer");
  return {lower_case(texts[4]), type_named(texts[3]), count_type};
}

Number_type Ply_reader::type_named(const std::string& name) const
{
  for(const Named_type& type : types)
    if(name == type.name || name == type.other_name)
      return type.type;
  throw wrong_line("unknown type '" + name + "'");
}

Error Ply_reader::wrong_line(const std::string& what) const
{
  return Error(file_, numbers_.line(), what);
}

void Ply_reader::choose_coordinates(int wanted)
{
  std::vector<Ply_property>& properties = elements_[vertices_].properties;
  for(dimension = 0; dimension < (wanted == 0 ? 3 : wanted); ++dimension) {
    const std::string& name = names[dimension];
    const auto has_name = [&](const Ply_property& property) { return property.name == name; };
    const auto place = std::find_if(properties.begin(), properties.end(), has_name);
    if(place == properties.end() && dimension == 2 && wanted == 0)
      return;
    if(place == properties.end())
      throw Error(file_, "the vertices have no property " + name);
    if(std::count_if(place, properties.end(), has_name) > 1 || place->count_type)
      throw Error(file_, "the vertices have several numbers " + name);
    place->axis = dimension;
  }
}

void Ply_reader::choose_corners()
{
  for(Ply_element& element : elements_) {
    if(element.name == "tristrips" && element.count != 0)
      throw Error(file_, "strips of triangles are not read; save single faces");
    for(Ply_property& property : element.properties)
      property.has_corners
        = element.name == "face" && property.count_type
          && property.type.kind != Number_type::FLOATING
          && (property.name == "vertex_indices" || property.name == "vertex_index");
  }
}

// Every item has a number, so that the time depends on the size of the file.
void Ply_reader::skip_items(const Ply_element& element)
{
  const std::size_t count = element.properties.empty() ? 0 : element.count;
  for(std::size_t item = 0; item < count; ++item) {
    numbers_.begin(element.name, item, count);
    read_item(element, nullptr);
  }
}

void Ply_reader::read_item(const Ply_element& element, Row* row)
{
  for(const Ply_property& property : element.properties) {
    numbers_.take(property.count_type.value_or(property.type));
    if(property.has_corners)
      read_face(property);
    else if(property.count_type)
      numbers_.skip(numbers_.count(), property.type);
    else if(row != nullptr && property.axis >= 0)
      row->coordinates[property.axis] = numbers_.coordinate();
  }
}

void Ply_reader::read_face(const Ply_property& property)
{
  Face face;
  for(std::size_t corner = numbers_.count(); corner > 0; --corner) {
    numbers_.take(property.type);
    if(face.corners.size() <= most_corners)
      face.corners.push_back(numbers_.count());
  }
  face.line = numbers_.are_binary() ? 0 : numbers_.line();
  take_face(face);
}

} // namespace near_pairs
