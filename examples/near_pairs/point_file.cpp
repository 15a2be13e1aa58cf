// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rows of text to a scene; see point_file.h.

#include "point_file.h"

#include "decimal.h"
#include "error.h"
#include "exact_decimal.h"
#include "input.h"
#include "row_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace near_pairs {
namespace {

// The row in hand, and where it comes from.
struct Place
{
  const Input& input;
  const Row_reader& reader;
  const Row& row;
};

// Says what is wrong with coordinate `axis` of a row.
Error bad_coordinate(const Place& place, int axis)
{
  const std::string name = place.reader.names[axis];
  const std::string& text = place.row.coordinates[axis];
  return Error(place.input.name(), place.row.line,
               text.empty() ? name + " is empty" : name + ": '" + text + "' is no finite number");
}

Decimal read_decimal(const Place& place, int axis)
{
  const std::optional<Decimal> decimal = parse_decimal(place.row.coordinates[axis]);
  if(!decimal)
    throw bad_coordinate(place, axis);
  return *decimal;
}

// Of a text that is a decimal.
double finite_double(const Place& place, int axis)
{
  const double value = nearest_double(place.row.coordinates[axis]);
  if(!std::isfinite(value))
    throw bad_coordinate(place, axis);
  return value;
}

double read_double(const Place& place, int axis)
{
  read_decimal(place, axis);
  return finite_double(place, axis);
}

class Scene_maker
{
public:
  explicit Scene_maker(const Options& options)
    : options_(options)
  {
    for(const std::string& file : options.files)
      inputs_.emplace_back(file);
  }

  // With --decimal the input is read twice, so that no text is kept: once for the scale, once for
  // the integers.
  Scene make()
  {
    if(options_.decimal)
      scene_.scale = common_scale();
    add(inputs_.front());
    if(inputs_.size() == 2) {
      scene_.first_size = scene_.size();
      add(inputs_.back());
    }
    if(!scene_.ids.empty())
      scene_.ids.resize(scene_.size());
    return std::move(scene_);
  }

private:
  // The least scale at which every coordinate is an integer.
  int common_scale() const
  {
    int scale = 0;
    for(const Input& input : inputs_) {
      const auto reader = open_rows(input, options_);
      for(Row row; reader->next(row); )
        for(int axis = 0; axis < reader->dimension; ++axis)
          scale = std::max(scale, -read_decimal({input, *reader, row}, axis).exponent);
    }
    return scale;
  }

  void add(const Input& input)
  {
    const auto reader = open_rows(input, options_);
    begin(input, *reader);
    const bool names_points
      = options_.closest || !options_.pairs.empty() || !options_.points.empty();
    const bool keeps_ids = reader->has_ids && names_points;
    for(Row row; reader->next(row); ) {
      add_point({input, *reader, row});
      if(keeps_ids) {
        scene_.ids.resize(scene_.size() - 1); // points of a file without ids have empty ones
        scene_.ids.push_back(row.id);
      }
    }
  }

  void begin(const Input& input, const Row_reader& reader)
  {
    if(scene_.first_size && reader.dimension != inputs_dimension_)
      throw Error(input.name(), "has " + std::to_string(reader.dimension) + " coordinates, and "
                  + inputs_.front().name() + " has " + std::to_string(inputs_dimension_)
                  + "; choose with --dimension or --columns");
    inputs_dimension_ = reader.dimension;
    scene_.dimension = options_.geographic ? 3 : reader.dimension;
    scene_.is_geographic = options_.geographic;
    scene_.names = reader.names;
    scene_.unit = options_.geographic ? "m" : reader.unit;
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
    const std::size_t short_digits = 15; // more of them may be a double that was printed
    const Decimal decimal = read_decimal(place, axis);
    scene_.doubles.push_back(finite_double(place, axis));
    scene_.has_short_decimals |= decimal.exponent < 0 && decimal.digits.size() <= short_digits;
  }

  void add_on_sphere(const Place& place)
  {
    const double radian = std::acos(-1.) / 180;
    const double latitude = read_double(place, 0);
    const double longitude = read_double(place, 1);
    if(std::abs(latitude) > 90)
      throw Error(place.input.name(), place.row.line, place.reader.names[0] + ": latitude "
                  + place.row.coordinates[0] + " is outside [-90, 90]");
    const double ring = earth_radius * std::cos(latitude * radian);
    scene_.doubles.push_back(ring * std::cos(longitude * radian));
    scene_.doubles.push_back(ring * std::sin(longitude * radian));
    scene_.doubles.push_back(earth_radius * std::sin(latitude * radian));
  }

  void add_decimal(const Place& place, int axis)
  {
    const Decimal decimal = read_decimal(place, axis);
    const std::optional<double> value = scaled_to_double(decimal, scene_.scale);
    if(scene_.exact.empty() && value) {
      scene_.doubles.push_back(*value);
      return;
    }
    finite_double(place, axis); // the search of numbers that no double encloses takes all pairs
    if(options_.kernel != "exact")
      throw Error(place.input.name(), place.row.line, "--decimal: " + place.row.coordinates[axis]
                  + " times 10^" + std::to_string(scene_.scale)
                  + " exceeds 53 bits; use --kernel exact");
    if(scene_.exact.empty())
      switch_to_exact();
    scene_.exact.push_back(to_rational(decimal));
  }

  // From here on the scene is held as exact numbers, as they are in the file: at the scale of the
  // least one, the others could be longer than the whole file.
  void switch_to_exact()
  {
    const CGAL::Exact_rational unit = power_of_ten(-scene_.scale);
    scene_.exact.reserve(scene_.doubles.size());
    for(double value : scene_.doubles)
      scene_.exact.push_back(CGAL::Exact_rational(CGAL::Exact_rational(value) * unit));
    std::vector<double>().swap(scene_.doubles);
    scene_.scale = 0;
  }

  const Options& options_;
  std::vector<Input> inputs_;
  int inputs_dimension_ = 0; // coordinates per row
  Scene scene_;
};

} // namespace

Scene read_scene(const Options& options)
{
  return Scene_maker(options).make();
}

} // namespace near_pairs
