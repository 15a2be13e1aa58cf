// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Most of a million small random scenes: on doubles, in sequence, by the best lanes.

#include "support/check_fuzz.h"
#include "support/usual_kernels.h"

using namespace test_support;

BOOST_AUTO_TEST_CASE(doubles_2) { fuzz<Fuzz_cartesian<Epick, 2, false>>(400000); }
BOOST_AUTO_TEST_CASE(doubles_3) { fuzz<Fuzz_cartesian<Epick, 3, false>>(400000); }

// Near pairs at the limits of narrow coordinates.
BOOST_AUTO_TEST_CASE(partners_2) { fuzz<Fuzz_cartesian<Epick, 2, false>, PARTNERS>(50000); }
BOOST_AUTO_TEST_CASE(partners_3) { fuzz<Fuzz_cartesian<Epick, 3, false>, PARTNERS>(50000); }
