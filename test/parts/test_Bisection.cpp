// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The boxes of parts.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/parts/Bisection.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

BOOST_AUTO_TEST_SUITE(Bisection)

using namespace test_support;

// Points of a box, each with the same pairs.
internal::Point_sample random_points(std::size_t size, double width, double height)
{
  internal::Random_numbers random(7);
  internal::Point_sample points;
  points.dimension = 2;
  for(std::size_t i = 0; i < size; ++i) {
    points.coordinates.push_back(width * random() / internal::Random_numbers::largest());
    points.coordinates.push_back(height * random() / internal::Random_numbers::largest());
    points.ids.push_back(i);
    points.loads.push_back({1, 1});
  }
  return points;
}

// The load of each part.
std::vector<double> loads(const internal::Bisection& parts, int part_count,
                          const internal::Point_sample& points,
                          double internal::Point_load::*load = &internal::Point_load::points)
{
  std::vector<double> sums(static_cast<std::size_t>(part_count));
  for(std::size_t i = 0; i < points.size(); ++i)
    sums.at(static_cast<std::size_t>(parts.owner(points.point(i), points.ids[i])))
      += points.loads[i].*load;
  return sums;
}

double largest_over_average(const std::vector<double>& sums)
{
  double sum = 0;
  for(const double part : sums)
    sum += part;
  return *std::max_element(sums.begin(), sums.end()) * static_cast<double>(sums.size()) / sum;
}

BOOST_AUTO_TEST_CASE(parts_have_the_same_number_of_points)
{
  internal::Point_sample points = random_points(5000, 10, 1);
  for(std::size_t i = 0; i < points.size(); ++i)
    points.loads[i].points = points.point(i)[0] < 1 ? 20 : 1;
  for(const int part_count : {1, 2, 3, 4, 7, 16}) {
    const internal::Bisection parts(points, part_count, 0.01);
    BOOST_CHECK_LT(largest_over_average(loads(parts, part_count, points)), 1.05);
  }
}

// Points without pairs, and a crowd of few points with all pairs: no cut divides both evenly.
internal::Point_sample points_with_crowd()
{
  internal::Point_sample points = random_points(10000, 10, 10);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const bool is_in_crowd = i % 2 == 0;
    points.coordinates[2 * i] *= is_in_crowd ? 0.01 : 1;
    points.loads[i] = is_in_crowd ? internal::Point_load{0, 1} : internal::Point_load{1, 0};
  }
  return points;
}

BOOST_AUTO_TEST_CASE(parts_have_the_same_number_of_points_and_of_pairs)
{
  const internal::Point_sample points = points_with_crowd();
  for(const int part_count : {2, 3, 4, 7, 16}) {
    const internal::Bisection parts(points, part_count, 0.01);
    BOOST_CHECK_LT(largest_over_average(loads(parts, part_count, points)), 1.05);
    BOOST_CHECK_LT(largest_over_average(
                     loads(parts, part_count, points, &internal::Point_load::pairs)), 1.1);
  }
}

using Box_of_points = internal::Part_box;

struct In_plane
{
  const double* x;
  std::pair<double, double> bounds_along(int axis) const { return {x[axis], x[axis]}; }
};

// The boxes of a part, by their numbers. Those without points are empty.
std::vector<std::vector<Box_of_points>> boxes_of_parts(const internal::Bisection& parts,
                                                       int part_count,
                                                       const internal::Point_sample& points)
{
  const std::vector<Box_of_points> none(internal::Bisection::max_boxes, Box_of_points(2));
  std::vector<std::vector<Box_of_points>> boxes(static_cast<std::size_t>(part_count), none);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const double* const x = points.point(i);
    const internal::Bisection::Part_place place = parts.find(x, points.ids[i]);
    boxes.at(static_cast<std::size_t>(place.part)).at(place.box).add(In_plane{x});
  }
  return boxes;
}

// A part around another one would have that part in its box, if it had a single box.
BOOST_AUTO_TEST_CASE(boxes_of_different_parts_are_apart)
{
  const internal::Point_sample points = points_with_crowd();
  const internal::Bisection parts(points, 8, 0.01);
  const auto boxes = boxes_of_parts(parts, 8, points);
  for(std::size_t part = 0; part < boxes.size(); ++part)
    for(std::size_t i = 0; i < points.size(); ++i)
      for(const Box_of_points& box : boxes[part]) {
        const double* const x = points.point(i);
        const bool is_own = parts.owner(x, i) == static_cast<int>(part);
        BOOST_REQUIRE(is_own || !box.is_near(In_plane{x}, 0));
      }
}

BOOST_AUTO_TEST_CASE(parts_with_even_pairs_have_one_box)
{
  const internal::Point_sample points = random_points(5000, 10, 1);
  for(const auto& boxes : boxes_of_parts(internal::Bisection(points, 7, 0.01), 7, points))
    BOOST_CHECK_EQUAL(std::count_if(boxes.begin(), boxes.end(), [](const Box_of_points& box) {
      return !box.is_empty();
    }), 1);
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
  BOOST_CHECK_LT(largest_over_average(loads(parts, 7, points)), 1.05);
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

// Returns for each part the tree of its own cuts and those of all others.
std::vector<internal::Bisection> shared_trees(const internal::Point_sample& points, int part_count)
{
  std::vector<internal::Bisection> trees;
  for(int part = 0; part < part_count; ++part)
    trees.emplace_back(points, part_count, 0.01, part);
  std::vector<internal::Bisection::Cut> cuts;
  for(const internal::Bisection& tree : trees)
    cuts.insert(cuts.end(), tree.own_cuts().begin(), tree.own_cuts().end());
  for(internal::Bisection& tree : trees)
    tree.add(cuts);
  return trees;
}

BOOST_AUTO_TEST_CASE(parts_that_share_the_work_make_the_same_cuts)
{
  const internal::Point_sample others = random_points(1000, 10, 10);
  for(const internal::Point_sample& points :
      {points_with_crowd(), random_points(2000, 10, 1), random_points(3, 1, 1),
       random_points(0, 1, 1), random_points(500, 0, 0)})
    for(const int part_count : {1, 2, 3, 7, 16}) {
      const internal::Bisection whole(points, part_count, 0.01);
      for(const internal::Bisection& tree : shared_trees(points, part_count))
        for(const internal::Point_sample* sample : {&points, &others})
          for(std::size_t i = 0; i < sample->size(); i += 5) {
            const auto expected = whole.find(sample->point(i), sample->ids[i]);
            const auto found = tree.find(sample->point(i), sample->ids[i]);
            BOOST_REQUIRE_EQUAL(found.part, expected.part);
            BOOST_REQUIRE_EQUAL(found.box, expected.box);
          }
    }
}

BOOST_AUTO_TEST_CASE(there_may_be_fewer_points_than_parts)
{
  const std::vector<double> x = {(std::numeric_limits<double>::max)(), 0};
  for(const std::size_t size : {0, 1, 3}) {
    const internal::Point_sample points = random_points(size, 1, 1);
    const internal::Bisection parts(points, 7, 1);
    const std::vector<double> sums = loads(parts, 7, points);
    BOOST_CHECK(size == 0 || *std::max_element(sums.begin(), sums.end()) == 1);
    BOOST_CHECK_GE(parts.owner(x, 5), 0);
    BOOST_CHECK_LT(parts.owner(x, 5), 7);
  }
}

BOOST_AUTO_TEST_SUITE_END()
