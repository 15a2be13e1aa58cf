// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every scene on the homogeneous kernel over the integers.

#define BOOST_TEST_MODULE kernels_homogeneous
#include "support/check_kernel.h"

#include <CGAL/Homogeneous.h>

using namespace test_support;

using Integer_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;

BOOST_AUTO_TEST_CASE(homogeneous_2) { check_kernel<Homogeneous_points<Integer_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(homogeneous_3) { check_kernel<Homogeneous_points<Integer_kernel, 3>>(3); }
