// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The points of the input as numbers, checked: what is searched, drawn and written.

#ifndef NEAR_PAIRS_SCENE_H
#define NEAR_PAIRS_SCENE_H

#include "cell.h"
#include "exact_number.h"
#include "frame.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace near_pairs {

// Coordinates are held once, point after point: as doubles where these are the values to search
// with, which is nearly always, or as exact numbers where --decimal met integers beyond 53 bits.
// With --decimal the doubles are the coordinates of the file times 10^scale, all of them integers;
// exact numbers are the coordinates as they are, and the scale is 0.
struct Scene
{
  int dimension = 0;
  std::vector<double> doubles;
  Exact_numbers exact; // in use iff not empty
  int scale = 0;

  // The points of the first of two files, which come first. Pairs have a point of each file then.
  std::optional<std::size_t> first_size;

  std::optional<Cell> cell; // if the scene repeats, in the unit of the file; it has doubles then

  // Of the points in their files, if rows may have been skipped.
  std::vector<std::size_t> rows;
  std::vector<std::size_t> skipped; // how many, in each file

  std::vector<Frame> frames; // that were read, of each file

  std::vector<std::string> ids; // of the points, if pairs are to be named and a file has ids
  std::vector<std::array<std::string, 3>> names; // of the coordinates, in each file
  bool is_geographic = false; // coordinates are computed, in meters from the center of a sphere
  std::string unit; // of the distance; empty if the files do not tell one
  bool has_degrees = false; // in one of the files, taken as numbers in the plane

  // What a distance may be wrong by because decimals of few digits are rounded to doubles; 0 if
  // none are, as with --decimal.
  double rounding = 0;

  // The columns of each file that were guessed by their names, for the summary; none: empty.
  std::vector<std::string> guessed;

  std::size_t size() const;

  // Of a point among the rows of its file.
  std::size_t position(std::size_t point) const;
  int file(std::size_t point) const; // 1 or 2

  // In the unit of the file, rounded. The difference is that of point i and an image of point j.
  double coordinate(std::size_t point, int axis) const;
  std::array<double, 3> difference(std::size_t i, std::size_t j, const Offset& offset) const;
  double distance(std::size_t i, std::size_t j, const Offset& offset) const;

  // The component of the difference, in a scene that repeats.
  Exact_number exact_difference(std::size_t i, std::size_t j, const Offset& offset,
                                int axis) const;

  // As they were in the file, rounded: latitude and longitude if the scene is geographic.
  int columns() const;
  double column(std::size_t point, int axis) const;

  // Longitude and latitude. The scene must be geographic, or have them as x and y.
  std::array<double, 2> degrees(std::size_t point) const;
};

// The latitude and the longitude of a place in meters from the center of a sphere, rounded.
std::array<double, 2> degrees_of(const std::array<double, 3>& place);

// What the distance of two points, with coordinates of up to this one, may be wrong by if the
// decimals of their coordinates and of the distance are rounded to doubles: each by half a unit in
// the last place, so that a distance of up to three dimensions is wrong by less than two units.
constexpr double rounding_of(double largest_coordinate)
{
  return 4 * std::numeric_limits<double>::epsilon() * largest_coordinate;
}

// The radius of the sphere of --geographic, in meters.
constexpr double earth_radius = 6371008.8;

} // namespace near_pairs

#endif // NEAR_PAIRS_SCENE_H
