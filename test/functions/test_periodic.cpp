// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Searches of periodic domains: what they refuse, tell and count, how they stop, and how many
// images they make. That they find the right pairs, test_fuzz_periodic.cpp tests on random scenes;
// here are larger ones.

#include "support/check_pairs.h"
#include "support/kernels.h"
#include "support/periodic_oracle.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/periodic_closest_pair.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>

#include <boost/property_map/property_map.hpp>

BOOST_AUTO_TEST_SUITE(periodic)

using namespace test_support;

using Plain = CGAL::Simple_cartesian<double>;
using Lazy = CGAL::Exact_predicates_exact_constructions_kernel;

const Plain::Iso_rectangle_2 unit_square(0, 0, 1, 1);

// A callback that counts the pairs.
auto counter(std::size_t& count)
{
  return [&count](std::size_t, std::size_t, const Offset_of<2>&) { ++count; };
}

// Checks the pairs of points in a cube at the origin, and the closest one.
void check_cube(const Points& coordinates, double side, double radius)
{
  Lattice_scene<3> scene;
  const auto points = make_points<Cartesian_points<Plain, 3>>(coordinates);
  scene.points = coordinates;
  for(std::size_t k = 0; k < 3; ++k) {
    scene.vectors[k][k] = Rational(side);
    scene.repeats[k] = true;
  }
  scene.square = Rational(radius) * Rational(radius);
  const Periodic_oracle<3> oracle(scene);
  const std::vector<Image_pair<3>> expected = oracle.pairs();
  const Plain::Iso_cuboid_3 domain(0, 0, 0, side, side, side);
  std::vector<Image_pair<3>> found;
  CGAL::Scene_profile profile;
  CGAL::periodic_fixed_radius_near_neighbors(points, domain, CGAL::within_distance(radius),
                                             std::back_inserter(found), profile);
  std::sort(found.begin(), found.end());
  BOOST_CHECK_GE(profile.reach(), radius);
  BOOST_CHECK_GT(expected.size(), points.size());
  BOOST_CHECK(found == expected);
  Rational shortest = scene.square;
  for(const Image_pair<3>& pair : expected)
    shortest = (std::min)(shortest, oracle.square(pair));
  BOOST_CHECK_EQUAL(oracle.square(CGAL::periodic_closest_pair(points, domain)), shortest);
}

// Random points, lattices whose bound is that of ties, and a bound that is longer than the side.
BOOST_AUTO_TEST_CASE(hundreds_of_points_have_the_pairs_of_all_offsets)
{
  for(const double side : {1., 0.7})
    for(const double r : {0.15, 0.25})
      check_cube(uniform_points(3, 300, 0, side, 1), side, r * side);
  Points lattice = shuffled(lattice_points(3, 8, 0.125), 2);
  lattice.resize(400);
  for(const double r : {0.125, 0.25})
    check_cube(lattice, 1, r);
  check_cube(uniform_points(3, 30, 0, 0.3, 3), 0.3, 0.35);
}

template <class Domain>
std::string message_of(const std::vector<Plain::Point_2>& points, const Domain& domain, double r)
{
  std::size_t count = 0;
  return refusal<std::exception>([&] {
    CGAL::periodic_fixed_radius_near_neighbors(points, domain, CGAL::within_distance(r),
                                               counter(count));
  });
}

