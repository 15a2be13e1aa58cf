// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the tests of a room begin with: Boost.Test, random points, the headers of the standard
// library for numbers and containers, and two short names. A test includes the headers that it is
// about besides, and what these do not bring along. Nothing of CGAL is included, so tests that need
// nothing of it compile in a moment.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_UNIT_TEST_H
#define THICK_INTERSECTION_TEST_SUPPORT_UNIT_TEST_H

#include "point_generators.h"
#include "standard_library.h"

#include <boost/test/unit_test.hpp>

namespace CGAL::Thick_intersection_d::internal {}

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_UNIT_TEST_H
