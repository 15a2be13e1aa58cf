// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects on kernels that other tests leave out: homogeneous, filtered, and of other numbers.

#include "support/check_objects.h"

#include <CGAL/Exact_integer.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Simple_homogeneous.h>

using namespace test_support;

using Homogeneous_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;
using Simple_homogeneous_kernel = CGAL::Simple_homogeneous<CGAL::Exact_integer>;
using Filtered_double_kernel = CGAL::Filtered_kernel<CGAL::Simple_cartesian<double>>;
using Filtered_rational_kernel = CGAL::Filtered_kernel<Rational_kernel>;
using Integer_kernel = CGAL::Simple_cartesian<long long>;
using Long_kernel = CGAL::Simple_cartesian<long double>;

// Enough for cuts. Each predicate takes many allocations.
constexpr std::size_t max_size = 60;

BOOST_AUTO_TEST_CASE(segments_2)
{
  check_scenes_of_objects<Segments_2, Homogeneous_kernel, Simple_homogeneous_kernel,
                          Filtered_double_kernel, Filtered_rational_kernel, Integer_kernel>(
    max_size);
}

BOOST_AUTO_TEST_CASE(triangles_2)
{
  check_scenes_of_objects<Triangles_2, Homogeneous_kernel, Filtered_double_kernel,
                          Filtered_rational_kernel, Long_kernel>(max_size);
}

BOOST_AUTO_TEST_CASE(rectangles_2)
{
  check_scenes_of_objects<Rectangles_2, Homogeneous_kernel, Filtered_double_kernel,
                          Filtered_rational_kernel, Long_kernel>(max_size);
}

BOOST_AUTO_TEST_CASE(segments_3)
{
  check_scenes_of_objects<Segments_3, Homogeneous_kernel>(max_size);
}

BOOST_AUTO_TEST_CASE(triangles_3)
{
  check_scenes_of_objects<Triangles_3, Homogeneous_kernel, Filtered_double_kernel,
                          Filtered_rational_kernel>(max_size);
}

BOOST_AUTO_TEST_CASE(cuboids_3)
{
  check_scenes_of_objects<Cuboids_3, Homogeneous_kernel, Filtered_rational_kernel>(max_size);
}

BOOST_AUTO_TEST_CASE(tetrahedra_3)
{
  check_scenes_of_objects<Tetrahedra_3, Homogeneous_kernel, Filtered_double_kernel,
                          Filtered_rational_kernel>(max_size);
}