BOOST_AUTO_TEST_CASE(what_is_refused)
{
  using Vector = Plain::Vector_2;
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Plain::Point_2> points = {{0, 0}, {0.5, 0.5}};
  BOOST_CHECK_EQUAL(message_of(points, unit_square, 0.1), "");
  BOOST_CHECK_EQUAL(message_of({{0, 0}, {0, 1}}, unit_square, 0.1),
                    "Point 1 is not in the domain along axis 1. A Periodic_lattice_d of the domain "
                    "takes it.");
  BOOST_CHECK_EQUAL(message_of({{0, 0}, {0, 1}}, CGAL::Periodic_lattice_d(unit_square), 0.1), "");
  BOOST_CHECK_EQUAL(message_of(points, unit_square, infinity),
                    "The distance of a periodic search is infinite, or beyond the largest double.");
  BOOST_CHECK_EQUAL(message_of(points, unit_square, -1),
                    "The distance bound is negative or NaN.");
  BOOST_CHECK_EQUAL(message_of(points, unit_square, 1e9),
                    "The bound is 1000000000 periods long, and must be shorter than 268435456.");
  const CGAL::Periodic_lattice_d unit_lattice(unit_square);
  BOOST_CHECK_EQUAL(message_of({{0, 0}, {0x1p29 - 1, 0}}, unit_lattice, 0.1), "");
  BOOST_CHECK_EQUAL(message_of({{0, 0}, {0x1p29, 0}}, unit_lattice, 0.1),
                    "The scene is 536870912 periods long, and must be shorter than 536870912.");
  BOOST_CHECK_EQUAL(message_of({{0, 0}, {infinity, 0}}, unit_square, 0.1),
                    "Coordinate 0 of point 1 is NaN or infinite.");
  BOOST_CHECK_EQUAL(message_of(points, CGAL::Periodic_lattice_d(Vector(1, 2), Vector(3, 6)), 0.1),
                    "The periods of the lattice are linearly dependent.");
  BOOST_CHECK_EQUAL(message_of(points,
                               CGAL::Periodic_lattice_d(Vector(1, 2), Vector(infinity, 0)), 0.1),
                    "A period is NaN or infinite.");
  BOOST_CHECK_THROW(CGAL::periodic_closest_pair(std::vector<Plain::Point_2>(), unit_square),
                    std::invalid_argument);
}

// Their root is beyond the doubles, not their distance squared.
BOOST_AUTO_TEST_CASE(closest_pairs_beyond_the_doubles_are_refused)
{
  const std::vector<Plain::Point_2> point = {{0, 0}};
  const auto square = [](double x) { return Plain::Iso_rectangle_2(-x, -x, x, x); };
  BOOST_CHECK(CGAL::periodic_closest_pair(point, square(0.85e308))
              == (Image_pair<2>{0, 0, {0, 1}}));
  BOOST_CHECK_THROW(CGAL::periodic_closest_pair(point, square(1.7e308)), std::invalid_argument);
}

// Points that are equal, or are when they are moved: all n (n - 1) / 2 pairs would take minutes.
BOOST_AUTO_TEST_CASE(the_first_of_many_equal_points_are_found)
{
  const CGAL::Periodic_lattice_d lattice(unit_square);
  std::vector<Plain::Point_2> points(500000, Plain::Point_2(.5, .5));
  BOOST_CHECK(CGAL::periodic_closest_pair(points, unit_square) == (Image_pair<2>{0, 1, {}}));
  for(std::size_t i = 0; i < points.size(); ++i)
    points[i] = Plain::Point_2(static_cast<double>(i % 7), static_cast<double>(i % 3));
  BOOST_CHECK(CGAL::periodic_closest_pair(points, lattice) == (Image_pair<2>{0, 1, {-1, -1}}));
}

// Points that are whole periods apart, many of them on the boundary of a cell. The offset of a pair
// is the only one.
BOOST_AUTO_TEST_CASE(the_first_of_equal_images_are_found)
{
  using Vector = Plain::Vector_2;
  Random random(1);
  const auto coordinate = [&] { return static_cast<double>(random.below(60)) - 30; };
  for(int round = 0; round < 2000; ++round) {
    std::vector<Plain::Point_2> points;
    for(std::size_t n = 2 + random.below(20); points.size() < n;)
      points.emplace_back(coordinate(), coordinate());
    const auto lattice
      = round % 2 == 0 ? CGAL::Periodic_lattice_d<Vector>(Vector(3, 1), Vector(1, 2))
                       : CGAL::Periodic_lattice_d<Vector>(Vector(7, 2), Vector(3, 5));
    std::optional<Image_pair<2>> first;
    CGAL::periodic_fixed_radius_near_neighbors(
      points, lattice, CGAL::within_distance(0),
      [&](std::size_t i, std::size_t j, const Offset_of<2>& offset) {
        const Image_pair<2> pair(i, j, offset);
        first = first ? (std::min)(*first, pair) : pair;
      });
    if(first)
      BOOST_REQUIRE(CGAL::periodic_closest_pair(points, lattice) == *first);
  }
}

