// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Decimal text as exact integers: a whole file is scaled by one power of ten, so that distances
// between the printed numbers, however many digits they have, can be compared without rounding.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DECIMAL_H
#define THICK_INTERSECTION_TEST_SUPPORT_DECIMAL_H

#include "standard_library.h"

#include <boost/multiprecision/gmp.hpp>

namespace test_support {

using Decimal_integer = boost::multiprecision::mpz_int;

// The number [-]digits * 10^-decimals; decimals is negative for text such as "2e5".
struct Decimal
{
  Decimal_integer digits;
  int decimals;
};

// Reads [+-]digits[.digits][e[+-]digits].
inline Decimal parse_decimal(const std::string& text)
{
  const std::size_t exponent_at = (std::min)(text.find_first_of("eE"), text.size());
  int decimals = exponent_at == text.size() ? 0 : -std::stoi(text.substr(exponent_at + 1));
  std::string digits;
  bool after_point = false;
  for(std::size_t i = text.find_first_of("+-") == 0 ? 1 : 0; i < exponent_at; ++i) {
    if(text[i] == '.' && !after_point)
      after_point = true;
    else if(text[i] >= '0' && text[i] <= '9') {
      digits += text[i];
      decimals += after_point ? 1 : 0;
    }
    else
      throw std::invalid_argument("not a decimal number: '" + text + "'");
  }
  if(digits.empty())
    throw std::invalid_argument("not a decimal number: '" + text + "'");
  digits.erase(0, (std::min)(digits.find_first_not_of('0'), digits.size() - 1)); // not octal
  const Decimal_integer magnitude(digits);
  return {text[0] == '-' ? Decimal_integer(-magnitude) : magnitude, decimals};
}

// The value times 10^decimals; an error if that is no integer.
inline Decimal_integer scaled_decimal(const std::string& text, int decimals)
{
  const Decimal value = parse_decimal(text);
  const int shift = decimals - value.decimals;
  const Decimal_integer power =
    boost::multiprecision::pow(Decimal_integer(10), static_cast<unsigned>(std::abs(shift)));
  if(shift >= 0)
    return value.digits * power;
  if(value.digits % power != 0)
    throw std::invalid_argument("more decimals than expected: '" + text + "'");
  return value.digits / power;
}

// Points whose coordinates are coordinates[i][axis] / 10^decimals.
struct Decimal_points
{
  int dimension = 0;
  int decimals = 0;
  std::vector<std::vector<Decimal_integer>> coordinates;
};

using Text_rows = std::vector<std::vector<std::string>>;

// Scales all rows by the smallest power of ten that makes every printed number an integer.
inline Decimal_points scaled_to_integers(const Text_rows& rows)
{
  Decimal_points points;
  for(const auto& row : rows)
    for(const std::string& text : row)
      points.decimals = (std::max)(points.decimals, parse_decimal(text).decimals);
  for(const auto& row : rows) {
    points.dimension = static_cast<int>(row.size());
    points.coordinates.emplace_back();
    for(const std::string& text : row)
      points.coordinates.back().push_back(scaled_decimal(text, points.decimals));
  }
  return points;
}

using Double_rows = std::vector<std::vector<double>>;

// The scaled integers as doubles, if all of them are doubles: then any kernel of double can be
// tested on the file exactly as it is printed, with the radius scaled alike.
inline std::optional<Double_rows> as_exact_doubles(const Decimal_points& points)
{
  const Decimal_integer limit = Decimal_integer(1) << 53;
  Double_rows doubles;
  for(const auto& p : points.coordinates) {
    doubles.emplace_back();
    for(const Decimal_integer& x : p) {
      if(abs(x) > limit)
        return std::nullopt;
      doubles.back().push_back(static_cast<double>(x));
    }
  }
  return doubles;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DECIMAL_H
