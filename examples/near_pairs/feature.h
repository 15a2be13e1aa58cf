// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Features of geographic files, checked: points, lines and polygons in the plane, with what the
// file tells of them.

#ifndef NEAR_PAIRS_FEATURE_H
#define NEAR_PAIRS_FEATURE_H

#include "input.h"
#include "read_options.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace near_pairs {

using Vertex = std::array<double, 2>;
using Vertices = std::vector<Vertex>;

// All parts together are one feature, which may have none.
struct Feature
{
  std::vector<Vertices> lines;                 // a point is a line of one vertex
  std::vector<std::vector<Vertices>> polygons; // rings, the outer one first; none is closed
  std::string id;
  std::string properties; // as an object of JSON, or empty
};

// Whether the file has features: WKT or GeoJSON.
bool has_features(const std::string& file, const Read_options& options);

// Reads the features of such a file, or the points of any other one. Throws Error, with the line or
// the number of the feature, if anything in the file cannot be taken at its word.
std::vector<Feature> read_features(const Input& input, const Read_options& options);

// Readers of one format. A line of WKT is a feature; blank lines and those that begin with # are
// skipped.
std::vector<Feature> read_wkt(const Input& input);
std::vector<Feature> read_geojson(const Input& input, const Read_options& options);

// Opens a ring of a file, which ends where it begins. Returns what is wrong with it, or an empty
// text.
std::string open_ring(Vertices& ring);

// Geometries may be nested so deep, which no file needs.
constexpr int deepest_geometry = 20;

} // namespace near_pairs

#endif // NEAR_PAIRS_FEATURE_H
