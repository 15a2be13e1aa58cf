// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Samples of points, and samples by their pairs.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/parts/Cell_counts.h>
#include <CGAL/Thick_intersection_d/internal/parts/spatial_order.h>

BOOST_AUTO_TEST_SUITE(Cell_counts)

using namespace test_support;

struct Point
{
  double x = 0, y = 0;
  double operator[](std::size_t axis) const { return axis == 0 ? x : y; }
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
  internal::Point_sample sample;
  sample.dimension = 2;
  internal::for_random_positions(part.size(), count, [&](std::uint64_t i) {
    sample.add(part.points[i], part.ids[i]);
  });
  return sample;
}

// Returns points of a part, chosen by their pairs, if `part_count` such parts choose them.
internal::Point_sample chosen_by_pairs(const Part& part, double reach, std::size_t sample_size,
                                       std::size_t count, std::uint64_t part_count = 1)
{
  const internal::Point_sample sample = sample_of(part, sample_size);
  internal::Cell_counts cells(sample, part_count * part.size(), reach);
  const auto counted = cells.add_some(part);
  for(std::uint64_t& number : cells.counts())
    number *= part_count;
  internal::Point_sample chosen;
  chosen.dimension = 2;
  cells.choose_by_pairs(part, counted, count, chosen);
  return chosen;
}

// How many of the points are beyond x.
std::ptrdiff_t count_beyond(const internal::Point_sample& points, double x)
{
  std::ptrdiff_t count = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    count += points.point(i)[0] >= x;
  return count;
}

BOOST_AUTO_TEST_CASE(points_are_chosen_by_the_pairs_in_their_cells)
{
  const Part part = points_of_cells({1, 100, 0, 200}, 0.25);
  const internal::Point_sample chosen = chosen_by_pairs(part, 0.25, part.size(), 500);
  BOOST_CHECK_LE(std::abs(count_beyond(chosen, 0.75) - 400), 5);
  BOOST_CHECK_LE(std::abs(count_beyond(chosen, 0.25) - 500), 1);
  BOOST_CHECK_LE(std::abs(count_beyond(chosen, 0) - 500), 1);
}

// A thousand cells of two points have as many pairs as a cell of 45 points, and a fifth of them is
// in the sample.
BOOST_AUTO_TEST_CASE(cells_stand_for_those_without_a_sampled_point)
{
  std::vector<int> counts(2000, 0);
  for(std::size_t cell = 0; cell < counts.size(); cell += 2)
    counts[cell] = 2;
  counts.push_back(45);
  const internal::Point_sample chosen = chosen_by_pairs(points_of_cells(counts, 1), 1, 200, 1000);
  BOOST_CHECK_LE(std::abs(count_beyond(chosen, 2000) - 500), 100);
}

// What one process counts, others add, and each of them chooses its share.
BOOST_AUTO_TEST_CASE(counts_of_processes_are_added)
{
  const internal::Point_sample chosen = chosen_by_pairs(points_of_cells({90}, 1), 1, 10, 60, 3);
  BOOST_CHECK_EQUAL(chosen.size(), 20);
}

BOOST_AUTO_TEST_CASE(no_points_are_chosen_where_there_are_no_pairs)
{
  BOOST_CHECK_EQUAL(chosen_by_pairs(points_of_cells({1, 1, 1}, 1), 1, 3, 10).size(), 0);
  BOOST_CHECK_EQUAL(chosen_by_pairs(Part(), 1, 3, 10).size(), 0);
}

BOOST_AUTO_TEST_CASE(some_of_many_points_stand_for_all)
{
  const Part part = points_of_cells({1000000}, 1);
  internal::Cell_counts cells(sample_of(part, 10), part.size(), 1);
  cells.add_some(part);
  const std::vector<std::uint64_t>& counts = cells.counts();
  BOOST_CHECK_EQUAL(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)), 1000000);
  BOOST_CHECK_EQUAL(chosen_by_pairs(part, 1, 10, 50).size(), 50);
}

BOOST_AUTO_TEST_CASE(a_reach_of_zero_counts_equal_points)
{
  Part part;
  for(int i = 0; i < 30; ++i)
    part.add(Point{i < 20 ? 0.5 : i * 0.25, 0}, part.size());
  BOOST_CHECK_EQUAL(count_beyond(chosen_by_pairs(part, 0, 30, 40), 0.5), 40);
  BOOST_CHECK_EQUAL(count_beyond(chosen_by_pairs(part, 0, 30, 40), 1), 0);
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

// With more processes, the sample grows more slowly than their number.
BOOST_AUTO_TEST_CASE(samples_have_fewer_points_for_each_of_many_processes)
{
  BOOST_CHECK_EQUAL(internal::sample_size_of_parts(1), 1024);
  BOOST_CHECK_EQUAL(internal::sample_size_of_parts(64), 64 * 1024);
  BOOST_CHECK_EQUAL(internal::sample_size_of_parts(1024), 1024 * 256);
  BOOST_CHECK_EQUAL(internal::sampled_before(500, 1000, 64), 32 * 1024);
  BOOST_CHECK_EQUAL(internal::sampled_before(0, 0, 64), 0);
}

BOOST_AUTO_TEST_CASE(points_in_cells_keep_their_ids)
{
  Part part;
  for(int i = 0; i < 1000; ++i)
    part.add(Point{static_cast<double>(i * 7 % 10), static_cast<double>(i * 37 % 100)},
             part.size());
  const Part before = part;
  internal::sort_by_cells(part, 2);
  std::vector<std::uint64_t> ids = part.ids;
  std::sort(ids.begin(), ids.end());
  BOOST_CHECK(ids == before.ids);
  for(std::size_t i = 0; i < part.size(); ++i) {
    BOOST_CHECK_EQUAL(part.points[i].x, before.points[part.ids[i]].x);
    BOOST_CHECK_EQUAL(part.points[i].y, before.points[part.ids[i]].y);
    BOOST_CHECK(i == 0 || part.points[i].y >= part.points[i - 1].y - 7); // 15 cells for 99
    const bool is_row = i > 0 && part.points[i].y == part.points[i - 1].y;
    BOOST_CHECK(!is_row || part.points[i].x >= part.points[i - 1].x); // 15 cells for 10 numbers
  }
}

BOOST_AUTO_TEST_CASE(points_on_a_line_or_at_one_place_are_put_in_cells)
{
  Part line, place;
  for(int i = 0; i < 100; ++i) {
    line.add(Point{static_cast<double>(i * 37 % 100), 5}, line.size());
    place.add(Point{3, 5}, place.size());
  }
  internal::sort_by_cells(line, 2);
  for(std::size_t i = 0; i < line.size(); ++i)
    BOOST_CHECK_LE(std::abs(line.points[i].x - static_cast<double>(i)), 20);
  internal::sort_by_cells(place, 2);
  BOOST_CHECK(std::is_sorted(place.ids.begin(), place.ids.end()));
  Part none;
  internal::sort_by_cells(none, 2);
  BOOST_CHECK_EQUAL(none.size(), 0);
}

BOOST_AUTO_TEST_CASE(the_lesser_of_two_ids_comes_first)
{
  constexpr std::uint64_t most = ~std::uint64_t(0);
  for(const std::uint64_t i : {std::uint64_t(0), std::uint64_t(5), most})
    for(const std::uint64_t j : {std::uint64_t(0), std::uint64_t(6), most - 1, most})
      BOOST_CHECK(internal::ids_in_order(i, j) == std::minmax({i, j}));
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
