// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Files to features; see feature.h.

#include "feature.h"

#include "error.h"
#include "point_stream.h"
#include "row_numbers.h"
#include "row_reader.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>

namespace near_pairs {
namespace {

// Rows that are left out are features, too, so that the others have their positions.
std::vector<Feature> read_points(const Input& input, const Read_options& options)
{
  if(is_binary(input, options))
    throw Error(input.name(), "features are in the plane, and so are no points of .bin files");
  const std::unique_ptr<Row_reader> reader = open_rows(input, options);
  if(reader->dimension != 2)
    throw Error(input.name(), "features are in the plane; choose two axes with --dimension 2");
  std::vector<Feature> features;
  Feature skipped;
  skipped.is_skipped = true;
  std::size_t points = 0;
  for(Row row; reader->next(row); ++points) {
    features.resize(points + reader->skipped, skipped);
    const Place place = {input, *reader, row};
    Feature point;
    point.lines = {{{read_number(place, 0).value, read_number(place, 1).value}}};
    point.id = row.id;
    features.push_back(std::move(point));
  }
  features.resize(points + reader->skipped, skipped);
  return features;
}

} // namespace

bool has_features(const std::string& file, const Read_options& options)
{
  const std::initializer_list<const char*> formats
    = {"wkt", "geojson", "json", "geojsonl", "geojsons", "ndjson"};
  return options.solids
         || std::find(formats.begin(), formats.end(), format_of(file, options)) != formats.end();
}

std::vector<Feature> read_features(const Input& input, const Read_options& options,
                                   std::string& system)
{
  if(!has_features(input.name(), options))
    return read_points(input, options);
  Read_options for_tables = options;
  for_tables.id.clear(); // a property of GeoJSON, and the files may be of two formats
  refuse_options_for_tables(input, for_tables);
  if(options.skip_missing)
    throw Error(input.name(), "--skip-missing is for points: features may be empty");
  if(options.solids)
    return read_solids(input, options);
  return format_of(input.name(), options) == "wkt" ? read_wkt(input, system)
                                                   : read_geojson(input, options);
}

std::string add_line(Feature& feature, Vertices vertices)
{
  if(vertices.size() == 1)
    return "a line has fewer than two positions";
  if(!vertices.empty())
    feature.lines.push_back(std::move(vertices));
  return "";
}

std::string add_polygon(Feature& feature, std::vector<Vertices> rings)
{
  const auto is_empty = [](const Vertices& ring) { return ring.empty(); };
  const bool is_outer_empty = !rings.empty() && rings.front().empty();
  rings.erase(std::remove_if(rings.begin(), rings.end(), is_empty), rings.end());
  if(is_outer_empty && !rings.empty())
    return "a polygon has holes and no outer ring";
  for(Vertices& ring : rings) {
    if(ring.size() < 4)
      return "a ring has fewer than four positions";
    if(ring.front() != ring.back())
      return "a ring does not end where it begins";
    ring.pop_back();
  }
  if(!rings.empty())
    feature.polygons.push_back(std::move(rings));
  return "";
}

} // namespace near_pairs
