// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rows of text to a scene; see point_file.h.

#include "point_file.h"

#include "decimal.h"
#include "error.h"
#include "row_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace near_pairs {
namespace {

// Says what is wrong with coordinate `axis` of a row.
Error bad_coordinate(const Options& options, const Row_reader& reader, const Row& row, int axis)
{
  const std::string name = reader.names[axis];
  const std::string& text = row.coordinates[axis];
  return Error(options.file, row.line,
               text.empty() ? name + " is empty" : name + ": '" + text + "' is no finite number");
}

double read_double(const Options& options, const Row_reader& reader, const Row& row, int axis)
{
  const std::string& text = row.coordinates[axis];
  if(!parse_decimal(text))
    throw bad_coordinate(options, reader, row, axis);
  const double value = nearest_double(text);
  if(!std::isfinite(value))
    throw bad_coordinate(options, reader, row, axis);
  return value;
}

Decimal read_decimal(const Options& options, const Row_reader& reader, const Row& row, int axis)
{
  const std::optional<Decimal> decimal = parse_decimal(row.coordinates[axis]);
  if(!decimal)
    throw bad_coordinate(options, reader, row, axis);
  return *decimal;
}

Scene empty_scene(const Row_reader& reader)
{
  Scene scene;
  scene.dimension = reader.dimension;
  scene.names = reader.names;
  scene.unit = reader.unit;
  return scene;
}

void keep_id(const Options& options, const Row_reader& reader, const Row& row, Scene& scene)
{
  if(reader.has_ids && (options.closest || !options.pairs.empty()))
    scene.ids.push_back(row.id);
}

Scene read_plain(const Options& options)
{
  const auto reader = open_rows(options);
  Scene scene = empty_scene(*reader);
  for(Row row; reader->next(row); keep_id(options, *reader, row, scene))
    for(int axis = 0; axis < scene.dimension; ++axis)
      scene.doubles.push_back(read_double(options, *reader, row, axis));
  return scene;
}

Scene read_geographic(const Options& options)
{
  const auto reader = open_rows(options);
  const double radian = std::acos(-1.) / 180;
  Scene scene = empty_scene(*reader);
  scene.dimension = 3;
  scene.unit = "m";
  for(Row row; reader->next(row); keep_id(options, *reader, row, scene)) {
    const double latitude = read_double(options, *reader, row, 0);
    const double longitude = read_double(options, *reader, row, 1);
    if(std::abs(latitude) > 90)
      throw Error(options.file, row.line, reader->names[0] + ": latitude " + row.coordinates[0]
                  + " is outside [-90, 90]");
    const double ring = earth_radius * std::cos(latitude * radian);
    scene.doubles.push_back(ring * std::cos(longitude * radian));
    scene.doubles.push_back(ring * std::sin(longitude * radian));
    scene.doubles.push_back(earth_radius * std::sin(latitude * radian));
  }
  return scene;
}

// The least scale at which every coordinate of the file is an integer.
int common_scale(const Options& options)
{
  const auto reader = open_rows(options);
  int scale = 0;
  for(Row row; reader->next(row); )
    for(int axis = 0; axis < reader->dimension; ++axis)
      scale = std::max(scale, -read_decimal(options, *reader, row, axis).exponent);
  return scale;
}

// From here on the scene is held as exact numbers, as they are in the file: at the scale of the
// least one, the others could be longer than the whole file.
void switch_to_exact(Scene& scene)
{
  const CGAL::Exact_rational unit = power_of_ten(-scene.scale);
  scene.exact.reserve(scene.doubles.size());
  for(double value : scene.doubles)
    scene.exact.push_back(CGAL::Exact_rational(CGAL::Exact_rational(value) * unit));
  std::vector<double>().swap(scene.doubles);
  scene.scale = 0;
}

// The file is read twice, so that no text is kept: once for the scale, once for the integers.
Scene read_decimals(const Options& options)
{
  const int scale = common_scale(options);
  const auto reader = open_rows(options);
  Scene scene = empty_scene(*reader);
  scene.scale = scale;
  for(Row row; reader->next(row); keep_id(options, *reader, row, scene))
    for(int axis = 0; axis < scene.dimension; ++axis) {
      const Decimal decimal = read_decimal(options, *reader, row, axis);
      const std::optional<double> value = scaled_to_double(decimal, scale);
      if(scene.exact.empty() && value) {
        scene.doubles.push_back(*value);
        continue;
      }
      // The search of numbers that no double encloses looks at all pairs.
      if(!std::isfinite(nearest_double(row.coordinates[axis])))
        throw bad_coordinate(options, *reader, row, axis);
      if(options.kernel != "exact")
        throw Error(options.file, row.line, "--decimal: " + row.coordinates[axis] + " times 10^"
                    + std::to_string(scale) + " exceeds 53 bits; use --kernel exact");
      if(scene.exact.empty())
        switch_to_exact(scene);
      scene.exact.push_back(to_rational(decimal));
    }
  return scene;
}

} // namespace

Scene read_scene(const Options& options)
{
  if(options.geographic)
    return read_geographic(options);
  return options.decimal ? read_decimals(options) : read_plain(options);
}

} // namespace near_pairs