// Both the points and the images are decided by doubles alone, but not all of them at once.
BOOST_AUTO_TEST_CASE(a_tier_is_refused_before_a_pair_is_reported)
{
  using Vector = Plain::Vector_3;
  const std::vector<Plain::Point_3> points
    = {{0, 0, 0}, {290000000, 0, 0}, {150000000, 40000000, 0}};
  const CGAL::Periodic_lattice_d<Vector> lattice(
    std::array<Vector, 3>{Vector(300000000, 0, 3), Vector(0, 0, 0), Vector(0, 0, 0)},
    {true, false, false});
  CGAL::Scene_profile profile;
  profile.force_tier(CGAL::Arithmetic_tier::DOUBLE);
  std::size_t count = 0;
  BOOST_CHECK_THROW(
    CGAL::periodic_fixed_radius_near_neighbors(
      points, lattice, CGAL::within_distance(6e7),
      [&](std::size_t, std::size_t, const Offset_of<3>&) { ++count; }, profile),
    std::invalid_argument);
  BOOST_CHECK_EQUAL(count, 0u);
}

BOOST_AUTO_TEST_CASE(a_callback_stops_the_search)
{
  const std::vector<Plain::Point_2> points(50, Plain::Point_2(0, 0.5));
  const auto bound = CGAL::within_distance(0.1);
  int calls = 0;
  const auto stop_at_3 = [&](std::size_t, std::size_t, const Offset_of<2>&) { return ++calls < 3; };
  BOOST_CHECK(!CGAL::periodic_fixed_radius_near_neighbors(points, unit_square, bound, stop_at_3));
  BOOST_CHECK_EQUAL(calls, 3);
}

BOOST_AUTO_TEST_CASE(the_profile_does_not_change_if_a_callback_throws)
{
  const std::vector<Plain::Point_2> points = {{0, 0}, {0.5, 0.5}, {0.75, 0}};
  CGAL::Scene_profile profile;
  const auto refuse = [](std::size_t, std::size_t, const Offset_of<2>&) { throw 1; };
  BOOST_CHECK_THROW(CGAL::periodic_fixed_radius_near_neighbors(
                      points, unit_square, CGAL::within_distance(0.25), refuse, profile),
                    int);
  BOOST_CHECK_EQUAL(profile.size(), 0u);
}

// Then a search of many images can be cancelled before the first pair is reported.
BOOST_AUTO_TEST_CASE(reading_the_images_for_a_profile_is_a_step_of_progress)
{
  const std::vector<Plain::Point_2> points = {{0, 0}, {0.5, 0.5}, {0.75, 0}};
  const auto bound = CGAL::within_distance(0.25);
  std::size_t pairs = 0, tells = 0, tells_with_profile = 0;
  CGAL::Scene_profile profile;
  CGAL::periodic_fixed_radius_near_neighbors(
    points, unit_square, bound, counter(pairs),
    CGAL::parameters::callback([&](double) { return ++tells > 0; }));
  CGAL::periodic_fixed_radius_near_neighbors(
    points, unit_square, bound, counter(pairs), profile,
    CGAL::parameters::callback([&](double) { return ++tells_with_profile > 0; }));
  BOOST_CHECK_EQUAL(tells_with_profile, tells + 1);
}

