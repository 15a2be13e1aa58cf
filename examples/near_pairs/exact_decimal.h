// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact numbers of decimal text, and back.

#ifndef NEAR_PAIRS_EXACT_DECIMAL_H
#define NEAR_PAIRS_EXACT_DECIMAL_H

#include "decimal.h"

#include <CGAL/Exact_rational.h>

#include <optional>
#include <string>
#include <string_view>

namespace near_pairs {

// Reads a decimal, or a quotient of two decimals such as 1/3.
std::optional<CGAL::Exact_rational> parse_exact(std::string_view text);

CGAL::Exact_rational power_of_ten(int exponent);

CGAL::Exact_rational to_rational(const Decimal& decimal);

// Returns the text of a number that is not negative: a decimal if a short one is exact, otherwise a
// quotient.
std::string exact_text(const CGAL::Exact_rational& value);

} // namespace near_pairs

#endif // NEAR_PAIRS_EXACT_DECIMAL_H
