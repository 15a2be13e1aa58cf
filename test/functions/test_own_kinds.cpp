// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects of two types, near objects of one's own, and what the profile says of distances.

#include "support/found_pairs.h"

#include <forward_list>
#include <limits>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Ball = std::pair<Point, double>;

// ---- objects of one's own -----------------------------------------------------------------------

// Neither can be copied, and nothing tells where they are but the traits.
struct Ship
{
  Ship(double first, double last) : first(first), last(last) {}
  Ship(Ship&&) = default;
  double first, last;
};
struct Lighthouse
{
  explicit Lighthouse(double place) : place(place) {}
  Lighthouse(Lighthouse&&) = default;
  double place;
};

struct Interval_of_sea
{
  std::pair<double, double> operator()(const Ship& ship, int) const
  {
    return {ship.first, ship.last};
  }
  std::pair<double, double> operator()(const Lighthouse& lighthouse, int) const
  {
    return {lighthouse.place - range, lighthouse.place + range};
  }
  double range;
};

void check_place(const Lighthouse& lighthouse, std::size_t position)
{
  if(lighthouse.place < 0)
    throw std::domain_error(std::to_string(position));
}

// A model of ThickIntersectionIntervalTraits_d for ships and lighthouses, in this order. It cannot
// be copied.
class Sea_traits
{
public:
  explicit Sea_traits(double range) : range_(range) {}
  Sea_traits(const Sea_traits&) = delete;
  using Dimension = CGAL::Dimension_tag<1>;
  int dimension() const { return 1; }
  Interval_of_sea interval_d_object() const { return {range_}; }
  auto do_intersect_d_object() const
  {
    return [range = range_](const Ship& ship, const Lighthouse& lighthouse) {
      return ship.first <= lighthouse.place + range && lighthouse.place - range <= ship.last;
    };
  }

  void check(const Lighthouse& lighthouse, std::size_t position) const
  {
    check_place(lighthouse, position);
  }

private:
  double range_;
};

// The same without check().
struct Trusting_sea_traits
{
  using Dimension = CGAL::Dimension_tag<1>;
  int dimension() const { return 1; }
  auto interval_d_object() const { return traits.interval_d_object(); }
  auto do_intersect_d_object() const { return traits.do_intersect_d_object(); }
  Sea_traits traits;
};

// A model of ThickDistanceTraits_d for them, and for ships alone.
struct Distances_at_sea
{
  int dimension() const { return 1; }
  Interval_of_sea interval_d_object() const { return {0}; }
  struct Is_within_distance_d
  {
    template <class NT>
    bool operator()(const Ship& ship, const Lighthouse& lighthouse,
                    const CGAL::Distance_bound<NT>& bound) const
    {
      return is_within(lighthouse.place - ship.last, ship.first - lighthouse.place, bound);
    }
    template <class NT>
    bool operator()(const Ship& a, const Ship& b, const CGAL::Distance_bound<NT>& bound) const
    {
      return is_within(b.first - a.last, a.first - b.last, bound);
    }
    template <class NT>
    static bool is_within(double left, double right, const CGAL::Distance_bound<NT>& bound)
    {
      const double distance = (std::max)({left, right, 0.});
      const double compared = bound.is_squared() ? distance * distance : distance;
      return bound.is_open() ? compared < bound.value() : compared <= bound.value();
    }
  };
  Is_within_distance_d is_within_distance_d_object() const { return {}; }

  void check(const Lighthouse& lighthouse, std::size_t position) const
  {
    check_place(lighthouse, position);
  }
  void check(const Ship& ship, std::size_t position) const
  {
    if(ship.last < ship.first)
      throw std::domain_error(std::to_string(position));
  }
};

std::vector<Ship> ships()
{
  std::vector<Ship> ships;
  for(const double x : {0, 3, 10, 20})
    ships.emplace_back(x, x + 2);
  return ships;
}

std::vector<Lighthouse> lighthouses()
{
  std::vector<Lighthouse> lighthouses;
  for(const double x : {6, 21})
    lighthouses.emplace_back(x);
  return lighthouses;
}

// An object with bbox() and do_intersect().
struct Buoy
{
  CGAL::Bbox_2 bbox() const { return {place, 0, place, 0}; }
  double place;
};
bool do_intersect(const Segment& segment, const Buoy& buoy)
{
  return segment.has_on(Point(buoy.place, 0));
}

void ignore(std::size_t, std::size_t) {}
void fail(std::size_t, std::size_t) { BOOST_ERROR("a pair before the checks"); }

BOOST_AUTO_TEST_SUITE(own_kinds)

BOOST_AUTO_TEST_CASE(traits_for_two_types)
{
  const std::vector<Ship> a = ships();
  const std::vector<Lighthouse> b = lighthouses();
  const Sea_traits near_traits(1), far_traits(4);
  BOOST_CHECK((pairs_between(a, b, CGAL::parameters::geom_traits(near_traits))
               == Pairs{{1, 0}, {3, 1}}));
  BOOST_CHECK((pairs_between(a, b, CGAL::parameters::geom_traits(far_traits))
               == Pairs{{0, 0}, {1, 0}, {2, 0}, {3, 1}}));
}

