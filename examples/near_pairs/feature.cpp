// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Files to features; see feature.h.

#include "feature.h"

#include "error.h"
#include "point_stream.h"
#include "row_numbers.h"
#include "row_reader.h"

#include <memory>

namespace near_pairs {
namespace {

std::vector<Feature> read_points(const Input& input, const Read_options& options)
{
  if(is_binary(input, options))
    throw Error(input.name(), "features are in the plane, and so are no points of .bin files");
  const std::unique_ptr<Row_reader> reader = open_rows(input, options);
  if(reader->dimension != 2)
    throw Error(input.name(), "features are in the plane; choose two axes with --dimension 2");
  std::vector<Feature> features;
  for(Row row; reader->next(row); ) {
    const Place place = {input, *reader, row};
    Feature point;
    point.lines = {{{read_number(place, 0).value, read_number(place, 1).value}}};
    point.id = row.id;
    features.push_back(std::move(point));
  }
  return features;
}

} // namespace

bool has_features(const std::string& file, const Read_options& options)
{
  const std::string format = format_of(file, options);
  return format == "wkt" || format == "geojson" || format == "json";
}

std::vector<Feature> read_features(const Input& input, const Read_options& options)
{
  if(!has_features(input.name(), options))
    return read_points(input, options);
  return format_of(input.name(), options) == "wkt" ? read_wkt(input)
                                                   : read_geojson(input, options);
}

std::string open_ring(Vertices& ring)
{
  if(ring.size() < 4)
    return "a ring has fewer than four positions";
  if(ring.front() != ring.back())
    return "a ring does not end where it begins";
  ring.pop_back();
  return "";
}

} // namespace near_pairs
