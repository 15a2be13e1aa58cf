// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lists of neighbours against brute force: each neighbour once, on both sides, in order.

#include "support/brute_force.h"
#include "support/kernels.h"
#include "support/unit_test.h"

#include <CGAL/Epick_d.h>
#include <CGAL/neighbor_squared_distances.h>
#include <CGAL/property_map.h>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Plane = Cartesian_points<Kernel, 2>;

namespace {

void check_lists(const CGAL::Neighbor_lists& lists, const Points& points, double r)
{
  const Pairs pairs = brute_force(points, Radius::of_length(r)).pairs;
  BOOST_REQUIRE_EQUAL(lists.size(), points.size());
  BOOST_CHECK(pairs_in_lists(lists) == in_both_orders(pairs));
  BOOST_CHECK_EQUAL(lists.number_of_pairs(), pairs.size());
  BOOST_CHECK_EQUAL(lists.begins().back(), lists.positions().size());
}

template <class Maker>
void check_lists(const Points& points, double r)
{
  check_lists(CGAL::fixed_radius_neighbor_lists(make_points<Maker>(points),
                                                CGAL::within_distance(r)),
              points, r);
}

} // namespace

BOOST_AUTO_TEST_CASE(short_and_long_lists)
{
  // Lists of up to 256 neighbours are sorted in a way of their own.
  for(const double r : {0., 0.01, 0.12, 0.24, 0.5, 2.})
    check_lists<Plane>(uniform_points(2, 1500, 0, 1, 3), r);
  check_lists<Cartesian_points<Kernel, 3>>(uniform_points(3, 2500, 0, 1, 4), 0.08);
}

// Positions take more than 16 bits, and there are bins of 16384 points. Points of a line have known
// neighbours.
BOOST_AUTO_TEST_CASE(lists_of_more_points_than_16_bits_tell_apart)
{
  const std::size_t size = 140000;
  const std::size_t step = 99991; // prime, hence the points are in another order than on the line
  const auto place = [&](std::size_t i) { return i * step % size; };
  std::vector<Kernel::Point_2> points;
  std::vector<CGAL::Neighbor_lists::Position> positions(size);
  for(std::size_t i = 0; i < size; ++i) {
    points.emplace_back(static_cast<double>(place(i)), 0);
    positions[place(i)] = static_cast<CGAL::Neighbor_lists::Position>(i);
  }
  const CGAL::Neighbor_lists lists
    = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(2));
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < size; ++i) {
    std::vector<CGAL::Neighbor_lists::Position> expected;
    for(const std::size_t p : {place(i) - 2, place(i) - 1, place(i) + 1, place(i) + 2})
      if(p < size)
        expected.push_back(positions[p]);
    std::sort(expected.begin(), expected.end());
    wrong += !std::equal(lists[i].begin(), lists[i].end(), expected.begin(), expected.end());
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
}

// Two of the points are denormal, and the third one is not to have them scaled down.
BOOST_AUTO_TEST_CASE(lists_of_denormal_numbers_beside_a_huge_one)
{
  const double d = std::numeric_limits<double>::denorm_min();
  const auto points = make_points<Plane>(
    {{5033165 * d, 0}, {-5033165 * d, 0}, {0x1p1023, 0}});
  const auto lists
    = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(10905190 * d));
  BOOST_CHECK_EQUAL(lists.number_of_pairs(), 1u);
}

BOOST_AUTO_TEST_CASE(lists_in_higher_dimension)
{
  using Maker = Points_d<CGAL::Epick_d<CGAL::Dimension_tag<5>>>;
  check_lists<Maker>(uniform_points(5, 300, 0, 1, 5), 0.4);
}

BOOST_AUTO_TEST_CASE(lists_of_few_points)
{
  using Point = Kernel::Point_2;
  const auto bound = CGAL::within_distance(1);
  BOOST_CHECK_EQUAL(CGAL::fixed_radius_neighbor_lists(std::vector<Point>(), bound).size(), 0u);
  const CGAL::Neighbor_lists one
    = CGAL::fixed_radius_neighbor_lists(std::list<Point>{Point(0, 0)}, bound);
  BOOST_CHECK_EQUAL(one.size(), 1u);
  BOOST_CHECK(one[0].empty());
  BOOST_CHECK(CGAL::Neighbor_lists() == CGAL::Neighbor_lists());
}

BOOST_AUTO_TEST_CASE(lists_are_a_range_of_lists)
{
  const Points points = uniform_points(2, 300, 0, 1, 8);
  const CGAL::Neighbor_lists lists = CGAL::fixed_radius_neighbor_lists(
    make_points<Plane>(points), CGAL::within_distance(0.1));
  BOOST_REQUIRE_EQUAL(lists.end() - lists.begin(), 300);
  std::size_t i = 0;
  for(const auto neighbors : lists) {
    BOOST_CHECK(neighbors == lists[i]);
    ++i;
  }
  BOOST_CHECK_EQUAL(i, 300u);
  BOOST_CHECK(lists.begin()[7] == lists[7]);
  const CGAL::Neighbor_lists none;
  BOOST_CHECK(none.begin() == none.end());
}

