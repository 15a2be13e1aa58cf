// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes by four threads.

#include "support/check_fuzz.h"

#include <CGAL/Simple_cartesian.h>

#include <tbb/global_control.h>

using namespace test_support;

using Doubles = CGAL::Simple_cartesian<double>;

namespace {

const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);

} // namespace

BOOST_AUTO_TEST_CASE(doubles_2)
{
  fuzz<Fuzz_cartesian<Doubles, 2, false>, NEAR_PAIRS | CLOSEST_PAIRS, CGAL::Parallel_tag>(40000);
}
BOOST_AUTO_TEST_CASE(doubles_3)
{
  fuzz<Fuzz_cartesian<Doubles, 3, false>, RECURSION | BALLS | OBJECTS, CGAL::Parallel_tag>(40000);
}
