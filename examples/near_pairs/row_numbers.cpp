// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Texts to numbers; see row_numbers.h.

#include "row_numbers.h"

#include "error.h"
#include "scene.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>

namespace near_pairs {
namespace {

// Says what is wrong with coordinate `axis` of a row.
Error bad_coordinate(const Place& place, int axis)
{
  const std::string name = place.reader.names[axis];
  const std::string& text = place.row.coordinates[axis];
  const bool has_comma = has_decimal_comma(text);
  const std::string what = text.empty() ? name + " is empty" : name + ": '" + text + "'"
    + (has_comma ? " has a comma in the place of the decimal point" : " is no finite number");
  const std::string advice = !place.reader.is_table ? ""
    : has_comma ? "; --comma-numbers takes it"
    : is_missing(text) ? "; --skip-missing leaves such rows out" : "";
  return Error(place.input.name(), place.row.line, what + advice);
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

bool is_missing(const std::string& text)
{
  std::string letters;
  for(char letter : text)
    letters += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const std::initializer_list<const char*> names = {"", "na", "n/a", "#n/a", "nan", "null", "none"};
  return std::find(names.begin(), names.end(), letters) != names.end();
}

bool has_decimal_comma(const std::string& text)
{
  const std::size_t comma = text.find(',');
  return comma != std::string::npos
         && parse_decimal(std::string(text).replace(comma, 1, 1, '.')).has_value();
}

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
