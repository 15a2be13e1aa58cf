// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Slabs of points in a plane and of outliers, and blocks of slabs, which share the points out. That
// all other scenes have each point in one slab is left to test_Slab_route.cpp.

#include "support/point_source.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>

BOOST_AUTO_TEST_SUITE(Slabs)

using namespace test_support;

// Blocks follow each other from the first slab to the last one with a point, and no block has more
// points than its part of all and one slab.
void check_blocks(const Points& points, double reach)
{
  const auto slabs = slabs_of<2>(points, reach, internal::Slab_tuning());
  internal::Place largest = 0;
  std::vector<internal::Place> begins = {0};
  for(internal::Place s = 0; s < slabs.count(); ++s) {
    largest = (std::max)(largest, slabs.size(s));
    begins.push_back(begins.back() + slabs.size(s));
  }
  BOOST_CHECK_EQUAL(begins.back(), points.size());
  for(const std::size_t count : {1, 2, 3, 8, 100}) {
    internal::Place end = 0;
    for(std::size_t b = 0; b < count; ++b) {
      const auto [first, last] = slabs.block(b, count);
      BOOST_CHECK_EQUAL(first, end);
      BOOST_CHECK_LE(first, last);
      BOOST_CHECK_LE(begins[last] - begins[first], points.size() / count + 1 + largest);
      end = last;
    }
    BOOST_CHECK_EQUAL(begins[end], points.size());
  }
}

BOOST_AUTO_TEST_CASE(blocks_of_slabs_share_the_points)
{
  check_blocks(uniform_points(2, 20000, 0, 1, 1), 0.001);
  check_blocks(clustered_points(2, 20000, 3, 1. / 256, 3), 0.001);
  check_blocks(flight_points(2, 20000), 1);
  check_blocks(Points(5000, Coordinates(2, 1)), 1);
}

template <int Dimension>
using Slabs_of = internal::Slabs<internal::Slab_point<Dimension, double>>;

// Each point is in one slab, with its coordinates, and slabs follow each other.
template <int Dimension>
void check_slabs(const Slabs_of<Dimension>& slabs, const Points& points)
{
  constexpr int axis = Dimension - 1;
  std::vector<int> times(points.size(), 0);
  double below = -std::numeric_limits<double>::infinity();
  internal::Buffer<internal::Slab_point<Dimension, double>> buffer;
  for(internal::Place s = 0; s < slabs.count(); ++s) {
    double high = below;
    internal::Place size = 0;
    const auto* p = slabs.points(s, buffer, size);
    for(const auto* const end = p + slabs.size(s); p != end; ++p) {
      ++times[p->position];
      BOOST_CHECK(std::equal(p->x.begin(), p->x.end(), points[p->position].begin()));
      BOOST_CHECK_GE(p->x[axis], below);
      high = (std::max)(high, p->x[axis]);
    }
    below = high;
  }
  for(std::size_t i = 0; i < points.size(); ++i)
    BOOST_CHECK_EQUAL(times[i], 1);
}

// Points in a plane have its axis in the middle, where strips are cut.
BOOST_AUTO_TEST_CASE(points_in_a_plane_keep_their_coordinates)
{
  for(const std::size_t flat_axis : {0, 1, 2}) {
    Points points = uniform_points(3, 2500, 0, 1, 1);
    for(Coordinates& c : points)
      c[flat_axis] = 0.3;
    const Slabs_of<3> slabs = slabs_of<3>(points, 0.01);
    BOOST_CHECK_GT(slabs.count(), 20u);
    for(Coordinates& c : points)
      std::swap(c[flat_axis], c[1]);
    check_slabs<3>(slabs, points);
  }
}

// The ends that hold hardly any points are not cut, so the other points still have many slabs.
BOOST_AUTO_TEST_CASE(outliers_leave_the_others_in_many_slabs)
{
  for(const double low : {0., -1e15})
    for(const double high : {1., 1e15}) {
      Points points = uniform_points(2, 2500, 0, 1, 1);
      points[1000][1] = low;
      points[2000][1] = high;
      const Slabs_of<2> slabs = slabs_of<2>(points, 1e-3);
      for(internal::Place s = 0; s < slabs.count(); ++s)
        BOOST_CHECK_LE(slabs.size(s), 100u);
    }
}

BOOST_AUTO_TEST_SUITE_END()
