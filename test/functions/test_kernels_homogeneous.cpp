// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every scene on the homogeneous kernel over the integers.

#include "support/check_kernel.h"

#include <CGAL/Homogeneous.h>

using namespace test_support;

using Integer_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;

namespace {

// Coordinates are quotients of big integers, so that all of the time is spent in allocations; where
// addresses are watched these take ten times as long. Whole scenes of exact numbers that are no
// doubles are in test_kernels_exact.
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t max_size = 150;
#else
constexpr std::size_t max_size = 400;
#endif

template <int Dimension>
void check_scenes()
{
  for(Point_scene scene : all_scenes(Dimension)) {
    scene.points.resize((std::min)(scene.points.size(), max_size));
    check_scene<Homogeneous_points<Integer_kernel, Dimension>>(scene);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(homogeneous_2) { check_scenes<2>(); }
BOOST_AUTO_TEST_CASE(homogeneous_3) { check_scenes<3>(); }
