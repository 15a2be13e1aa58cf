// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact numbers; see exact_number.h and rational.h.

#include "exact_number.h"

#include "rational.h"

#include <CGAL/number_utils.h> // to_double

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>
#include <utility>

namespace near_pairs {
namespace {

// The double next to a number, as a reader of decimals has it; of two that are as near, the even
// one. CGAL::to_double() may return the other one beside the number.
double rounded_to_nearest(const CGAL::Exact_rational& value)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double near = CGAL::to_double(value);
  const CGAL::Exact_rational near_value(std::isfinite(near) ? near : 0);
  const double next = std::nextafter(near, value < near_value ? -infinity : infinity);
  if(!std::isfinite(near) || !std::isfinite(next) || value == near_value)
    return near;
  const CGAL::Exact_rational excess = 2 * value - near_value - CGAL::Exact_rational(next);
  if(excess != 0)
    return (excess > 0) == (next > near) ? next : near;
  std::uint64_t bits;
  std::memcpy(&bits, &near, sizeof bits);
  return bits % 2 == 0 ? near : next;
}

} // namespace

Exact_number::Exact_number() : Exact_number(Rational()) {}

Exact_number::Exact_number(Rational value)
  : value_(std::make_shared<const Rational>(std::move(value)))
{}

Exact_number operator*(const Exact_number& a, const Exact_number& b)
{
  return Exact_number(Rational{a->value * b->value});
}

bool is_negative(const Exact_number& number)
{
  return number->value < 0;
}

double to_double(const Exact_number& number)
{
  return rounded_to_nearest(number->value);
}

std::optional<Exact_number> parse_exact(std::string_view text)
{
  const std::size_t slash = text.find('/');
  const std::optional<Decimal> numerator = parse_decimal(trimmed(text.substr(0, slash)));
  if(!numerator)
    return std::nullopt;
  if(slash == std::string_view::npos)
    return Exact_number(Rational{to_rational(*numerator)});
  const std::optional<Decimal> denominator = parse_decimal(trimmed(text.substr(slash + 1)));
  if(!denominator || denominator->digits.empty())
    return std::nullopt;
  return Exact_number(Rational{to_rational(*numerator) / to_rational(*denominator)});
}

std::string exact_text(const Exact_number& number)
{
  const auto text_of = [](const CGAL::Exact_rational& value) {
    std::ostringstream text;
    text << value;
    return text.str();
  };
  CGAL::Exact_rational scaled = number->value;
  for(std::size_t decimals = 0; decimals <= 30; ++decimals) {
    std::string digits = text_of(scaled);
    if(digits.find('/') == std::string::npos) {
      if(decimals != 0 && digits.size() <= decimals)
        digits.insert(0, decimals + 1 - digits.size(), '0');
      return decimals == 0 ? digits : digits.insert(digits.size() - decimals, ".");
    }
    scaled *= 10;
  }
  return text_of(number->value);
}

Exact_numbers::Exact_numbers() : values_(std::make_unique<std::vector<Rational>>()) {}
Exact_numbers::Exact_numbers(Exact_numbers&& other) noexcept = default;
Exact_numbers& Exact_numbers::operator=(Exact_numbers&& other) noexcept = default;
Exact_numbers::~Exact_numbers() = default;

std::size_t Exact_numbers::size() const
{
  return values_->size();
}

void Exact_numbers::add(const Decimal& decimal)
{
  values_->push_back({to_rational(decimal)});
}

void Exact_numbers::add_scaled(const std::vector<double>& integers, int scale)
{
  const CGAL::Exact_rational unit = power_of_ten(-scale);
  values_->reserve(size() + integers.size());
  for(double integer : integers)
    values_->push_back({CGAL::Exact_rational(integer) * unit});
}

const Rational& Exact_numbers::operator[](std::size_t at) const
{
  return (*values_)[at];
}

double Exact_numbers::rounded(std::size_t at) const
{
  return rounded_to_nearest((*values_)[at].value);
}

double Exact_numbers::rounded_difference(std::size_t a, std::size_t b) const
{
  return CGAL::to_double(CGAL::Exact_rational((*values_)[a].value - (*values_)[b].value));
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

} // namespace near_pairs
