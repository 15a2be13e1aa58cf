// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact numbers of decimal text; see exact_decimal.h.

#include "exact_decimal.h"

#include <cstddef>
#include <cstdlib>
#include <sstream>

namespace near_pairs {

std::optional<CGAL::Exact_rational> parse_exact(std::string_view text)
{
  const std::size_t slash = text.find('/');
  const std::optional<Decimal> numerator = parse_decimal(trimmed(text.substr(0, slash)));
  if(!numerator)
    return std::nullopt;
  if(slash == std::string_view::npos)
    return to_rational(*numerator);
  const std::optional<Decimal> denominator = parse_decimal(trimmed(text.substr(slash + 1)));
  if(!denominator || denominator->digits.empty())
    return std::nullopt;
  return CGAL::Exact_rational(to_rational(*numerator) / to_rational(*denominator));
}

CGAL::Exact_rational power_of_ten(int exponent)
{
  const CGAL::Exact_rational power("1" + std::string(std::abs(exponent), '0'));
  return exponent < 0 ? CGAL::Exact_rational(1 / power) : power;
}

CGAL::Exact_rational to_rational(const Decimal& decimal)
{
  if(decimal.digits.empty())
    return CGAL::Exact_rational(0);
  const CGAL::Exact_rational digits(decimal.digits);
  const CGAL::Exact_rational value = digits * power_of_ten(decimal.exponent);
  return decimal.negative ? CGAL::Exact_rational(-value) : value;
}

std::string exact_text(const CGAL::Exact_rational& value)
{
  const auto text_of = [](const CGAL::Exact_rational& number) {
    std::ostringstream text;
    text << number;
    return text.str();
  };
  CGAL::Exact_rational scaled = value;
  for(std::size_t decimals = 0; decimals <= 30; ++decimals) {
    std::string digits = text_of(scaled);
    if(digits.find('/') == std::string::npos) {
      if(decimals != 0 && digits.size() <= decimals)
        digits.insert(0, decimals + 1 - digits.size(), '0');
      return decimals == 0 ? digits : digits.insert(digits.size() - decimals, ".");
    }
    scaled *= 10;
  }
  return text_of(value);
}

} // namespace near_pairs
