// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Gives any bytes to the parsers of decimals and times, and compares their answers with each other:
// exact number, integer at a scale, nearest double, and text.

#include "decimal.h"
#include "exact_number.h"
#include "rational.h"
#include "time_text.h"

#include <CGAL/number_utils.h> // to_double

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

namespace {

void require(bool condition)
{
  if(!condition)
    std::abort();
}

void check_decimal(const std::string& text)
{
  const std::optional<near_pairs::Decimal> decimal = near_pairs::parse_decimal(text);
  if(!decimal)
    return;
  const std::string& digits = decimal->digits;
  require(digits.empty() ? decimal->exponent == 0 && !decimal->negative
                         : digits.front() != '0' && digits.back() != '0');
  const int exponent_of_first = decimal->exponent + static_cast<int>(digits.size()) - 1;
  require(digits.empty() || std::abs(exponent_of_first) <= near_pairs::largest_exponent);

  const CGAL::Exact_rational exact = near_pairs::to_rational(*decimal);
  const double nearest = near_pairs::nearest_double(text);
  if(!std::isfinite(nearest))
    return;
  require(nearest == std::numeric_limits<double>::lowest() ||
          CGAL::Exact_rational(std::nextafter(nearest, -HUGE_VAL)) < exact);
  require(nearest == (std::numeric_limits<double>::max)() ||
          exact < CGAL::Exact_rational(std::nextafter(nearest, HUGE_VAL)));
  const std::optional<double> scaled = near_pairs::scaled_to_double(*decimal, 3);
  require(!scaled || CGAL::Exact_rational(*scaled) == CGAL::Exact_rational(exact * 1000));
}

void check_quotient(const std::string& text)
{
  const std::optional<near_pairs::Exact_number> value = near_pairs::parse_exact(text);
  // Then exact_text() stays within the largest exponent, too.
  const bool is_short = text.size() < near_pairs::largest_exponent / 4
                        && text.find_first_of("eE") == std::string::npos;
  if(value && !near_pairs::is_negative(*value) && is_short) {
    const auto again = near_pairs::parse_exact(near_pairs::exact_text(*value));
    require(again && (*again)->value == (*value)->value);
  }
}

void check_time(const std::string& text)
{
  const std::optional<near_pairs::Time> time = near_pairs::parse_time(text);
  if(!time || time->exponent > 0) // ticks are no longer than seconds
    return;
  const near_pairs::Moment moment = {time->digits, 0, -time->exponent};
  const auto again = near_pairs::parse_time(near_pairs::time_text(moment, time->form));
  require(again && near_pairs::are_comparable(again->form, time->form));
  require(again->digits == time->digits && again->exponent == time->exponent);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  check_decimal(text);
  check_quotient(text);
  check_time(text);
  return 0;
}
