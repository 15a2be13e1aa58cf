// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Decimal text to numbers; see decimal.h.

#include "decimal.h"

#include <cstdint>
#include <cstdlib>
#include <utility>

namespace near_pairs {
namespace {

// Moves the digits at the front of `text` to the end of `digits`; returns how many there were.
std::int64_t take_digits(std::string_view& text, std::string& digits)
{
  std::int64_t count = 0;
  while(!text.empty() && text.front() >= '0' && text.front() <= '9') {
    digits.push_back(text.front());
    text.remove_prefix(1);
    ++count;
  }
  return count;
}

// Removes one sign from the front of `text`; returns whether it was a minus.
bool take_sign(std::string_view& text)
{
  if(text.empty() || (text.front() != '-' && text.front() != '+'))
    return false;
  const bool negative = text.front() == '-';
  text.remove_prefix(1);
  return negative;
}

// Reads what follows the "e"; a value beyond 9 digits is out of range anyway.
std::optional<int> parse_exponent(std::string_view text)
{
  const bool negative = take_sign(text);
  std::string digits;
  if(take_digits(text, digits) == 0 || !text.empty())
    return std::nullopt;
  digits.erase(0, digits.find_first_not_of('0'));
  if(digits.size() > 9)
    return std::nullopt;
  const int value = std::atoi(digits.c_str());
  return negative ? -value : value;
}

constexpr std::int64_t most_decimals = 1000000000; // so that exponents are integers

// Strips the zeros at both ends of the digits, so that the number has one form only. Returns
// nothing if the exponent is out of range.
std::optional<Decimal> normalized(bool negative, std::string digits, std::int64_t exponent)
{
  const std::size_t last = digits.find_last_not_of('0');
  if(last == std::string::npos)
    return Decimal();
  exponent += static_cast<std::int64_t>(digits.size() - 1 - last);
  digits.erase(last + 1);
  digits.erase(0, digits.find_first_not_of('0'));
  const std::int64_t of_first = exponent + static_cast<std::int64_t>(digits.size()) - 1;
  if(of_first < -largest_exponent || of_first > largest_exponent || exponent < -most_decimals)
    return std::nullopt;
  return Decimal{negative, std::move(digits), static_cast<int>(exponent)};
}

} // namespace

std::optional<Decimal> parse_decimal(std::string_view text)
{
  const bool negative = take_sign(text);
  std::string digits;
  std::int64_t exponent = 0;
  std::int64_t count = take_digits(text, digits);
  if(!text.empty() && text.front() == '.') {
    text.remove_prefix(1);
    const std::int64_t decimals = take_digits(text, digits);
    exponent = -decimals;
    count += decimals;
  }
  if(count == 0)
    return std::nullopt;
  if(!text.empty()) {
    if(text.front() != 'e' && text.front() != 'E')
      return std::nullopt;
    const std::optional<int> shift = parse_exponent(text.substr(1));
    if(!shift)
      return std::nullopt;
    exponent += *shift;
  }
  return normalized(negative, std::move(digits), exponent);
}

std::optional<double> scaled_to_double(const Decimal& decimal, int scale)
{
  const int zeros = decimal.exponent + scale;
  if(decimal.digits.empty())
    return 0.;
  if(zeros < 0 || decimal.digits.size() + zeros > 16) // 2^53 has 16 digits
    return std::nullopt;
  const std::string text = decimal.digits + std::string(zeros, '0');
  const std::uint64_t value = std::strtoull(text.c_str(), nullptr, 10);
  if(value > (std::uint64_t(1) << 53))
    return std::nullopt;
  const double magnitude = static_cast<double>(value);
  return decimal.negative ? -magnitude : magnitude;
}

double nearest_double(std::string_view text)
{
  return std::strtod(std::string(text).c_str(), nullptr); // the locale is "C": nobody sets another
}

bool is_rounded(const Decimal& decimal)
{
  const std::size_t few_digits = 15;
  if(decimal.exponent >= 0 || decimal.digits.size() > few_digits)
    return false;
  std::uint64_t digits = std::strtoull(decimal.digits.c_str(), nullptr, 10);
  for(int power = decimal.exponent; power != 0; ++power, digits /= 5)
    if(digits % 5 != 0)
      return true;
  return false;
}

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  if(first == std::string_view::npos)
    return std::string_view();
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

} // namespace near_pairs