BOOST_AUTO_TEST_CASE(arrays_can_be_moved_out)
{
  CGAL::Neighbor_lists lists({0, 1, 2}, {1, 0});
  const std::size_t* const begins = lists.begins().data();
  const CGAL::Neighbor_lists::Position* const positions = lists.positions().data();
  const std::vector<CGAL::Neighbor_lists::Position> moved = std::move(lists).positions();
  const std::vector<std::size_t> moved_begins = std::move(lists).begins();
  BOOST_CHECK(moved.data() == positions);
  BOOST_CHECK(moved_begins.data() == begins);
  BOOST_CHECK((moved_begins == std::vector<std::size_t>{0, 1, 2}));
}

BOOST_AUTO_TEST_CASE(lists_that_were_moved_from_are_empty)
{
  CGAL::Neighbor_lists lists({0, 1, 2}, {1, 0});
  const CGAL::Neighbor_lists moved = std::move(lists);
  BOOST_CHECK_EQUAL(moved.size(), 2);
  BOOST_CHECK_EQUAL(lists.size(), 0);
  BOOST_CHECK(lists.begin() == lists.end());
}

BOOST_AUTO_TEST_CASE(lists_of_two_ranges_hold_positions_in_the_second)
{
  const Points a = uniform_points(2, 200, 0, 1, 9), b = uniform_points(2, 20000, 0, 1, 10);
  const auto points_a = make_points<Plane>(a);
  const auto points_b = make_points<Plane>(b);
  const auto bound = CGAL::within_distance(0.05);
  const auto check = [&](const auto& first, const auto& second) {
    const CGAL::Neighbor_lists lists = CGAL::fixed_radius_neighbor_lists(first, second, bound);
    const Pairs expected = sorted(near_pairs(first, second, bound));
    BOOST_CHECK_EQUAL(lists.size(), first.size());
    BOOST_CHECK_EQUAL(lists.number_of_pairs(), expected.size());
    BOOST_CHECK(pairs_in_lists(lists) == expected);
  };
  check(points_a, points_b);
  check(points_b, points_a);
  check(points_a, std::vector<Kernel::Point_2>());
}

// What was found until the progress functor cancels.
BOOST_AUTO_TEST_CASE(lists_of_a_cancelled_search)
{
  const std::vector<Kernel::Point_2> points(100, Kernel::Point_2(1, 2));
  const auto bound = CGAL::within_distance(1);
  const auto cancel = [](double done) { return done < 0.5; };
  const CGAL::Neighbor_lists lists
    = CGAL::fixed_radius_neighbor_lists(points, bound, CGAL::parameters::callback(cancel));
  BOOST_CHECK_EQUAL(lists.size(), 100u);
  BOOST_CHECK_GT(lists.number_of_pairs(), 0u);
  BOOST_CHECK_LT(lists.number_of_pairs(), 4950u);
}

// A total of neighbors that 32 bits do not hold would take 16 GB, so this asks for the type alone.
BOOST_AUTO_TEST_CASE(lists_may_begin_beyond_32_bits)
{
  using Begin = std::decay_t<decltype(CGAL::Neighbor_lists().begins()[0])>;
  BOOST_CHECK_EQUAL((std::numeric_limits<Begin>::max)(), (std::numeric_limits<std::size_t>::max)());
  BOOST_CHECK_GE(sizeof(Begin), sizeof(void*));
  BOOST_CHECK((std::is_same_v<Begin, decltype(CGAL::Neighbor_lists().number_of_pairs())>));
}

BOOST_AUTO_TEST_CASE(squared_distances_are_in_the_order_of_the_lists)
{
  const auto points = make_points<Plane>(uniform_points(2, 400, 0, 1, 11));
  const CGAL::Neighbor_lists lists
    = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(0.1));
  const std::vector<double> distances = CGAL::neighbor_squared_distances(lists, points);
  BOOST_REQUIRE_GT(distances.size(), 0u);
  BOOST_REQUIRE_EQUAL(distances.size(), lists.positions().size());
  for(std::size_t i = 0; i < lists.size(); ++i)
    for(std::size_t k = lists.begins()[i]; k < lists.begins()[i + 1]; ++k) {
      const auto& p = points[i];
      const auto& q = points[lists.positions()[k]];
      const double x = p.x() - q.x(), y = p.y() - q.y();
      BOOST_CHECK_EQUAL(distances[k], x * x + y * y);
    }
}

