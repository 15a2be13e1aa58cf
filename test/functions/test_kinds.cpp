// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which objects of all kinds intersect, and which are near, mixed in one range and in two, on the
// usual kernels, in sequence and by threads. One program, because both questions have most of their
// predicates in common.

#include "support/check_kinds.h"
#include "support/usual_kernels.h"

using namespace test_support;

namespace {

template <class Kernel, int Dimension>
void check_on_kernel()
{
  check_all_kinds<Kernel_kinds<Kernel, Dimension>>();
}

} // namespace

BOOST_AUTO_TEST_CASE(epick_2) { check_on_kernel<Epick, 2>(); }
BOOST_AUTO_TEST_CASE(epick_3) { check_on_kernel<Epick, 3>(); }
BOOST_AUTO_TEST_CASE(epeck_2) { check_on_kernel<Epeck, 2>(); }
BOOST_AUTO_TEST_CASE(epeck_3) { check_on_kernel<Epeck, 3>(); }
BOOST_AUTO_TEST_CASE(doubles_2) { check_on_kernel<Double_kernel, 2>(); }
BOOST_AUTO_TEST_CASE(doubles_3) { check_on_kernel<Double_kernel, 3>(); }
BOOST_AUTO_TEST_CASE(rationals_2) { check_on_kernel<Rational_kernel, 2>(); }
BOOST_AUTO_TEST_CASE(rationals_3) { check_on_kernel<Rational_kernel, 3>(); }
