// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The boxes of parts.

#include <CGAL/Thick_intersection_d/internal/parts/Bisection.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(Bisection)

namespace internal = CGAL::Thick_intersection_d::internal;

// Points of a box, with equal weights.
internal::Point_sample random_points(std::size_t size, double width, double height)
{
  internal::Random_numbers random(7);
  internal::Point_sample points;
  points.dimension = 2;
  for(std::size_t i = 0; i < size; ++i) {
    points.coordinates.push_back(width * random() / internal::Random_numbers::largest());
    points.coordinates.push_back(height * random() / internal::Random_numbers::largest());
    points.ids.push_back(i);
    points.weights.push_back(1);
  }
  return points;
}

// The weight of each part.
std::vector<double> weights(const internal::Bisection& parts, int part_count,
                            const internal::Point_sample& points)
{
  std::vector<double> sums(static_cast<std::size_t>(part_count));
  for(std::size_t i = 0; i < points.size(); ++i)
    sums.at(static_cast<std::size_t>(parts.owner(points.point(i), points.ids[i])))
      += points.weights[i];
  return sums;
}

double largest_over_average(const std::vector<double>& sums)
{
  double sum = 0;
  for(const double part : sums)
    sum += part;
  return *std::max_element(sums.begin(), sums.end()) * static_cast<double>(sums.size()) / sum;
}

BOOST_AUTO_TEST_CASE(parts_have_the_same_weight)
{
  internal::Point_sample points = random_points(5000, 10, 1);
  for(std::size_t i = 0; i < points.size(); ++i)
    points.weights[i] = points.point(i)[0] < 1 ? 20 : 1;
  for(const int part_count : {1, 2, 3, 4, 7, 16}) {
    const internal::Bisection parts(points, part_count, 0.01);
    BOOST_CHECK_LT(largest_over_average(weights(parts, part_count, points)), 1.05);
  }
}

BOOST_AUTO_TEST_CASE(cuts_go_where_few_points_are_within_reach)
{
  const internal::Point_sample points = random_points(1000, 2, 10);
  const internal::Bisection parts(points, 2, 0.5);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<double> mirrored = {2 - points.point(i)[0], points.point(i)[1]};
    BOOST_CHECK_EQUAL(parts.owner(points.point(i), i), parts.owner(mirrored, i));
  }
}

// The points extend more along axis 1, and there is a gap along axis 0.
BOOST_AUTO_TEST_CASE(cuts_go_through_gaps)
{
  internal::Point_sample points = random_points(1000, 1, 10);
  for(std::size_t i = 0; i < points.size(); i += 2)
    points.coordinates[2 * i] += 3;
  const internal::Bisection parts(points, 2, 0.9);
  for(std::size_t i = 0; i < points.size(); ++i)
    BOOST_CHECK_EQUAL(parts.owner(points.point(i), i), i % 2 == 0);
}

BOOST_AUTO_TEST_CASE(equal_points_are_cut_by_their_ids)
{
  internal::Point_sample points = random_points(1000, 0, 0);
  const internal::Bisection parts(points, 7, 1);
  BOOST_CHECK_LT(largest_over_average(weights(parts, 7, points)), 1.05);
}

BOOST_AUTO_TEST_CASE(points_on_a_cut_are_above_it_from_its_id_on)
{
  internal::Point_sample points = random_points(2, 0, 0);
  points.ids = {10, 20};
  const internal::Bisection parts(points, 2, 1);
  const std::vector<double> x = {0, 0};
  BOOST_CHECK_EQUAL(parts.owner(x, 10), 0);
  BOOST_CHECK_EQUAL(parts.owner(x, 19), 0);
  BOOST_CHECK_EQUAL(parts.owner(x, 20), 1);
}

BOOST_AUTO_TEST_CASE(there_may_be_fewer_points_than_parts)
{
  const std::vector<double> x = {(std::numeric_limits<double>::max)(), 0};
  for(const std::size_t size : {0, 1, 3}) {
    const internal::Point_sample points = random_points(size, 1, 1);
    const internal::Bisection parts(points, 7, 1);
    const std::vector<double> sums = weights(parts, 7, points);
    BOOST_CHECK(size == 0 || *std::max_element(sums.begin(), sums.end()) == 1);
    BOOST_CHECK_GE(parts.owner(x, 5), 0);
    BOOST_CHECK_LT(parts.owner(x, 5), 7);
  }
}

BOOST_AUTO_TEST_SUITE_END()
