// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polylines and polygons within a distance, on kernels of exact numbers, whose coordinates and
// bounds are thirds or have no double between them: the pairs are those of the integers that they
// are multiples of.

#include "support/check_features.h"

using namespace test_support;

BOOST_AUTO_TEST_CASE(near_features_of_exact_numbers)
{
  check_near_features<Features_2, Epeck, Rational_kernel>(2, 2, true);
  check_near_features<Features_2, Epeck, Rational_kernel>(2, 5, false,
                                                          {Scale::THIRD, Scale::CLOSE});
  check_near_features<Features_2, Epeck, Rational_kernel>(2, 5, true, {Scale::THIRD, Scale::CLOSE});
}

BOOST_AUTO_TEST_CASE(near_polylines_in_space_of_exact_numbers)
{
  check_near_features<Features_3, Epeck, Rational_kernel>(
    3, 5, false, {Scale::ONE, Scale::THIRD, Scale::CLOSE});
}
