// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles, boxes and tetrahedra in scenes of many sizes and scales, by each route, on
// the usual kernels. Further ones are in test_object_kernels.

#include "support/check_objects.h"

using namespace test_support;

using Float_kernel = CGAL::Simple_cartesian<float>;

namespace {

template <class Maker>
void check_plane()
{
  check_scenes_of_objects<Maker, Double_kernel, Float_kernel, Epick, Epeck, Rational_kernel>();
}

template <class Maker>
void check_space()
{
  check_scenes_of_objects<Maker, Double_kernel, Epeck>();
}

} // namespace

BOOST_AUTO_TEST_CASE(segments_2) { check_plane<Segments_2>(); }
BOOST_AUTO_TEST_CASE(triangles_2) { check_plane<Triangles_2>(); }
BOOST_AUTO_TEST_CASE(rectangles_2) { check_plane<Rectangles_2>(); }
BOOST_AUTO_TEST_CASE(segments_3) { check_space<Segments_3>(); }
BOOST_AUTO_TEST_CASE(triangles_3) { check_space<Triangles_3>(); }
BOOST_AUTO_TEST_CASE(cuboids_3) { check_space<Cuboids_3>(); }
BOOST_AUTO_TEST_CASE(tetrahedra_3) { check_space<Tetrahedra_3>(); }
