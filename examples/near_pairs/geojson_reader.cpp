// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// GeoJSON (RFC 7946): a collection of features, a feature or a geometry.

#include "feature.h"

#include "error.h"

#include <nlohmann/json.hpp>

#include <ios>
#include <utility>

namespace near_pairs {
namespace {

using nlohmann::json;

// What is wrong is thrown as std::string.
[[noreturn]] void refuse(const std::string& what)
{
  throw what;
}

// The member of an object, or null.
const json& member(const json& object, const char* name)
{
  static const json none;
  if(!object.is_object())
    refuse("an object is missing");
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

const json& list(const json& value)
{
  if(!value.is_array())
    refuse("coordinates are no list");
  return value;
}

// Heights are left out.
Vertex position(const json& value)
{
  if(list(value).size() < 2 || !value[0].is_number() || !value[1].is_number())
    refuse("a position is no list of two numbers");
  return {value[0].get<double>(), value[1].get<double>()};
}

Vertices positions(const json& value)
{
  Vertices vertices;
  for(const json& part : list(value))
    vertices.push_back(position(part));
  return vertices;
}

void add_line(const json& value, Feature& feature)
{
  feature.lines.push_back(positions(value));
  if(feature.lines.back().size() < 2)
    refuse("a line has fewer than two positions");
}

void add_polygon(const json& value, Feature& feature)
{
  std::vector<Vertices> rings;
  for(const json& ring : list(value)) {
    rings.push_back(positions(ring));
    if(const std::string wrong = open_ring(rings.back()); !wrong.empty())
      refuse(wrong);
  }
  if(!rings.empty())
    feature.polygons.push_back(std::move(rings));
}

void add_geometry(const json& geometry, Feature& feature, int depth = 0)
{
  if(geometry.is_null())
    return;
  const json& type = member(geometry, "type");
  const json& coordinates = member(geometry, "coordinates");
  if(depth > deepest_geometry)
    refuse("collections are nested too deep");
  if(type == "GeometryCollection") {
    for(const json& part : list(member(geometry, "geometries")))
      add_geometry(part, feature, depth + 1);
  }
  else if(type == "Point")
    feature.lines.push_back({position(coordinates)});
  else if(type == "MultiPoint") {
    for(const json& point : list(coordinates))
      feature.lines.push_back({position(point)});
  }
  else if(type == "LineString")
    add_line(coordinates, feature);
  else if(type == "MultiLineString") {
    for(const json& line : list(coordinates))
      add_line(line, feature);
  }
  else if(type == "Polygon")
    add_polygon(coordinates, feature);
  else if(type == "MultiPolygon") {
    for(const json& polygon : list(coordinates))
      add_polygon(polygon, feature);
  }
  else
    refuse("type " + type.dump() + " is no kind of geometry");
}

// The id of a feature, or the property that is to name it.
std::string id_of(const json& object, const std::string& property)
{
  const json& properties = member(object, "properties");
  const json& own = member(object, "id");
  const json& value = property.empty() && !own.is_null() ? own
    : properties.is_object() ? member(properties, property.empty() ? "id" : property.c_str()) : own;
  return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
}

Feature feature_of(const json& object, const std::string& id_property)
{
  Feature feature;
  if(member(object, "type") != "Feature") {
    add_geometry(object, feature);
    return feature;
  }
  add_geometry(member(object, "geometry"), feature);
  feature.id = id_of(object, id_property);
  const json& properties = member(object, "properties");
  if(properties.is_object() && !properties.empty())
    feature.properties = properties.dump();
  return feature;
}

// The library begins its messages with names of its own, in brackets.
std::string message_of(const json::exception& error)
{
  const std::string message = error.what();
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

} // namespace

std::vector<Feature> read_geojson(const Input& input, const Read_options& options)
{
  std::vector<Feature> features;
  try {
    const json file = json::parse(*input.open());
    const bool is_collection = file.is_object() && member(file, "type") == "FeatureCollection";
    const json& objects = is_collection ? member(file, "features") : file;
    if(!is_collection)
      features.push_back(feature_of(file, options.id));
    else
      for(const json& object : list(objects))
        features.push_back(feature_of(object, options.id));
  }
  catch(const json::exception& error) {
    throw Error(input.name(), message_of(error));
  }
  catch(const std::ios::failure&) { // the parser reads past the stream, which catches it
    throw Error(input.name(), "cannot be read to its end");
  }
  catch(const std::string& wrong) {
    throw Error(input.name(), "feature " + std::to_string(features.size()) + " (from 0): " + wrong);
  }
  return features;
}

} // namespace near_pairs
