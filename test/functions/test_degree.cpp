// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The algebraic degree of what the package decides, measured: coordinates are compared at degree 1,
// distances at degree 2, and nothing is decided at a higher degree. [V03, section 2]

#include "support/degree_traits.h"
#include "support/unit_test.h"

#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/Thick_object_traits_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

namespace {

using test_support::Degree_kernel;
using test_support::Degree_number;
using test_support::Degree_record;
using test_support::Degree_tally;

using Point_2 = Degree_kernel::Point_2;
using Point_3 = Degree_kernel::Point_3;

constexpr std::size_t n = 120;
constexpr int bits = 12; // a lattice of 32 units of 2^7

const Degree_number radius() { return Degree_number::input(5 * 128); }

template <class Point, int Dimension>
std::size_t count_by_all_pairs(const std::vector<Point>& points)
{
  std::size_t count = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = i + 1; j < points.size(); ++j)
      count += CGAL::squared_distance(points[i], points[j]) <= radius() * radius();
  return count;
}

template <class Objects, class Traits>
std::size_t count_pairs(const Objects& objects, const Traits& traits)
{
  std::size_t count = 0;
  CGAL::thick_self_intersection_d(
    objects, [&](std::size_t, std::size_t) { ++count; },
    CGAL::parameters::geom_traits(test_support::Traits_with_sites<Traits>(traits)));
  return count;
}

// The degrees at the three predicates of the traits, after a run of theirs.
void check_degrees_of_predicates(int less, int is_close, int do_intersect)
{
  const auto& sites = Degree_record::get().tallies();
  BOOST_TEST(sites.at("Less_coordinate_d").degree() == less);
  BOOST_TEST(sites.at("Is_close_along_axis_d").degree() == is_close);
  BOOST_TEST(sites.at("Do_intersect_d").degree() == do_intersect);
  BOOST_TEST(sites.at("").degree() == 0); // no sign is taken outside of the predicates
}

template <class Point, int Dimension>
void check_near_neighbors(bool hides_doubles)
{
  const std::vector<Point> points = test_support::degree_points<Point, Dimension>(n, bits, 1);
  const std::size_t expected = count_by_all_pairs<Point, Dimension>(points);
  std::size_t found = 0;
  Degree_record::get().restart(hides_doubles);
  CGAL::Scene_profile profile; // otherwise integers decide what the filter leaves
  profile.force_tier(CGAL::Arithmetic_tier::FILTERED_EXACT);
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(radius()),
                                    [&](std::size_t, std::size_t) { ++found; }, profile);
  const Degree_tally tally = Degree_record::get().total();
  BOOST_TEST(found == expected);
  BOOST_TEST(tally.degree() == 2);
  BOOST_TEST(profile.decided(CGAL::Arithmetic_tier::FILTERED_EXACT) > 0u);
  BOOST_TEST(tally.signs[2] >= profile.decided(CGAL::Arithmetic_tier::FILTERED_EXACT));
  BOOST_TEST(tally.degree_in_doubles == 1); // doubles see the input, nothing computed from it
}

template <class Point, int Dimension>
void check_point_traits()
{
  const std::vector<Point> points = test_support::degree_points<Point, Dimension>(n, bits, 2);
  const std::size_t expected = count_by_all_pairs<Point, Dimension>(points);
  const CGAL::Thick_point_traits_d<Point> traits(CGAL::within_distance(radius()));

  Degree_record::get().restart(true);
  BOOST_TEST(count_pairs(points, traits) == expected);
  check_degrees_of_predicates(1, 0, 2); // closeness is left to doubles,
  const auto& sites = Degree_record::get().tallies();
  BOOST_TEST(sites.at("Is_close_along_axis_d").degree_in_doubles == 1); // which see coordinates
}

template <class Point, int Dimension>
std::vector<std::pair<Point, Degree_number>> degree_balls(unsigned int seed)
{
  std::vector<std::pair<Point, Degree_number>> balls;
  for(const Point& p : test_support::degree_points<Point, Dimension>(n, bits, seed))
    balls.emplace_back(p, Degree_number::input(64. * static_cast<double>(1 + balls.size() % 6)));
  return balls;
}

template <class Point, int Dimension>
void check_ball_traits()
{
  const auto balls = degree_balls<Point, Dimension>(3);
  const CGAL::Thick_ball_traits_d<Point> traits(balls);
  Degree_record::get().restart(true);
  BOOST_TEST(count_pairs(balls, traits) > 0u);
  check_degrees_of_predicates(1, 0, 2);
}

