// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The weights of samples, and the samples.

#include <CGAL/Thick_intersection_d/internal/parts/Cell_counts.h>
#include <CGAL/Thick_intersection_d/internal/parts/choose_sample.h>
#include <CGAL/Thick_intersection_d/internal/parts/spatial_order.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Cell_counts)

namespace internal = CGAL::Thick_intersection_d::internal;

struct Point
{
  double x = 0, y = 0;
  std::pair<double, double> bounds_along(int axis) const
  {
    return axis == 0 ? std::make_pair(x, x) : std::make_pair(y, y);
  }
};

using Part = internal::Part_points<Point>;

// `count` points in each of the cells 0, 1, 2, ... along axis 0.
Part points_of_cells(const std::vector<int>& counts, double reach)
{
  Part part;
  for(std::size_t cell = 0; cell < counts.size(); ++cell)
    for(int i = 0; i < counts[cell]; ++i) {
      const double x = reach * (static_cast<double>(cell) + i / (counts[cell] + 1.));
      part.add(Point{x, 0}, part.size());
    }
  return part;
}

internal::Point_sample sample_of(const Part& part, std::size_t count)
{
  std::vector<char> bytes;
  internal::choose_sample(part, count, 2, bytes);
  return internal::read_sample(bytes, 2);
}

BOOST_AUTO_TEST_CASE(weights_grow_with_the_points_in_a_cell)
{
  const Part part = points_of_cells({1, 10, 1000}, 0.25);
  internal::Point_sample sample = sample_of(part, part.size());
  internal::Cell_counts cells(sample, 0.25);
  cells.add_some(part);
  cells.set_weights(sample);
  BOOST_CHECK_EQUAL(sample.weights.front(), 1);
  BOOST_CHECK_EQUAL(sample.weights[5], 1 + 2 * 9);
  BOOST_CHECK_EQUAL(sample.weights.back(), 1 + 2 * 999);
}

// What one process counts, others add.
BOOST_AUTO_TEST_CASE(counts_of_processes_are_added)
{
  const Part part = points_of_cells({7}, 1);
  internal::Point_sample sample = sample_of(part, 1);
  internal::Cell_counts cells(sample, 1);
  cells.add_some(part);
  for(std::uint64_t& count : cells.counts())
    count *= 3;
  cells.set_weights(sample);
  BOOST_CHECK_EQUAL(sample.weights[0], 1 + 2 * 20);
}

BOOST_AUTO_TEST_CASE(some_of_many_points_stand_for_all)
{
  const Part part = points_of_cells({1000000}, 1);
  internal::Point_sample sample = sample_of(part, 10);
  internal::Cell_counts cells(sample, 1);
  cells.add_some(part);
  const std::vector<std::uint64_t>& counts = cells.counts();
  BOOST_CHECK_EQUAL(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)), 1000000);
}

BOOST_AUTO_TEST_CASE(a_reach_of_zero_counts_equal_points)
{
  Part part;
  for(int i = 0; i < 30; ++i)
    part.add(Point{i < 20 ? 0.5 : i * 0.25, 0}, part.size());
  internal::Point_sample sample = sample_of(part, 30);
  internal::Cell_counts cells(sample, 0);
  cells.add_some(part);
  cells.set_weights(sample);
  BOOST_CHECK_EQUAL(sample.weights.front(), 1 + 2 * 19);
  BOOST_CHECK_EQUAL(sample.weights.back(), 1);
}

BOOST_AUTO_TEST_CASE(samples_have_a_point_of_each_stretch_of_positions)
{
  const Part part = points_of_cells({100}, 1);
  const internal::Point_sample sample = sample_of(part, 10);
  BOOST_REQUIRE_EQUAL(sample.size(), 10);
  for(std::size_t i = 0; i < 10; ++i) {
    BOOST_CHECK_EQUAL(sample.ids[i] / 10, i);
    BOOST_CHECK_EQUAL(sample.point(i)[0], part.points[sample.ids[i]].x);
  }
  BOOST_CHECK_EQUAL(sample_of(part, 1000).size(), 100);
  BOOST_CHECK_EQUAL(sample_of(Part(), 10).size(), 0);
}

BOOST_AUTO_TEST_CASE(points_in_rows_keep_their_ids)
{
  Part part;
  internal::Part_box box(2);
  for(int i = 0; i < 1000; ++i) {
    part.add(Point{static_cast<double>(i * 7 % 10), static_cast<double>(i * 37 % 100)},
             part.size());
    box.add([&](int axis) { return part.points.back().bounds_along(axis); });
  }
  const Part before = part;
  internal::sort_by_rows(part, box);
  std::vector<std::uint64_t> ids = part.ids;
  std::sort(ids.begin(), ids.end());
  BOOST_CHECK(ids == before.ids);
  for(std::size_t i = 0; i < part.size(); ++i) {
    BOOST_CHECK_EQUAL(part.points[i].x, before.points[part.ids[i]].x);
    BOOST_CHECK_EQUAL(part.points[i].y, before.points[part.ids[i]].y);
    BOOST_CHECK(i == 0 || part.points[i].y >= part.points[i - 1].y - 2); // rows of height 99 / 64
  }
}

BOOST_AUTO_TEST_CASE(points_stay_where_they_are_moved_to_themselves)
{
  internal::Part_points<std::vector<int>> part;
  part.add({1, 2}, 5);
  part.add({3}, 6);
  part.move(0, 0);
  BOOST_CHECK(part.points[0] == (std::vector<int>{1, 2}));
  part.move(1, 0);
  BOOST_CHECK(part.points[0] == std::vector<int>{3});
  BOOST_CHECK_EQUAL(part.ids[0], 6);
}

BOOST_AUTO_TEST_SUITE_END()