BOOST_AUTO_TEST_CASE(squared_distances_are_exact_if_the_kernel_is)
{
  using FT = CGAL::Exact_rational;
  using Point = CGAL::Simple_cartesian<FT>::Point_3;
  const FT third = FT(1) / 3;
  const std::list<Point> a = {Point(0, 0, 0), Point(third, 0, 0)};
  const std::vector<Point> b = {Point(1, 1, 1), Point(third, third, 2 * third)};
  const CGAL::Neighbor_lists lists({0, 2, 3}, {0, 1, 1}, false);
  const std::vector<FT> distances = CGAL::neighbor_squared_distances(lists, a, b);
  BOOST_CHECK((distances == std::vector<FT>{3, 2 * third, 5 * third * third}));
}

BOOST_AUTO_TEST_CASE(squared_distances_of_mapped_points_of_any_dimension)
{
  using Point = CGAL::Epick_d<CGAL::Dynamic_dimension_tag>::Point_d;
  const auto point_at = [](double x) {
    const std::array<double, 4> coordinates = {x, 2, x, 4};
    return Point(coordinates.begin(), coordinates.end());
  };
  const std::vector<std::pair<int, Point>> elements = {{7, point_at(1)}, {8, point_at(4)}};
  using Map = CGAL::Second_of_pair_property_map<std::pair<int, Point>>;
  const CGAL::Neighbor_lists lists({0, 1, 2}, {1, 0});
  const auto np = CGAL::parameters::point_map(Map());
  const std::vector<double> distances = CGAL::neighbor_squared_distances(lists, elements, np);
  BOOST_CHECK((distances == std::vector<double>{18, 18}));
  BOOST_CHECK(CGAL::neighbor_squared_distances(lists, elements, elements, np) == distances);
  BOOST_CHECK(CGAL::neighbor_squared_distances(lists, elements, CGAL::parameters::point_map(Map()))
              == distances); // not a second range
}

BOOST_AUTO_TEST_CASE(lists_of_other_points_have_no_distances)
{
  const std::vector<Kernel::Point_2> points(2, Kernel::Point_2(1, 2));
  const CGAL::Neighbor_lists of_three({0, 0, 0, 0}, {}), beyond({0, 1, 1}, {2});
  BOOST_CHECK_THROW(CGAL::neighbor_squared_distances(of_three, points), std::invalid_argument);
  BOOST_CHECK_THROW(CGAL::neighbor_squared_distances(beyond, points), std::invalid_argument);
  BOOST_CHECK(CGAL::neighbor_squared_distances(CGAL::Neighbor_lists(),
                                               std::vector<Kernel::Point_2>()).empty());
}

BOOST_AUTO_TEST_CASE(lists_that_were_moved_from_get_arrays_of_their_own)
{
  const Points scene_points = uniform_points(2, 500, 0, 1, 12);
  const auto points = make_points<Plane>(scene_points);
  CGAL::Neighbor_lists lists;
  std::vector<CGAL::Neighbor_lists> all;
  const std::vector<double> radii = {0.1, 0.08, 0.05};
  for(const double r : radii) {
    CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(r), lists);
    all.push_back(std::move(lists));
  }
  for(std::size_t i = 0; i < radii.size(); ++i)
    check_lists(all[i], scene_points, radii[i]);
}

// The arrays of lists are those of the lists before, if these are as long.
BOOST_AUTO_TEST_CASE(lists_are_replaced_in_their_memory)
{
  const Points scene_points = uniform_points(2, 500, 0, 1, 12);
  const auto points = make_points<Plane>(scene_points);
  const auto others = make_points<Plane>(uniform_points(2, 100, 0, 1, 13));
  CGAL::Neighbor_lists lists;
  BOOST_CHECK(CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(0.1), lists));
  check_lists(lists, scene_points, 0.1);
  const std::size_t* const begins = lists.begins().data();
  const std::uint32_t* const positions = lists.positions().data();

  for(const double r : {0.08, 0., 0.05, 2., 0.1}) {
    BOOST_CHECK(CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(r), lists));
    check_lists(lists, scene_points, r);
    BOOST_CHECK(lists.begins().data() == begins);
    if(r <= 0.08)
      BOOST_CHECK(lists.positions().data() == positions);
    const CGAL::Neighbor_lists of_two
      = CGAL::fixed_radius_neighbor_lists(others, points, CGAL::within_distance(r));
    BOOST_CHECK(CGAL::fixed_radius_neighbor_lists(others, points, CGAL::within_distance(r), lists));
    BOOST_CHECK(lists == of_two);
    BOOST_CHECK_EQUAL(lists.number_of_pairs(), of_two.number_of_pairs());
    BOOST_CHECK(lists.begins().data() == begins);
  }

  const CGAL::Neighbor_lists before = lists;
  BOOST_CHECK_THROW(CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(-1.), lists),
                    std::invalid_argument);
  BOOST_CHECK(lists == before);
  const auto cancel = [](double) { return false; };
  BOOST_CHECK(!CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(0.1), lists,
                                                 CGAL::parameters::callback(cancel)));
  BOOST_CHECK_EQUAL(lists.size(), points.size());
}