// Threads are used if oneTBB is there.
BOOST_AUTO_TEST_CASE(several_threads_find_the_same)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const auto points = make_points<Cartesian_points<Plain, 2>>(uniform_points(2, 5000, 0, 1, 1));
  const auto bound = CGAL::within_distance(0.02);
  std::vector<Image_pair<2>> in_sequence, in_parallel;
  CGAL::periodic_fixed_radius_near_neighbors(points, unit_square, bound,
                                             std::back_inserter(in_sequence));
  CGAL::periodic_fixed_radius_near_neighbors<Tag>(points, unit_square, bound,
                                                  std::back_inserter(in_parallel));
  std::sort(in_sequence.begin(), in_sequence.end());
  std::sort(in_parallel.begin(), in_parallel.end());
  BOOST_CHECK_GT(in_sequence.size(), 10000u);
  BOOST_CHECK(in_parallel == in_sequence);
  BOOST_CHECK(CGAL::periodic_fixed_radius_neighbor_lists<Tag>(points, unit_square, bound)
              == CGAL::periodic_fixed_radius_neighbor_lists(points, unit_square, bound));
  BOOST_CHECK(CGAL::periodic_closest_pair<Tag>(points, unit_square)
              == CGAL::periodic_closest_pair(points, unit_square));
}

BOOST_AUTO_TEST_CASE(elements_are_handed_over)
{
  const std::vector<Plain::Point_2> points = {{0, 0}, {0.75, 0}};
  int calls = 0;
  CGAL::periodic_fixed_radius_near_neighbors(
    points, unit_square, CGAL::within_distance(0.25),
    CGAL::with_elements([&](const Plain::Point_2& p, const Plain::Point_2& q, Offset_of<2> offset) {
      ++calls;
      BOOST_CHECK_EQUAL(&p, &points[0]);
      BOOST_CHECK_EQUAL(&q, &points[1]);
      BOOST_CHECK(offset == (Offset_of<2>{-1, 0}));
    }));
  BOOST_CHECK_EQUAL(calls, 1);
}

// The periods are on the grid of the points: integers decide all ties, no exact number.
BOOST_AUTO_TEST_CASE(a_grid_with_its_periods_needs_no_exact_numbers)
{
  std::vector<Plain::Point_2> points;
  for(int i = 0; i < 40; ++i)
    for(int j = 0; j < 40; ++j)
      points.emplace_back(i, j);
  CGAL::Scene_profile profile;
  std::size_t count = 0;
  CGAL::periodic_fixed_radius_near_neighbors(
    points, Plain::Iso_rectangle_2(0, 0, 40, 40), CGAL::within_distance(1),
    counter(count), profile);
  BOOST_CHECK_EQUAL(count, 2 * 1600);
  BOOST_CHECK_EQUAL(profile.tier(), CGAL::Arithmetic_tier::DOUBLE);
  BOOST_CHECK_EQUAL(profile.decided(CGAL::Arithmetic_tier::FILTERED_EXACT), 0u);
  BOOST_CHECK_EQUAL(profile.range(0).second, 40);
}

// Images that are moved by several periods are doubles on the grid as well.
BOOST_AUTO_TEST_CASE(a_bound_beyond_the_domain_needs_no_exact_numbers_on_a_grid)
{
  const std::vector<Plain::Point_2> points = {{0, 0}, {1, 2}, {3, 1}};
  CGAL::Scene_profile profile;
  std::size_t count = 0;
  CGAL::periodic_fixed_radius_near_neighbors(
    points, Plain::Iso_rectangle_2(0, 0, 4, 4), CGAL::within_distance(10),
    counter(count), profile);
  BOOST_CHECK_GT(count, 60u);
  BOOST_CHECK_EQUAL(profile.tier(), CGAL::Arithmetic_tier::DOUBLE);
  BOOST_CHECK_EQUAL(profile.decided(CGAL::Arithmetic_tier::FILTERED_EXACT), 0u);
}

// Counts how often a search reads a point: about how many images it makes.
template <class Point>
struct Counting_map
{
  using key_type = Point;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;
  std::size_t* reads;

  friend const Point& get(const Counting_map& map, const Point& point)
  {
    ++*map.reads;
    return point;
  }
};

