// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Texts to numbers; see row_numbers.h.

#include "row_numbers.h"

#include "error.h"
#include "scene.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace near_pairs {
namespace {

// Whether commas part the thousands of a number, as in 1,234,567.8 or 1,234.
bool has_thousands(std::string text)
{
  const std::size_t first = text.find(',');
  for(std::size_t comma; (comma = text.find(',')) != std::string::npos; text.erase(comma, 1)) {
    const std::size_t end = text.find_first_not_of("0123456789", comma + 1);
    if(std::min(end, text.size()) != comma + 4)
      return false;
  }
  return first != std::string::npos && parse_decimal(text).has_value();
}

// What is wrong with the text of a coordinate, and what to do.
std::string fault_of(const std::string& text, const Row_reader& reader)
{
  const std::string word = text.empty() ? " is empty" : ": '" + text + "'";
  if(has_thousands(text))
    return word + " has a comma between thousands"
           + (reader.is_table && has_decimal_comma(text)
                ? ", or in the place of the decimal point, where --comma-numbers takes it" : "");
  if(has_decimal_comma(text))
    return word + " has a comma in the place of the decimal point"
           + (reader.is_table ? "; --comma-numbers takes it" : "");
  return word + (text.empty() ? "" : " is no finite number")
         + (is_missing(text) ? reader.advice_on_missing() : "");
}

Error bad_coordinate(const Place& place, int axis, const std::string& fault)
{
  return Error(place.input.name(), place.row.line, place.reader.names[axis] + fault);
}

// Checks one of the degrees of a row.
void check_degrees(const Place& place, int axis, double degrees)
{
  const bool is_latitude = axis == place.reader.latitude_axis;
  const int most = is_latitude ? 90 : 360;
  if(std::abs(degrees) <= most)
    return;
  const std::string& text = place.row.coordinates[axis];
  const std::string range = std::to_string(most);
  throw bad_coordinate(place, axis, (is_latitude ? ": latitude " : ": longitude ") + text
                       + " is outside [-" + range + ", " + range + "]"
                       + (is_latitude && degrees == 91 && place.reader.is_table
                            ? place.reader.advice_on_missing()
                          : place.reader.latitude_axis == 1 ? "; --columns takes any numbers"
                                                            : ""));
}

// The double next to the longitude in (-180, 180] that is the same one: 359.9 is -0.1, which is
// another double than 359.9 - 360.
double reduced_longitude(const Number& longitude)
{
  if(-180 < longitude.value && longitude.value <= 180)
    return longitude.value;
  const int exponent = longitude.decimal.exponent, decimals = std::max(-exponent, 0);
  std::string rest = "360" + std::string(decimals, '0');
  std::string digits = longitude.decimal.digits + std::string(std::max(exponent, 0), '0');
  digits = std::min(digits, rest); // what is rounded to 360 may be beyond it
  int borrow = 0;
  for(std::size_t at = rest.size(); at-- > 0; ) {
    const int difference = rest[at] - digits[at] - borrow;
    borrow = difference < 0;
    rest[at] = static_cast<char>('0' + difference + 10 * borrow);
  }
  const double degrees = nearest_double(rest + "e-" + std::to_string(decimals));
  return longitude.value > 0 ? -degrees : degrees;
}

} // namespace

bool is_missing(const std::string& text)
{
  const std::string word = lower_case(std::string(trimmed(text)));
  const std::initializer_list<const char*> words
    = {"", "na", "n/a", "#n/a", "<na>", "nan", "-nan", "null", "(null)", "\\n", "none", "nil",
       "-", "--", ".", "?"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool has_decimal_comma(const std::string& text)
{
  const std::size_t comma = text.find(',');
  return comma != std::string::npos
         && parse_decimal(std::string(text).replace(comma, 1, 1, '.')).has_value();
}

Number read_number(const Place& place, int axis)
{
  const std::string& text = place.row.coordinates[axis];
  std::optional<Decimal> decimal = parse_decimal(text);
  const double value = decimal ? nearest_double(text) : 0;
  if(!decimal || !std::isfinite(value))
    throw bad_coordinate(place, axis, fault_of(text, place.reader));
  if(place.reader.latitude_axis != -1 && axis < 2)
    check_degrees(place, axis, value);
  return {std::move(*decimal), value};
}

std::array<double, 3> place_on_sphere(const Place& place)
{
  const double radian = std::acos(-1.) / 180;
  const double latitude = read_number(place, 0).value;
  const double longitude = reduced_longitude(read_number(place, 1));
  const double altitude
    = place.reader.dimension == 3 ? read_number(place, 2).value * place.reader.altitude_unit : 0;
  const double radius = earth_radius + altitude;
  if(radius <= 0) // the place would be on the other side
    throw bad_coordinate(place, 2, ": " + place.row.coordinates[2] + " is too low: the center of "
                         "the sphere is not below it");
  if(!std::isfinite(radius))
    throw bad_coordinate(place, 2, ": " + place.row.coordinates[2] + " is too high");
  if(std::abs(latitude) == 90) // with any longitude
    return {0, 0, std::copysign(radius, latitude)};
  const double ring = radius * std::cos(latitude * radian);
  return {ring * std::cos(longitude * radian), ring * std::sin(longitude * radian),
          radius * std::sin(latitude * radian)};
}

} // namespace near_pairs
