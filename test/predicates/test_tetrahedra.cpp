// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tetrahedra, degenerate or not, against the oracle.

#include "support/check_simplices.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>

BOOST_AUTO_TEST_SUITE(tetrahedra)

using test_support::check_simplices;
namespace internal = CGAL::Thick_intersection_d::internal;

BOOST_AUTO_TEST_CASE(triangle_and_tetrahedron) { check_simplices<3, 3, 4>(20000); }
BOOST_AUTO_TEST_CASE(tetrahedra) { check_simplices<3, 4, 4>(20000); }

// Objects within a tetrahedron meet no face of it.
template <std::size_t Count>
bool is_found_within(const std::array<std::array<double, 3>, Count>& object)
{
  using Orientation = internal::Staged_orientation<3>;
  const std::array<double, 3> corners[] = {{0, 0, 0}, {99, 0, 0}, {0, 99, 0}, {0, 0, 99}};
  Orientation::Vertices<Count + 4> vertices;
  internal::Simplex<Orientation, Count> inner;
  internal::Simplex<Orientation, 4> outer;
  for(std::size_t k = 0; k < Count + 4; ++k) {
    vertices[k].x = k < Count ? object[k] : corners[k - Count];
    (k < Count ? inner[k % Count] : outer[(k + 4 - Count) % 4])
      = Orientation::Point(vertices[k]);
  }
  Orientation orientation(vertices);
  return internal::do_intersect_in_space(orientation, inner, outer);
}

BOOST_AUTO_TEST_CASE(what_is_within_a_tetrahedron_intersects_it)
{
  BOOST_CHECK(is_found_within<3>({{{20, 20, 20}, {21, 20, 20}, {20, 22, 25}}}));
  BOOST_CHECK(is_found_within<3>({{{20, 20, 20}, {20, 20, 20}, {20, 20, 20}}}));
  BOOST_CHECK(is_found_within<4>({{{20, 20, 20}, {21, 20, 20}, {20, 21, 20}, {22, 22, 20}}}));
  BOOST_CHECK(is_found_within<4>({{{20, 20, 20}, {21, 20, 20}, {20, 21, 20}, {22, 22, 25}}}));
}

BOOST_AUTO_TEST_SUITE_END()