// Of the search of one range, or between two.
template <class Domain, class Points, class... Others>
std::size_t reads_of(const Domain& domain, double r, const Points& points, const Others&... others)
{
  std::size_t reads = 0;
  const Counting_map<typename Points::value_type> map{&reads};
  CGAL::periodic_fixed_radius_near_neighbors(points, others..., domain, CGAL::within_distance(r),
                                             [](std::size_t, std::size_t, const auto&) {},
                                             CGAL::parameters::point_map(map));
  return reads;
}

// Points in quarters of a cell, so that doubles hold them up to 2^50.
template <class Kernel>
std::vector<typename Kernel::Point_3> quarters(const typename Kernel::FT& start)
{
  std::vector<typename Kernel::Point_3> points;
  for(int i = 0; i < 60; ++i)
    points.emplace_back(start + i % 4 / 4., start + i / 4 % 4 / 4., start + i / 16 / 4.);
  return points;
}

// Far away, a point more or less is looked at twice, whether it is near the boundary.
BOOST_AUTO_TEST_CASE(a_search_makes_as_many_images_anywhere)
{
  using Vector = Plain::Vector_3;
  for(const double start : {0x1p20, -0x1p40, 0x1p48, -0x1p50}) {
    const auto at_zero = quarters<Plain>(0), far = quarters<Plain>(start);
    const auto box = [](double x) { return Plain::Iso_cuboid_3(x, x, x, x + 1, x + 1, x + 1); };
    BOOST_CHECK_LE(reads_of(box(start), .25, far),
                   reads_of(box(0), .25, at_zero) + far.size());
    for(const Vector& w : {Vector(0, 0, 1), Vector(.25, .5, 1), Vector(5, -3, 1)}) {
      const CGAL::Periodic_lattice_d lattice(Vector(1, 0, 0), Vector(.25, 1, 0), w);
      BOOST_CHECK_EQUAL(reads_of(lattice, .25, far), reads_of(lattice, .25, at_zero));
    }
  }
}