BOOST_AUTO_TEST_CASE(traits_for_two_types_need_no_checks)
{
  const Trusting_sea_traits traits{Sea_traits(1)};
  BOOST_CHECK((pairs_between(ships(), lighthouses(), CGAL::parameters::geom_traits(traits))
               == Pairs{{1, 0}, {3, 1}}));
}

BOOST_AUTO_TEST_CASE(own_object_beside_one_of_a_kernel)
{
  const std::vector<Segment> segments = {{Point(0, 0), Point(4, 0)}, {Point(3, -1), Point(3, 1)}};
  const std::vector<Buoy> buoys = {{1}, {3}, {9}};
  BOOST_CHECK((pairs_between(segments, buoys) == Pairs{{0, 0}, {0, 1}, {1, 1}}));
}

BOOST_AUTO_TEST_CASE(distances_of_own_objects)
{
  const std::vector<Ship> a = ships();
  const std::vector<Lighthouse> b = lighthouses();
  const auto near = [&](const auto& bound, const auto&... ranges) {
    return sorted(reported([&](auto collect) {
      CGAL::fixed_radius_near_neighbors(ranges..., bound, collect,
                                        CGAL::parameters::geom_traits(Distances_at_sea()));
    }));
  };
  BOOST_CHECK((near(CGAL::within_distance(1), a) == Pairs{{0, 1}}));
  BOOST_CHECK((near(CGAL::within_distance(1).open(), a).empty()));
  BOOST_CHECK((near(CGAL::within_squared_distance(16), a, b)
               == Pairs{{0, 0}, {1, 0}, {2, 0}, {3, 1}}));
  BOOST_CHECK((near(CGAL::within_squared_distance(16).open(), a, b) == Pairs{{1, 0}, {3, 1}}));
}

BOOST_AUTO_TEST_CASE(traits_for_two_types_check_what_they_take)
{
  std::vector<Ship> a = ships();
  std::vector<Lighthouse> b = lighthouses();
  b.emplace_back(-1);
  const Sea_traits traits(1);
  BOOST_CHECK_EQUAL(refusal<std::domain_error>([&] {
    CGAL::thick_intersection_d(a, b, fail, CGAL::parameters::geom_traits(traits));
  }), "6"); // the third one, after four ships
  const auto search = [&] {
    CGAL::fixed_radius_near_neighbors(a, b, CGAL::within_distance(9), fail,
                                      CGAL::parameters::geom_traits(Distances_at_sea()));
  };
  BOOST_CHECK_EQUAL(refusal<std::domain_error>(search), "6");
  a.emplace_back(8, 7);
  BOOST_CHECK_EQUAL(refusal<std::domain_error>(search), "4");
}

// ---- near objects of two types ------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(no_objects_are_closer_than_zero)
{
  const std::vector<Segment> segments = {{Point(0, 0), Point(1, 1)}, {Point(0, 1), Point(1, 0)}};
  BOOST_CHECK((near_pairs_of(segments, CGAL::within_distance(0)) == Pairs{{0, 1}}));
  BOOST_CHECK(near_pairs_of(segments, CGAL::within_distance(0).open()).empty());
  BOOST_CHECK(near_pairs_of(segments, CGAL::within_squared_distance(0).open()).empty());
  BOOST_CHECK((near_pairs_of(segments, CGAL::within_distance(1e-300).open()) == Pairs{{0, 1}}));
}

BOOST_AUTO_TEST_CASE(objects_whose_boxes_are_near_may_be_far)
{
  const std::vector<Segment> segments
    = {{Point(0, 0), Point(9, 9)}, {Point(6, 1), Point(8, 1)}, {Point(3, 2), Point(4, 2)}};
  BOOST_CHECK((near_pairs_of(segments, CGAL::within_distance(1)) == Pairs{{0, 2}}));
}

