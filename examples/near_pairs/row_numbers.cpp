// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Texts to numbers; see row_numbers.h.

#include "row_numbers.h"

#include "error.h"
#include "scene.h"

#include <cmath>
#include <optional>
#include <string>

namespace near_pairs {
namespace {

bool has_decimal_comma(std::string text)
{
  const std::size_t comma = text.find(',');
  if(comma == std::string::npos)
    return false;
  text[comma] = '.';
  return parse_decimal(text).has_value();
}

// Says what is wrong with coordinate `axis` of a row.
Error bad_coordinate(const Place& place, int axis)
{
  const std::string name = place.reader.names[axis];
  const std::string& text = place.row.coordinates[axis];
  const std::string what = has_decimal_comma(text)
    ? " has a comma in the place of the decimal point" : " is no finite number";
  return Error(place.input.name(), place.row.line,
               text.empty() ? name + " is empty" : name + ": '" + text + "'" + what);
}

// Reads degrees of at most so many in both directions.
double read_degrees(const Place& place, int axis, const char* what, int most)
{
  const double degrees = read_double(place, axis);
  if(std::abs(degrees) <= most)
    return degrees;
  const std::string range = std::to_string(most);
  throw Error(place.input.name(), place.row.line, place.reader.names[axis] + ": " + what + " "
              + place.row.coordinates[axis] + " is outside [-" + range + ", " + range + "]");
}

} // namespace

Decimal read_decimal(const Place& place, int axis)
{
  const std::optional<Decimal> decimal = parse_decimal(place.row.coordinates[axis]);
  if(!decimal)
    throw bad_coordinate(place, axis);
  return *decimal;
}

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

std::array<double, 3> place_on_sphere(const Place& place)
{
  const double radian = std::acos(-1.) / 180;
  const double latitude = read_degrees(place, 0, "latitude", 90);
  const double longitude = read_degrees(place, 1, "longitude", 360);
  const double ring = earth_radius * std::cos(latitude * radian);
  return {ring * std::cos(longitude * radian), ring * std::sin(longitude * radian),
          earth_radius * std::sin(latitude * radian)};
}

} // namespace near_pairs
