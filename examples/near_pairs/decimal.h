// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers as people type them: decimal text is taken apart into sign, digits and exponent, from
// which the integer at a common scale or the nearest double can be had. exact_number.h makes exact
// numbers of them.

#ifndef NEAR_PAIRS_DECIMAL_H
#define NEAR_PAIRS_DECIMAL_H

#include <optional>
#include <string>
#include <string_view>

namespace near_pairs {

// The number  (+ or -) digits * 10^exponent.  The digits have no leading and no trailing zero, so
// that equal numbers look the same; zero has no digits and exponent 0.
struct Decimal
{
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

// The first digit of a Decimal, and each zero behind the last one, stand for at most this power of
// ten, and for at least its inverse, which is far outside the range of double. It keeps
// "1e999999999" from asking for a gigabyte of zeros.
constexpr int largest_exponent = 1000;

// Reads [+-]digits[.digits][e[+-]digits], where one side of the point may be missing.
// Blanks around the number are not part of it: trim first.
std::optional<Decimal> parse_decimal(std::string_view text);

// Returns decimal * 10^scale, without rounding, if that is an integer of at most 53 bits.
std::optional<double> scaled_to_double(const Decimal& decimal, int scale);

// Returns the double nearest to the number that parse_decimal() accepted; infinite on overflow.
double nearest_double(std::string_view text);

// Whether a decimal of few digits is not the double next to it: it is a fraction of a power of ten,
// and not one of a power of two. One of more digits may be a double that was printed.
bool is_rounded(const Decimal& decimal);

std::string_view trimmed(std::string_view text);

} // namespace near_pairs

#endif // NEAR_PAIRS_DECIMAL_H
