// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes on the lazy exact kernel for points of any dimension, fixed when compiled or not.
// Thirds are in test_fuzz_d.

#include "support/check_kernel.h"

#include <CGAL/Epeck_d.h>

using namespace test_support;

template <int Dimension>
using Static_points = Points_d<CGAL::Epeck_d<CGAL::Dimension_tag<Dimension>>>;
using Dynamic_points = Points_d<CGAL::Epeck_d<CGAL::Dynamic_dimension_tag>>;

BOOST_AUTO_TEST_CASE(epeck_d_3) { check_kernel<Static_points<3>>(3); }
BOOST_AUTO_TEST_CASE(epeck_d_dynamic_2) { check_kernel<Dynamic_points>(2); }
BOOST_AUTO_TEST_CASE(epeck_d_dynamic_5) { check_kernel<Dynamic_points>(5); }