// Pairs of near objects, of which the filter decides none. The distance of CGAL counts them first.
template <class A, class B>
void check_near_objects(const std::vector<A>& a, const std::vector<B>& b, int degree)
{
  std::size_t expected = 0, found = 0;
  for(const A& x : a)
    for(const B& y : b)
      expected += CGAL::squared_distance(x, y) <= radius() * radius();
  CGAL::Scene_profile profile; // otherwise integers decide
  profile.force_tier(CGAL::Arithmetic_tier::FILTERED_EXACT);
  Degree_record::get().restart(true);
  CGAL::fixed_radius_near_neighbors(a, b, CGAL::within_distance(radius()),
                                    [&](std::size_t, std::size_t) { ++found; }, profile);
  const Degree_tally tally = Degree_record::get().total();
  BOOST_TEST(found == expected);
  BOOST_TEST(expected > 0u);
  BOOST_TEST(expected < a.size() * b.size());
  BOOST_TEST(tally.degree() == degree);
  BOOST_TEST(profile.degree() == degree);
  BOOST_TEST(tally.degree_in_doubles == 1);
}

// Pairs of segments with a radius each, of which the filter decides none.
template <class Segment>
void check_thickened(const std::vector<Segment>& segments, int degree)
{
  std::vector<std::pair<Segment, Degree_number>> thickened;
  for(const Segment& segment : segments)
    thickened.emplace_back(
      segment, Degree_number::input(64. * static_cast<double>(1 + thickened.size() % 6)));
  const auto are_near = [](const auto& a, const auto& b) {
    const Degree_number sum = a.second + b.second;
    return CGAL::squared_distance(a.first, b.first) <= sum * sum;
  };
  const CGAL::Thick_object_traits_d<std::pair<Segment, Degree_number>> traits(thickened);
  std::size_t expected = 0, found = 0;
  for(const auto& a : thickened)
    for(const auto& b : thickened)
      expected += are_near(a, b);
  Degree_record::get().restart(true);
  for(const auto& a : thickened)
    for(const auto& b : thickened)
      found += traits.do_intersect_d_object()(a, b);
  BOOST_TEST(found == expected);
  BOOST_TEST(expected > thickened.size());
  BOOST_TEST(expected < thickened.size() * thickened.size());
  BOOST_TEST(Degree_record::get().total().degree() == degree);
}

template <class Segment, class Point>
std::vector<Segment> segments_between(const std::vector<Point>& points)
{
  std::vector<Segment> segments;
  for(std::size_t i = 0; i + 1 < points.size(); i += 2)
    if(points[i] != points[i + 1])
      segments.emplace_back(points[i], points[i + 1]);
  return segments;
}

} // namespace

BOOST_AUTO_TEST_CASE(near_objects_have_the_degree_of_the_profile)
{
  const auto points_2 = test_support::degree_points<Point_2, 2>(n / 2, bits, 4);
  const auto segments_2 = segments_between<Degree_kernel::Segment_2>(points_2);
  check_near_objects(points_2, segments_2, 4);
  check_near_objects(segments_2, segments_2, 4);
  const auto points_3 = test_support::degree_points<Point_3, 3>(n / 2, bits, 5);
  const auto segments_3 = segments_between<Degree_kernel::Segment_3>(points_3);
  check_near_objects(segments_3, segments_3, 6);
  std::vector<Degree_kernel::Triangle_3> triangles;
  for(std::size_t i = 0; i + 2 < points_3.size(); i += 3)
    if(!CGAL::collinear(points_3[i], points_3[i + 1], points_3[i + 2]))
      triangles.emplace_back(points_3[i], points_3[i + 1], points_3[i + 2]);
  check_near_objects(points_3, triangles, 6);
}

BOOST_AUTO_TEST_CASE(thickened_segments_have_the_degree_of_their_distance)
{
  const auto points_2 = test_support::degree_points<Point_2, 2>(n / 2, bits, 6);
  check_thickened(segments_between<Degree_kernel::Segment_2>(points_2), 4);
  const auto points_3 = test_support::degree_points<Point_3, 3>(n / 2, bits, 7);
  check_thickened(segments_between<Degree_kernel::Segment_3>(points_3), 6);
}

BOOST_AUTO_TEST_CASE(near_neighbors_have_degree_two)
{
  check_near_neighbors<Point_2, 2>(true);
  check_near_neighbors<Point_3, 3>(true);
}

BOOST_AUTO_TEST_CASE(near_neighbors_have_degree_two_where_a_filter_decides_first)
{
  check_near_neighbors<Point_2, 2>(false);
  check_near_neighbors<Point_3, 3>(false);
}

BOOST_AUTO_TEST_CASE(point_traits_compare_coordinates_at_degree_one_and_distances_at_two)
{
  check_point_traits<Point_2, 2>();
  check_point_traits<Point_3, 3>();
}

BOOST_AUTO_TEST_CASE(ball_traits_with_a_radius_each_have_degree_two)
{
  check_ball_traits<Point_2, 2>();
  check_ball_traits<Point_3, 3>();
}
