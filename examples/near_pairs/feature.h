// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Features of files, checked, with what the file tells of them: points, lines and polygons in the
// plane, or solids in space.

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

// Triangles in space, by the positions of their corners.
struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  bool is_closed = false;     // each edge is one of an even number of triangles
  std::size_t bent_faces = 0; // of the file, whose corners are in no plane
};

// All parts together are one feature, which may have none. Solids have a mesh, and features in the
// plane have none.
struct Feature
{
  std::vector<Vertices> lines;                 // a point is a line of one vertex
  std::vector<std::vector<Vertices>> polygons; // rings, the outer one first; none is closed
  Mesh mesh;
  std::string id;
  std::string properties; // as an object of JSON, or empty
  bool is_skipped = false; // a row of a table that --skip-missing leaves out; it has no parts
};

// Whether the file has features: WKT, GeoJSON, or solids.
bool has_features(const std::string& file, const Read_options& options);

// Reads the features of such a file, or the points of any other one. Throws Error, with the line or
// the member, if anything in the file cannot be taken at its word. `system` is the SRID that a file
// has told before, or empty: coordinates of two systems of reference cannot be compared.
std::vector<Feature> read_features(const Input& input, const Read_options& options,
                                   std::string& system);

// Readers of one format. A geometry of WKT is a feature, and begins on a line of its own; a line
// that begins with # is a comment. Solids are those that a mesh names, or one without an id.
std::vector<Feature> read_wkt(const Input& input, std::string& system);
std::vector<Feature> read_geojson(const Input& input, const Read_options& options);
std::vector<Feature> read_solids(const Input& input, const Read_options& options);

// Add a part to a feature, which has no such part if there are no vertices. They return what is
// wrong with the part, or an empty text. The rings of a file end where they begin.
std::string add_line(Feature& feature, Vertices vertices);
std::string add_polygon(Feature& feature, std::vector<Vertices> rings);

// Geometries may be nested so deep, which no file needs.
constexpr int deepest_geometry = 20;

} // namespace near_pairs

#endif // NEAR_PAIRS_FEATURE_H
