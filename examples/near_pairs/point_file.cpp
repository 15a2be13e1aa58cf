// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rows of text to a scene; see point_file.h.

#include "point_file.h"

#include "decimal.h"
#include "error.h"
#include "input.h"
#include "point_stream.h"
#include "row_numbers.h"
#include "row_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace near_pairs {
namespace {

class Scene_maker
{
public:
  Scene_maker(const Options& options, const std::function<void(const Place&)>& and_then)
    : options_(options), and_then_(and_then)
  {
    for(const std::string& file : options.files)
      inputs_.emplace_back(file, options.progress);
  }

  // With --decimal the input is read twice, so that no text is kept: once for the scale, once for
  // the integers.
  Scene make()
  {
    if(options_.decimal)
      scene_.scale = common_scale();
    scene_.cell = options_.cell;
    for(std::size_t file = 0; file < inputs_.size(); ++file) {
      if(file == 1)
        scene_.first_size = scene_.size();
      add(inputs_[file], options_.readings[file]);
      if(options_.skip_missing) // of other files than tables, all rows are points
        for(std::size_t point = scene_.rows.size(); point < scene_.size(); ++point)
          scene_.rows.push_back(point - scene_.first_size.value_or(0));
    }
    if(!scene_.ids.empty())
      scene_.ids.resize(scene_.size());
    check_cell();
    if(has_rounded_decimals_)
      scene_.rounding = rounding_of(largest_coordinate());
    return std::move(scene_);
  }

private:
  double largest_coordinate() const
  {
    double largest = 0;
    for(double coordinate : scene_.doubles)
      largest = std::max(largest, std::abs(coordinate));
    return largest;
  }

  // The least scale at which every coordinate is an integer.
  int common_scale() const
  {
    int scale = 0;
    for(std::size_t file = 0; file < inputs_.size(); ++file) {
      const Input& input = inputs_[file];
      if(is_binary(input, options_.readings[file]))
        throw Error(input.name(), "--decimal is for numbers that are written in decimal");
      const auto reader = open_rows(input, options_.readings[file]);
      for(Row row; reader->next(row); )
        for(int axis = 0; axis < reader->dimension; ++axis)
          scale = std::max(scale, -read_number({input, *reader, row}, axis).decimal.exponent);
    }
    return scale;
  }

  void add(const Input& input, const Read_options& reading)
  {
    if(is_binary(input, reading)) {
      add_binary(input, reading);
      return;
    }
    const auto reader = open_rows(input, reading);
    begin(input, reader->dimension, reader->names, reader->unit);
    const bool names_points
      = options_.closest || !options_.pairs.empty() || !options_.points.empty();
    const bool keeps_ids = reader->has_ids && names_points;
    for(Row row; reader->next(row); ) {
      const Place place = {input, *reader, row};
      add_point(place);
      and_then_(place);
      if(reading.skip_missing)
        scene_.rows.push_back(row.position);
      if(keeps_ids) {
        scene_.ids.resize(scene_.size() - 1); // points of a file without ids have empty ones
        scene_.ids.push_back(row.id);
      }
    }
    scene_.skipped.push_back(reader->skipped);
    scene_.guessed.push_back(guessed_columns(*reader));
    scene_.frames.push_back(reader->frame);
    if(options_.is_periodic && !options_.cell)
      take_cell(input, *reader);
  }

  // Two files may tell the same cell, or one of them.
  void take_cell(const Input& input, const Row_reader& reader)
  {
    try {
      const std::optional<Cell> cell = reader.cell();
      if(cell && scene_.cell && cell_in_words(*cell) != cell_in_words(*scene_.cell))
        throw Error("the cell is not that of " + inputs_.front().name());
      if(cell)
        scene_.cell = cell;
    }
    catch(const Error& error) {
      throw Error(input.name(), reader.line_of_cell, error.what());
    }
  }

