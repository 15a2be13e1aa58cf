// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles, cuboids and tetrahedra in space, on the usual kernels.

#include "support/check_objects.h"

using namespace test_support;

namespace {

template <class Maker>
void check_on_kernels()
{
  check_scenes_of_objects<Maker, Double_kernel, Epeck>();
}

} // namespace

BOOST_AUTO_TEST_CASE(segments) { check_on_kernels<Segments_3>(); }
BOOST_AUTO_TEST_CASE(triangles) { check_on_kernels<Triangles_3>(); }
BOOST_AUTO_TEST_CASE(cuboids) { check_on_kernels<Cuboids_3>(); }
BOOST_AUTO_TEST_CASE(tetrahedra) { check_on_kernels<Tetrahedra_3>(); }
