// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The outputs that other programs read: tables in CSV, and maps in GeoJSON (RFC 7946).

#ifndef NEAR_PAIRS_TABLES_H
#define NEAR_PAIRS_TABLES_H

#include "groups.h"
#include "scene.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

namespace near_pairs {

// Receives the pairs one by one, and then the end.
class Pair_writer
{
public:
  virtual ~Pair_writer() = default;
  virtual void add(std::size_t i, std::size_t j, const Offset& offset) = 0;
  virtual void finish() {}
};

// Throws Error if the name of the file is that of a map, and the scene is none.
void check_map(const std::string& file, const Scene& scene);

// Writes pairs to the stream: their positions in the files, the offset of the image of the second
// point if the scene repeats, ids if the scene has them, coordinates of the points if they are
// wanted, and the distance, rounded for reading. A file that ends in .geojson is a map
// with a line for each pair; all others are tables.
std::unique_ptr<Pair_writer> make_pair_writer(const std::string& file, std::ostream& stream,
                                              const Scene& scene, bool with_coordinates);

// Writes the points likewise: with the number of their neighbors, and that of their component.
void write_points(const std::string& file, std::ostream& stream, const Scene& scene,
                  const Groups& groups, bool with_coordinates);

} // namespace near_pairs

#endif // NEAR_PAIRS_TABLES_H
