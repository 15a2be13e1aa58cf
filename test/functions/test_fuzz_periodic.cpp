// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes in domains that repeat: on doubles and floats, and by several threads.

#include "support/check_periodic_fuzz.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Floats = CGAL::Simple_cartesian<float>;
using Threads = CGAL::Parallel_if_available_tag;

BOOST_AUTO_TEST_CASE(doubles_2) { fuzz_periodic<Fuzz_cartesian<Epick, 2, false>>(3000); }
BOOST_AUTO_TEST_CASE(doubles_3) { fuzz_periodic<Fuzz_cartesian<Epick, 3, false>>(3000); }
BOOST_AUTO_TEST_CASE(floats_3) { fuzz_periodic<Fuzz_cartesian<Floats, 3, false>>(2000); }
BOOST_AUTO_TEST_CASE(doubles_2_by_threads)
{
  fuzz_periodic<Fuzz_cartesian<Epick, 2, false>, Fuzz_cartesian<Epick, 2, false>, Threads>(1000);
}
