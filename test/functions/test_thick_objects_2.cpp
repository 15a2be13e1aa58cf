// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles and rectangles in the plane, on the usual kernels.

#include "support/check_objects.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using namespace test_support;

using Float_kernel = CGAL::Simple_cartesian<float>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

namespace {

template <class Maker>
void check_on_kernels()
{
  check_scenes_of_objects<Maker, Double_kernel, Float_kernel, Epick, Epeck, Rational_kernel>();
}

} // namespace

BOOST_AUTO_TEST_CASE(segments) { check_on_kernels<Segments_2>(); }
BOOST_AUTO_TEST_CASE(triangles) { check_on_kernels<Triangles_2>(); }
BOOST_AUTO_TEST_CASE(rectangles) { check_on_kernels<Rectangles_2>(); }
