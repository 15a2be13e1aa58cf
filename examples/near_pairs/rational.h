// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact numbers as CGAL's number type.

#ifndef NEAR_PAIRS_RATIONAL_H
#define NEAR_PAIRS_RATIONAL_H

#include "decimal.h"

#include <CGAL/Exact_rational.h>

namespace near_pairs {

// What the numbers of exact_number.h are.
struct Rational
{
  CGAL::Exact_rational value;
};

CGAL::Exact_rational power_of_ten(int exponent);

CGAL::Exact_rational to_rational(const Decimal& decimal);

} // namespace near_pairs

#endif // NEAR_PAIRS_RATIONAL_H