template <class Points, class Lattice>
std::vector<Image_pair<3>> pairs_within(double r, const Points& points, const Lattice& lattice)
{
  std::vector<Image_pair<3>> pairs;
  CGAL::periodic_fixed_radius_near_neighbors(points, lattice, CGAL::within_distance(r),
                                             std::back_inserter(pairs));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// All doubles around the coordinates are the same two, or few.
BOOST_AUTO_TEST_CASE(a_search_makes_as_many_images_of_exact_points_anywhere)
{
  using Vector = Lazy::Vector_3;
  for(const double start : {0x1p40, -0x1p60, 0x1p100}) {
    const auto at_zero = quarters<Lazy>(Lazy::FT(0) / 3), far = quarters<Lazy>(Lazy::FT(start) / 3);
    for(const Vector& w : {Vector(0, 0, 1), Vector(.25, .5, 1)}) {
      const CGAL::Periodic_lattice_d lattice(Vector(1, 0, 0), Vector(0, 1, 0), w);
      const std::size_t reads = reads_of(lattice, .25, at_zero);
      BOOST_CHECK_LE(reads_of(lattice, .25, far), 12 * reads); // exact tests read points, too
      BOOST_CHECK(pairs_within(.25, far, lattice) == pairs_within(.25, at_zero, lattice));
    }
  }
}

BOOST_AUTO_TEST_CASE(no_image_is_made_if_a_range_is_empty)
{
  const std::vector<Plain::Point_2> points(1000, Plain::Point_2(.5, .5)), none;
  const double radius = 1e6; // there would be too many images
  BOOST_CHECK_LE(reads_of(unit_square, radius, none, points), 10 * points.size());
  BOOST_CHECK_LE(reads_of(unit_square, radius, points, none), 10 * points.size());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Plain::Point_2> not_finite = {{nan, 0}}, outside = {{2, 0}};
  BOOST_CHECK_THROW(reads_of(CGAL::Periodic_lattice_d(unit_square), 1, none, not_finite),
                    std::invalid_argument);
  BOOST_CHECK_THROW(reads_of(unit_square, 1, none, outside), std::invalid_argument);
  BOOST_CHECK_THROW(reads_of(unit_square, 1e9, points, none), std::length_error);
}

BOOST_AUTO_TEST_CASE(images_are_those_of_the_range_that_has_fewer)
{
  const std::vector<Plain::Point_2> many(1000, Plain::Point_2(.5, .5)), one = {{.25, .5}};
  const std::size_t images = 81 * 81;
  BOOST_CHECK_LE(reads_of(unit_square, 40, one, many), 20 * images);
  BOOST_CHECK_LE(reads_of(unit_square, 40, many, one), 20 * images);
}

// The images are counted before one is made.
BOOST_AUTO_TEST_CASE(too_many_images_are_refused_with_their_number)
{
  const std::vector<Plain::Point_2> points = {{0, 0}};
  const Plain::Iso_rectangle_2 box(0, 0, 1e-6, 1e-6);
  BOOST_CHECK_EQUAL(message_of(points, box, .5),
                    "There are 500001000000 images of points within the bound, and a search takes "
                    "less than 2147483647.");
  const auto bound = CGAL::within_distance(.5);
  BOOST_CHECK_THROW(CGAL::periodic_fixed_radius_neighbor_lists(points, box, bound),
                    std::length_error);
  BOOST_CHECK_THROW(CGAL::periodic_fixed_radius_neighbor_lists(points, points, box, bound),
                    std::length_error);
}

// There are two million images, in eight batches.
BOOST_AUTO_TEST_CASE(a_progress_functor_stops_the_making_of_images)
{
  const std::vector<Plain::Point_2> points = {{0, 0}, {.5, .5}};
  for(const double end : {0., .05, .1, .2}) {
    std::size_t pairs = 0;
    double last = 0;
    CGAL::Scene_profile profile;
    const auto count = counter(pairs);
    const auto stop = CGAL::parameters::callback([&](double done) {
      last = done;
      return done < end;
    });
    const auto bound = CGAL::within_distance(1000.);
    BOOST_CHECK(
      !CGAL::periodic_fixed_radius_near_neighbors(points, unit_square, bound, count, stop));
    BOOST_CHECK_LT(last, end + .1);
    BOOST_CHECK(!CGAL::periodic_fixed_radius_near_neighbors(points, unit_square, bound, count,
                                                            profile, stop));
    BOOST_CHECK_LT(last, end + .1);
    BOOST_CHECK_EQUAL(CGAL::periodic_fixed_radius_neighbor_lists(points, unit_square, bound, stop)
                        .size(), points.size());
    BOOST_CHECK_LT(last, end + .1);
    BOOST_CHECK_LT(pairs, 2'000'000u); // two searches stop in their first batch
  }
}

// Of several batches of images.
BOOST_AUTO_TEST_CASE(many_images_are_counted_as_a_formula_counts_them)
{
  const std::vector<Plain::Point_2> points = {{0, 0}};
  const int radius = 400;
  std::size_t expected = 0; // those of one of two opposite offsets
  for(int x = -radius; x <= radius; ++x)
    for(int y = -radius; y <= radius; ++y)
      expected += x * x + y * y <= radius * radius;
  expected /= 2;
  std::size_t pairs = 0;
  CGAL::Scene_profile profile;
  CGAL::periodic_fixed_radius_near_neighbors(
    points, unit_square, CGAL::within_distance(radius),
    counter(pairs), profile);
  BOOST_CHECK_EQUAL(pairs, expected);
  BOOST_CHECK_GE(profile.range(0).second, radius);
  BOOST_CHECK_LE(profile.range(1).first, -radius);
  BOOST_CHECK_GE(profile.decided(CGAL::Arithmetic_tier::DOUBLE), expected);
  const auto lists = CGAL::periodic_fixed_radius_neighbor_lists(
    points, unit_square, CGAL::within_distance(radius));
  BOOST_CHECK_EQUAL(lists.number_of_pairs(), expected);
}

BOOST_AUTO_TEST_SUITE_END()
