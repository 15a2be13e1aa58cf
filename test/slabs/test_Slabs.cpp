// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Slabs of points: blocks of slabs share them out.

#include "support/point_generators.h"
#include "support/undecided_points.h"

#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>

BOOST_AUTO_TEST_SUITE(Slabs)

using namespace test_support;

// Blocks follow each other from the first slab to the last one with a point, and no block has more
// points than its part of all and one slab.
void check_blocks(const Points& points, double reach)
{
  const Undecided_points<2> source(points, reach);
  const internal::Slabs<internal::Slab_point<2>> slabs(CGAL::Sequential_tag(), source, 0,
                                                       points.size(), reach);
  std::ptrdiff_t largest = 0;
  for(internal::Place s = 0; s < slabs.count(); ++s)
    largest = (std::max)(largest, slabs.end(s) - slabs.begin(s));
  for(const std::size_t count : {1, 2, 3, 8, 100}) {
    internal::Place end = 0;
    for(std::size_t b = 0; b < count; ++b) {
      const auto [first, last] = slabs.block(b, count);
      BOOST_CHECK_EQUAL(first, end);
      BOOST_CHECK_LE(first, last);
      const auto fair = static_cast<std::ptrdiff_t>(points.size() / count) + 1;
      BOOST_CHECK_LE(slabs.begin(last) - slabs.begin(first), fair + largest);
      end = last;
    }
    BOOST_CHECK(slabs.begin(end) == slabs.begin(slabs.count()));
  }
}

BOOST_AUTO_TEST_CASE(blocks_of_slabs_share_the_points)
{
  check_blocks(uniform_points(2, 20000, 0, 1, 1), 0.001);
  check_blocks(clustered_points(2, 20000, 3, 1. / 256, 3), 0.001);
  check_blocks(flight_points(2, 20000), 1);
  check_blocks(Points(5000, Coordinates(2, 1)), 1);
}

BOOST_AUTO_TEST_SUITE_END()
