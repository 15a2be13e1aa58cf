// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes and point clouds in the format PLY; see ply_reader.h.

#include "ply_reader.h"

#include "error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace near_pairs {

struct Ply_type
{
  const char* name;
  const char* other_name;
  std::size_t bytes;
  enum Kind { UNSIGNED, SIGNED, FLOATING } kind;
};

namespace {

const Ply_type types[] = {
  {"uchar", "uint8", 1, Ply_type::UNSIGNED},   {"char", "int8", 1, Ply_type::SIGNED},
  {"ushort", "uint16", 2, Ply_type::UNSIGNED}, {"short", "int16", 2, Ply_type::SIGNED},
  {"uint", "uint32", 4, Ply_type::UNSIGNED},   {"int", "int32", 4, Ply_type::SIGNED},
  {"float", "float32", 4, Ply_type::FLOATING}, {"double", "float64", 8, Ply_type::FLOATING}};

bool is_list(const Ply_property& property)
{
  return property.count_type != nullptr;
}

template <class Float, class Bits>
double floating(Bits bits)
{
  Float value;
  static_assert(sizeof value == sizeof bits);
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// The text that nearest_double() reads as the same number.
std::string text_of(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

} // namespace

Ply_reader::Ply_reader(const Input& input, const Read_options& options)
  : lines_(input)
{
  read_header();
  if(options.decimal && format_ != Format::ASCII)
    throw Error(input.name(), "--decimal needs coordinates as text, and this file is binary");
  skip_to_vertices();
  choose_coordinates(options.dimension);
}

bool Ply_reader::next(Row& row)
{
  if(count_ == elements_.front().count)
    return false;
  if(format_ == Format::ASCII)
    read_text(row);
  else
    read_binary(row);
  ++count_;
  return true;
}

void Ply_reader::read_header()
{
  std::string line;
  if(!lines_.next(line) || line != "ply")
    throw Error(lines_.file(), "does not begin with a line 'ply'");
  while(lines_.next(line)) {
    const std::vector<std::string> texts = words(line, 6);
    const std::string keyword = texts.empty() ? "comment" : texts.front();
    if(keyword == "end_header")
      return;
    if(keyword == "format" && texts.size() == 3)
      format_ = format_named(texts[1]);
    else if(keyword == "element" && texts.size() == 3 && parse_count(texts[2]))
      elements_.push_back({texts[1], *parse_count(texts[2]), {}});
    else if(keyword == "property" && !elements_.empty())
      elements_.back().properties.push_back(property_of(texts));
    else if(keyword != "comment" && keyword != "obj_info")
      throw Error(lines_.file(), lines_.number(), "no line of a header: '" + line + "'");
  }
  throw Error(lines_.file(), "no end_header");
}

Ply_reader::Format Ply_reader::format_named(const std::string& name) const
{
  if(name == "ascii")
    return Format::ASCII;
  if(name == "binary_little_endian")
    return Format::BINARY_LITTLE_ENDIAN;
  if(name == "binary_big_endian")
    return Format::BINARY_BIG_ENDIAN;
  throw Error(lines_.file(), lines_.number(), "unknown format '" + name + "'");
}

// Reads "property <type> <name>" or "property list <type> <type> <name>".
Ply_property Ply_reader::property_of(const std::vector<std::string>& texts) const
{
  if(texts.size() == 3)
    return {texts[2], &type_named(texts[1]), nullptr};
  if(texts.size() != 5 || texts[1] != "list")
    throw Error(lines_.file(), lines_.number(), "a property has a type and a name");
  const Ply_type& count_type = type_named(texts[2]);
  if(count_type.kind == Ply_type::FLOATING)
    throw Error(lines_.file(), lines_.number(), "the length of a list is no integer");
  return {texts[4], &type_named(texts[3]), &count_type};
}

const Ply_type& Ply_reader::type_named(const std::string& name) const
{
  for(const Ply_type& type : types)
    if(name == type.name || name == type.other_name)
      return type;
  throw Error(lines_.file(), lines_.number(), "unknown type '" + name + "'");
}

// Every item that is skipped has a line or at least a byte, so that the time depends on the size of
// the file and not on what the header promises.
void Ply_reader::skip_to_vertices()
{
  auto element = elements_.begin();
  for(; element != elements_.end(); ++element) {
    if(element->name == "vertex" || element->name == "vertices")
      break;
    if(!element->properties.empty())
      for(std::size_t i = 0; i < element->count; ++i)
        skip_item(*element);
  }
  elements_.erase(elements_.begin(), element);
  if(elements_.empty())
    throw Error(lines_.file(), "the header has no element vertex");
}

void Ply_reader::skip_item(const Ply_element& element)
{
  std::string line;
  if(format_ == Format::ASCII) {
    if(!lines_.next(line))
      cut_off();
    return;
  }
  for(const Ply_property& property : element.properties) {
    double length = 1;
    if(is_list(property)) {
      if(!lines_.read_bytes(bytes_, property.count_type->bytes))
        cut_off();
      length = number_at(0, *property.count_type);
    }
    if(length < 0 || !lines_.skip_bytes(static_cast<std::size_t>(length) * property.type->bytes))
      cut_off();
  }
}

void Ply_reader::choose_coordinates(int wanted)
{
  const std::vector<Ply_property>& properties = elements_.front().properties;
  if(std::any_of(properties.begin(), properties.end(), is_list))
    throw Error(lines_.file(), "vertices with lists are not read");
  for(dimension = 0; dimension < 3; ++dimension) {
    const auto has_name = [&](const Ply_property& p) { return p.name == names[dimension]; };
    const auto place = std::find_if(properties.begin(), properties.end(), has_name);
    if(place == properties.end())
      break;
    columns_[dimension] = place - properties.begin();
    offsets_[dimension] = 0;
    for(auto before = properties.begin(); before != place; ++before)
      offsets_[dimension] += before->type->bytes;
  }
  if(dimension < std::max(wanted, 2))
    throw Error(lines_.file(), "the vertices have no property " + names[dimension]);
  if(wanted != 0)
    dimension = wanted;
  for(const Ply_property& property : properties)
    bytes_per_vertex_ += property.type->bytes;
}

void Ply_reader::read_text(Row& row)
{
  const std::size_t wanted = elements_.front().properties.size();
  std::vector<std::string> texts;
  for(std::string line; texts.empty(); texts = words(line, wanted))
    if(!lines_.next(line))
      cut_off();
  row.line = lines_.number();
  if(texts.size() < wanted)
    throw Error(lines_.file(), row.line, plural(texts.size(), "number") + " where "
                + std::to_string(wanted) + " are needed");
  for(int axis = 0; axis < dimension; ++axis)
    row.coordinates[axis] = texts[columns_[axis]];
}

void Ply_reader::read_binary(Row& row)
{
  if(!lines_.read_bytes(bytes_, bytes_per_vertex_))
    cut_off();
  row.line = lines_.number();
  for(int axis = 0; axis < dimension; ++axis) {
    const double value
      = number_at(offsets_[axis], *elements_.front().properties[columns_[axis]].type);
    if(!std::isfinite(value))
      throw Error(lines_.file(), "vertex " + std::to_string(count_) + " (from 0) is not finite");
    row.coordinates[axis] = text_of(value);
  }
}

// The number that begins at a place of bytes_.
double Ply_reader::number_at(std::size_t offset, const Ply_type& type) const
{
  std::uint64_t bits = 0;
  for(std::size_t i = 0; i < type.bytes; ++i) {
    const std::size_t from_high = format_ == Format::BINARY_BIG_ENDIAN ? i : type.bytes - 1 - i;
    bits = bits << 8 | static_cast<unsigned char>(bytes_[offset + from_high]);
  }
  if(type.kind == Ply_type::FLOATING)
    return type.bytes == 8 ? floating<double>(bits)
                           : floating<float>(static_cast<std::uint32_t>(bits));
  const double value = static_cast<double>(bits); // of 32 bits at most
  const bool is_negative = type.kind == Ply_type::SIGNED && bits >> (8 * type.bytes - 1) != 0;
  return is_negative ? value - std::ldexp(1., static_cast<int>(8 * type.bytes)) : value;
}

void Ply_reader::cut_off() const
{
  throw Error(lines_.file(), "the file ends before the vertices do");
}

} // namespace near_pairs
