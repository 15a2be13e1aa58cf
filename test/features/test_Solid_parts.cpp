// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which parts may be in a box, and which faces a ray upwards crosses.

#include "support/unit_test.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Thick_intersection_d/internal/features/Solid_parts.h>
#include <CGAL/Thick_intersection_d/internal/features/does_ray_cross_face.h>

#include <algorithm>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(Solid_parts)

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Exact = CGAL::Exact_rational;
using Exact_kernel = CGAL::Simple_cartesian<Exact>;
using internal::Place;

// The face of three of many points.
Kernel::Triangle_3 face(int p, int q, int r)
{
  const auto point = [](int k) { return Kernel::Point_3(k, k * k, k * k * k); };
  return {point(p), point(q), point(r)};
}

template <class K>
struct Pieces
{
  const CGAL::Triangle_3<K>& thick(Place place) const { return pieces[place]; }
  std::vector<CGAL::Triangle_3<K>> pieces;
};

internal::Space_box cube(double low, double high)
{
  internal::Space_box box;
  for(internal::Interval& interval : box)
    interval = {low, high};
  return box;
}

BOOST_AUTO_TEST_CASE(one_piece_of_each_part_is_asked)
{
  const Pieces<Kernel> pieces{{face(0, 1, 2), face(1, 2, 3), face(4, 5, 6)}};
  const internal::Solid_parts parts(pieces, {1, 2});
  std::vector<Place> asked;
  parts.is_any_inside(cube(0, 999), [&](Place place) {
    asked.push_back(place);
    return false;
  });
  std::sort(asked.begin(), asked.end());
  BOOST_CHECK((asked == std::vector<Place>{1, 2}));
}

BOOST_AUTO_TEST_CASE(parts_may_be_in_boxes_that_end_at_their_bounds)
{
  const Exact third = Exact(1) / 3;
  const Exact_kernel::Point_3 p(third, third, third);
  const internal::Solid_parts parts(Pieces<Exact_kernel>{{{p, p, p}}}, {0});
  const auto [low, high] = CGAL::to_interval(third);
  BOOST_REQUIRE_LT(low, high);
  const auto may_be_in = [&](double first, double last) {
    return parts.is_any_inside(cube(first, last), [](Place) { return true; });
  };
  BOOST_CHECK(may_be_in(high, 1));
  BOOST_CHECK(may_be_in(0, low));
  BOOST_CHECK(!may_be_in(std::nextafter(high, 1), 1));
  BOOST_CHECK(!may_be_in(0, std::nextafter(low, 0)));
}

// By doubles, and by numbers that are none: `unit` makes them so.
template <class K>
void check_rays(const typename K::FT& unit)
{
  const auto point = [&](int x, int y, int z) {
    return typename K::Point_3(x * unit, y * unit, z * unit);
  };
  for(const int x : {-1, 1, 9})
    for(const int height : {-1, 1}) {
      const typename K::Segment_3 source(point(x, 1, 0), point(2, 2, 9 * height));
      const auto p = point(0, 0, height), q = point(4, 0, height), r = point(0, 4, height);
      for(const typename K::Triangle_3& face : {typename K::Triangle_3(p, q, r), {r, q, p}})
        BOOST_CHECK_EQUAL(internal::does_ray_cross_face(source, face), x == 1 && height == 1);
    }
}

BOOST_AUTO_TEST_CASE(rays_go_upwards_from_the_first_vertex)
{
  check_rays<Kernel>(1);
  check_rays<Exact_kernel>(Exact(1) / 3);
}

BOOST_AUTO_TEST_SUITE_END()