  void check_cell() const
  {
    if(options_.is_periodic && !scene_.cell)
      throw Error(inputs_.front().name(), "no cell, which is Lattice in .xyz, CRYST1 in .pdb or "
                  "_cell in .cif; give sides, as --periodic 1,1,1");
    if(scene_.cell && scene_.cell->vectors.size() != std::size_t(scene_.dimension))
      throw Error("--periodic: the cell has " + std::to_string(scene_.cell->vectors.size())
                  + " dimensions, and points have " + plural(scene_.dimension, "coordinate"));
  }

  void add_binary(const Input& input, const Read_options& reading)
  {
    Point_stream points(input, reading);
    begin(input, points.dimension(), {"x", "y", "z"}, "");
    scene_.skipped.push_back(0);
    scene_.guessed.emplace_back();
    scene_.frames.push_back(points.frame());
    for(std::array<double, 3> point; points.next(point); )
      scene_.doubles.insert(scene_.doubles.end(), point.begin(),
                            point.begin() + scene_.dimension);
  }

  // A distance has a unit if both files have it.
  void begin(const Input& input, int dimension, const std::array<std::string, 3>& names,
             const std::string& unit_of_file)
  {
    if(scene_.first_size && dimension != inputs_dimension_ && !options_.geographic)
      throw Error(input.name(), "has " + std::to_string(dimension) + " coordinates, and "
                  + inputs_.front().name() + " has " + std::to_string(inputs_dimension_)
                  + "; choose with --dimension or --columns");
    inputs_dimension_ = dimension;
    scene_.dimension = options_.geographic ? 3 : dimension;
    scene_.is_geographic = options_.geographic;
    scene_.names.push_back(names);
    const std::string unit = options_.geographic ? "m" : unit_of_file;
    scene_.unit = scene_.first_size && unit != scene_.unit ? "" : unit;
    scene_.has_degrees = scene_.has_degrees || unit == "deg";
  }

  void add_point(const Place& place)
  {
    if(options_.geographic)
      add_on_sphere(place);
    else
      for(int axis = 0; axis < scene_.dimension; ++axis)
        if(options_.decimal)
          add_decimal(place, axis);
        else
          add_double(place, axis);
  }

  void add_double(const Place& place, int axis)
  {
    const Number number = read_number(place, axis);
    scene_.doubles.push_back(number.value);
    has_rounded_decimals_ = has_rounded_decimals_ || is_rounded(number.decimal);
  }

  void add_on_sphere(const Place& place)
  {
    const std::array<double, 3> coordinates = place_on_sphere(place);
    scene_.doubles.insert(scene_.doubles.end(), coordinates.begin(), coordinates.end());
  }

  void add_decimal(const Place& place, int axis)
  {
    const Decimal decimal = read_number(place, axis).decimal;
    const std::optional<double> value = scaled_to_double(decimal, scene_.scale);
    if(scene_.exact.empty() && value) {
      scene_.doubles.push_back(*value);
      return;
    }
    if(options_.kernel != "exact")
      throw Error(place.input.name(), place.row.line, "--decimal: " + place.row.coordinates[axis]
                  + " times 10^" + std::to_string(scene_.scale)
                  + " exceeds 53 bits"
                  + (options_.is_periodic ? "" : "; use --kernel exact"));
    if(scene_.exact.empty())
      switch_to_exact();
    scene_.exact.add(decimal);
  }

  // From here on the scene is held as exact numbers, as they are in the file: at the scale of the
  // least one, the others could be longer than the whole file.
  void switch_to_exact()
  {
    scene_.exact.add_scaled(scene_.doubles, scene_.scale);
    std::vector<double>().swap(scene_.doubles);
    scene_.scale = 0;
  }

  const Options& options_;
  const std::function<void(const Place&)>& and_then_;
  std::vector<Input> inputs_;
  int inputs_dimension_ = 0; // coordinates per row
  bool has_rounded_decimals_ = false;
  Scene scene_;
};

} // namespace

Scene read_scene(const Options& options)
{
  return read_scene(options, [](const Place&) {});
}

Scene read_scene(const Options& options, const std::function<void(const Place&)>& and_then)
{
  return Scene_maker(options, and_then).make();
}

} // namespace near_pairs
