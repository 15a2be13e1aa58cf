// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// GeoJSON (RFC 7946): a collection of features, a feature or a geometry. A file may have several
// such texts, each behind a record separator (RFC 8142) or on a line of its own.

#include "feature.h"

#include "error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

namespace near_pairs {
namespace {

using nlohmann::json;

// What is wrong, and with which value of the text.
struct Wrong
{
  const json& value;
  std::string what;
};

// The way from a value to one inside it, as in JSON pointers (RFC 6901).
std::optional<std::string> way(const json& from, const json& to, int most_steps = 100)
{
  if(&from == &to)
    return "";
  if(most_steps != 0 && from.is_structured())
    for(const auto& [step, part] : from.items())
      if(const auto rest = way(part, to, most_steps - 1))
        return "/" + step + *rest;
  return std::nullopt;
}

const json& member_or_null(const json& object, const std::string& name)
{
  static const json none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

const json& member(const json& value, const std::string& name)
{
  if(!value.is_object())
    throw Wrong{value, "is no object"};
  if(!value.contains(name))
    throw Wrong{value, "has no member '" + name + "'"};
  return value[name];
}

const json& list(const json& value)
{
  if(!value.is_array())
    throw Wrong{value, "is no list"};
  return value;
}

// Heights are left out.
Vertex position(const json& value)
{
  if(list(value).size() < 2 || !value[0].is_number() || !value[1].is_number())
    throw Wrong{value, "is no list of two numbers"};
  return {value[0].get<double>(), value[1].get<double>()};
}

Vertices positions(const json& value)
{
  Vertices vertices;
  for(const json& part : list(value))
    vertices.push_back(position(part));
  return vertices;
}

void read_point(const json& value, Feature& feature)
{
  if(!list(value).empty())
    feature.lines.push_back({position(value)});
}

void check(const json& value, const std::string& wrong)
{
  if(!wrong.empty())
    throw Wrong{value, "is wrong: " + wrong};
}

void read_line(const json& value, Feature& feature)
{
  check(value, add_line(feature, positions(value)));
}

void read_polygon(const json& value, Feature& feature)
{
  std::vector<Vertices> rings;
  for(const json& ring : list(value))
    rings.push_back(positions(ring));
  check(value, add_polygon(feature, std::move(rings)));
}

void read_geometry(const json& geometry, Feature& feature, int depth = 0)
{
  if(geometry.is_null())
    return;
  const json& type = member(geometry, "type");
  if(depth > deepest_geometry)
    throw Wrong{type, "is nested too deep"};
  if(type == "GeometryCollection") {
    for(const json& part : list(member(geometry, "geometries")))
      read_geometry(part, feature, depth + 1);
    return;
  }
  const bool is_multiple = type.is_string() && type.get<std::string>().compare(0, 5, "Multi") == 0;
  const std::string kind = type.is_string() ? type.get<std::string>().substr(is_multiple * 5) : "";
  const auto read = kind == "Point" ? read_point : kind == "LineString" ? read_line
                    : kind == "Polygon" ? read_polygon : nullptr;
  if(read == nullptr)
    throw Wrong{type, type.dump() + " is no kind of geometry"};
  const json& coordinates = member(geometry, "coordinates");
  if(!is_multiple)
    read(coordinates, feature);
  else
    for(const json& part : list(coordinates))
      read(part, feature);
}

// The id of a feature, or the property that is to name it.
std::string id_of(const json& object, const std::string& property)
{
  const json& properties = member_or_null(object, "properties");
  const json& own = member_or_null(object, "id");
  const bool has_own = property.empty() && !own.is_null();
  const json& value
    = has_own ? own : member_or_null(properties, property.empty() ? "id" : property);
  return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
}

Feature feature_of(const json& object, const std::string& id_property)
{
  Feature feature;
  if(member(object, "type") != "Feature") {
    read_geometry(object, feature);
    return feature;
  }
  read_geometry(member(object, "geometry"), feature);
  feature.id = id_of(object, id_property);
  const json& properties = member_or_null(object, "properties");
  if(properties.is_object() && !properties.empty())
    feature.properties = properties.dump();
  return feature;
}

// Throws std::string.
void read_text(const json& text, const std::string& id_property, std::vector<Feature>& features)
{
  try {
    if(member(text, "type") != "FeatureCollection")
      features.push_back(feature_of(text, id_property));
    else
      for(const json& object : list(member(text, "features")))
        features.push_back(feature_of(object, id_property));
  }
  catch(const Wrong& wrong) {
    const std::string place = way(text, wrong.value).value_or("");
    throw (place.empty() ? "the text" : place) + " " + wrong.what;
  }
}

// The place of the next text, or the end.
std::size_t find_text(const std::string& bytes, std::size_t at)
{
  return std::min(bytes.find_first_not_of(" \t\r\n\x1E", at), bytes.size());
}

// Says what is wrong at a byte.
Error error_at(const Input& input, const std::string& bytes, std::size_t at,
               const std::string& what)
{
  const auto here = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  const std::size_t line = 1 + std::count(bytes.begin(), here, '\n');
  const std::size_t line_begin = at == 0 ? 0 : bytes.rfind('\n', at - 1) + 1;
  return Error(input.name(), line, at - line_begin + 1, what);
}

// The end of the number at a place. The library rounds integers of more than 64 bits to doubles, so
// that two ids could be one.
std::size_t end_of_number(const Input& input, const std::string& bytes, std::size_t at)
{
  const std::size_t end = std::min(bytes.find_first_not_of("+-.0123456789eE", at), bytes.size());
  const char* const first = bytes.data() + at;
  const char* const last = bytes.data() + end;
  std::int64_t negative = 0;
  std::uint64_t positive = 0;
  const auto [rest, error] = *first == '-' ? std::from_chars(first, last, negative)
                                           : std::from_chars(first, last, positive);
  if(rest == last && error == std::errc::result_out_of_range)
    throw error_at(input, bytes, at, "an integer has more than 64 bits; write it as a string");
  return end;
}

// The end of the text that begins at a place: behind its last bracket, or before the separator of
// the next one. The library writes properties by a function that calls itself, so there is a limit.
std::size_t end_of_text(const Input& input, const std::string& bytes, std::size_t at)
{
  const int most_brackets = 1000;
  int depth = 0;
  for(bool is_quoted = false; at < bytes.size() && bytes[at] != '\x1E'; ++at) {
    const char byte = bytes[at];
    if(byte == '"')
      is_quoted = !is_quoted;
    else if(is_quoted)
      at += byte == '\\';
    else if(byte == '-' || (byte >= '0' && byte <= '9'))
      at = end_of_number(input, bytes, at) - 1;
    else if((byte == '{' || byte == '[') && ++depth > most_brackets)
      throw error_at(input, bytes, at, "brackets are nested too deep");
    else if((byte == '}' || byte == ']') && --depth == 0)
      return at + 1;
  }
  return std::min(at, bytes.size());
}

// The library begins its messages with names of its own, and with the place in the text.
std::string message_of(const json::exception& error, const std::string& end_of_names)
{
  const std::string message = error.what();
  return message.substr(message.find(end_of_names) + end_of_names.size());
}

} // namespace

std::vector<Feature> read_geojson(const Input& input, const Read_options& options)
{
  const std::string bytes = input.text();
  std::vector<Feature> features;
  const std::size_t first = find_text(bytes, 0);
  if(first == bytes.size())
    throw Error(input.name(), "has no text of JSON");
  for(std::size_t begin = first, end; begin < bytes.size(); begin = find_text(bytes, end)) {
    end = end_of_text(input, bytes, begin);
    const bool is_alone = begin == first && find_text(bytes, end) == bytes.size();
    const auto wrong = [&](const std::string& what) {
      return is_alone ? Error(input.name(), what) : error_at(input, bytes, begin, what);
    };
    try {
      read_text(json::parse(bytes.begin() + begin, bytes.begin() + end), options.id, features);
    }
    catch(const json::parse_error& error) {
      throw error_at(input, bytes, std::min(begin + error.byte - 1, bytes.size()),
                     message_of(error, ": "));
    }
    catch(const json::exception& error) { // a number beyond doubles
      throw wrong(message_of(error, "] "));
    }
    catch(const std::string& what) {
      throw wrong(what);
    }
  }
  return features;
}

} // namespace near_pairs