BOOST_AUTO_TEST_CASE(near_objects_are_checked)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Segment> segments = {{Point(0, 0), Point(1, 1)}, {Point(0, nan), Point(1, 0)}};
  BOOST_CHECK_THROW(
    CGAL::fixed_radius_near_neighbors(segments, CGAL::within_distance(1), fail),
    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(lists_and_elements_of_two_types)
{
  const std::list<Segment> segments = {{Point(0, 0), Point(4, 0)}, {Point(9, 0), Point(9, 9)}};
  const std::forward_list<Ball> balls = {{Point(9, -2), 1}, {Point(2, 7), .5}, {Point(4, 3), 2}};
  const CGAL::Neighbor_lists lists
    = CGAL::fixed_radius_neighbor_lists(segments, balls, CGAL::within_distance(1));
  BOOST_REQUIRE_EQUAL(lists.size(), 2u);
  BOOST_CHECK(std::vector<std::size_t>(lists[0].begin(), lists[0].end())
              == std::vector<std::size_t>{2});
  BOOST_CHECK(std::vector<std::size_t>(lists[1].begin(), lists[1].end())
              == std::vector<std::size_t>{0});
  std::vector<std::pair<Segment, Ball>> elements;
  CGAL::fixed_radius_near_neighbors(segments, balls, CGAL::within_distance(1),
                                    CGAL::with_elements(std::back_inserter(elements)));
  BOOST_REQUIRE_EQUAL(elements.size(), 2u);
  for(const auto& [segment, ball] : elements)
    BOOST_CHECK_EQUAL(segment.is_horizontal(), ball.second == 2);
}

// ---- the profile --------------------------------------------------------------------------------

// Segments of length 1 at the points of a lattice of step 2: neighbors are 1 or 2 apart.
std::vector<Segment> lattice(double step)
{
  std::vector<Segment> segments;
  for(int x = 0; x < 8; ++x)
    for(int y = 0; y < 8; ++y)
      segments.emplace_back(Point(2 * x * step, 2 * y * step),
                            Point((2 * x + 1) * step, 2 * y * step));
  return segments;
}

BOOST_AUTO_TEST_CASE(integers_decide_ties_on_a_grid)
{
  CGAL::Scene_profile profile;
  std::size_t count = 0;
  const auto add = [&](std::size_t, std::size_t) { ++count; };
  CGAL::fixed_radius_near_neighbors(lattice(1), CGAL::within_distance(1), add, profile);
  BOOST_CHECK_EQUAL(count, 7u * 8u);
  BOOST_CHECK_EQUAL(profile.degree(), 4);
  BOOST_CHECK(profile.is_of_distances());
  BOOST_CHECK(profile.tier() == CGAL::Arithmetic_tier::INT128);
  BOOST_CHECK_EQUAL(profile.decided(CGAL::Arithmetic_tier::INT128), 7u * 8u);
  BOOST_CHECK_EQUAL(profile.decided(CGAL::Arithmetic_tier::FILTERED_EXACT), 0u);

  profile.force_tier(CGAL::Arithmetic_tier::FILTERED_EXACT);
  CGAL::fixed_radius_near_neighbors(lattice(1), CGAL::within_distance(1), add, profile);
  BOOST_CHECK_EQUAL(count, 2 * 7u * 8u);
  BOOST_CHECK_EQUAL(profile.decided(CGAL::Arithmetic_tier::INT128), 0u);
  BOOST_CHECK_EQUAL(profile.decided(CGAL::Arithmetic_tier::FILTERED_EXACT), 7u * 8u);
}

BOOST_AUTO_TEST_CASE(the_bound_lengthens_the_reach_and_refines_the_grid)
{
  CGAL::Scene_profile profile;
  CGAL::fixed_radius_near_neighbors(lattice(1), CGAL::within_distance(.5), ignore, profile);
  BOOST_CHECK_EQUAL(profile.size(), 64u);
  BOOST_CHECK_EQUAL(profile.grid_exponent(), -1);
  BOOST_CHECK_CLOSE(profile.reach(), 2.5, 1e-9); // two lengths, and the bound
  CGAL::fixed_radius_near_neighbors(
    lattice(1), CGAL::within_distance(CGAL::Exact_rational(1) / 3), ignore, profile);
  BOOST_CHECK(!profile.has_grid());
}

BOOST_AUTO_TEST_CASE(exact_numbers_decide_ties_of_long_numbers)
{
  CGAL::Scene_profile profile;
  CGAL::fixed_radius_near_neighbors(lattice(.1), CGAL::within_distance(.1),
                                    ignore, profile);
  BOOST_CHECK(profile.tier() == CGAL::Arithmetic_tier::FILTERED_EXACT);
  BOOST_CHECK_GT(profile.decided(CGAL::Arithmetic_tier::FILTERED_EXACT), 0u);
  BOOST_CHECK_THROW(profile.force_tier(CGAL::Arithmetic_tier::INT128), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(degrees)
{
  CGAL::Scene_profile profile;
  const std::vector<Ball> balls = {Ball(Point(0, 0), 1), Ball(Point(2, 0), 1)};
  CGAL::thick_self_intersection_d(balls, ignore, profile);
  BOOST_CHECK_EQUAL(profile.degree(), 2);
  CGAL::thick_intersection_d(balls, lattice(1), ignore, profile);
  BOOST_CHECK_EQUAL(profile.degree(), 4);
  const std::vector<Point> points = {Point(0, 0)};
  CGAL::thick_intersection_d(points, lattice(1), ignore, profile);
  BOOST_CHECK_EQUAL(profile.degree(), 2);
  BOOST_CHECK(!profile.is_of_distances());

  const std::vector<Kernel::Segment_3> in_space
    = {{Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0)}};
  CGAL::fixed_radius_near_neighbors(in_space, CGAL::within_distance(1), ignore, profile);
  BOOST_CHECK_EQUAL(profile.degree(), 6);
  CGAL::fixed_radius_near_neighbors(lattice(1), CGAL::within_distance(1), ignore, profile);
  BOOST_CHECK_EQUAL(profile.degree(), 4);
}

BOOST_AUTO_TEST_SUITE_END()
