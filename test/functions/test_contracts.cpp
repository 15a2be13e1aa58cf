// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the public functions promise beyond the right pairs: which ranges and traits they take, what
// a callback is. What callbacks and progress may do, and the order of reports, is in test_faults
// and test_progress; what is refused, in test_refusals.

#include "support/brute_force.h"
#include "support/check_pairs.h"
#include "support/kernels.h"
#include "support/lattice_traits.h"
#include "support/scenes.h"

#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/closest_pair.h>
#include <CGAL/property_map.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <boost/iterator/transform_iterator.hpp>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Maker = Cartesian_points<Kernel, 2>;

namespace {

// Any object is at the origin of a line.
struct Distances_at_origin
{
  int dimension() const { return 1; }
  auto interval_d_object() const
  {
    return [](const auto&, int) { return std::pair<double, double>(0, 0); };
  }
  auto is_within_distance_d_object() const
  {
    return [](const auto&, const auto&, const auto&) { return true; };
  }
};

struct Points_at_origin
{
  using key_type = char;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;
  friend Point get(const Points_at_origin&, char) { return Point(0, 0); }
};

} // namespace

BOOST_AUTO_TEST_CASE(archetype_traits_are_enough)
{
  std::vector<Site> sites;
  for(long i = 0; i < 12; ++i)
    for(long j = 0; j < 12; ++j)
      sites.emplace_back(std::vector<long>{i, j, (i * j) % 5});
  Calls calls;
  const Lattice_traits traits(3, 2, 2, calls);
  const auto np = CGAL::parameters::geom_traits(traits);
  const auto middle = sites.begin() + 50;
  const auto a = boost::make_iterator_range(sites.begin(), middle);
  const auto b = boost::make_iterator_range(middle, sites.end());
  const Pairs one_set = reported([&](auto collect) {
    BOOST_CHECK(CGAL::thick_self_intersection_d(sites, collect, np));
  });
  const Pairs two_sets = reported([&](auto collect) {
    BOOST_CHECK(CGAL::thick_intersection_d(a, b, collect, np));
  });
  check_pairs("sites", pairs_of_sites(sites, 2), one_set, two_sets, 50);
  BOOST_CHECK_GT(calls.do_intersect, 0u); // its own state was used
}

BOOST_AUTO_TEST_CASE(any_range_of_points_will_do)
{
  const Point_scene scene
    = test_support::scene("uniform", 2, uniform_points(2, 300, 0, 1, 5), Radius::of_length(0.1));
  const Pairs& expected = truth_of(scene).pairs;
  const auto points = make_points<Maker>(scene.points);
  const auto check = [&](const char* what, const auto& range, const auto&... np) {
    check_pairs(what, expected, reported([&](auto collect) {
      CGAL::fixed_radius_near_neighbors(range, CGAL::within_distance(0.1), collect, np...);
    }));
  };
  check("list", std::list<Point>(points.begin(), points.end()));
  check("array", boost::make_iterator_range(points.data(), points.data() + points.size()));
  const auto make = [](const Coordinates& c) { return Maker::make(c); };
  check("points that are made when they are asked for",
        boost::make_iterator_range(boost::make_transform_iterator(scene.points.begin(), make),
                                   boost::make_transform_iterator(scene.points.end(), make)));
  using Named = std::pair<Point, int>;
  std::vector<Named> named;
  for(const Point& p : points)
    named.emplace_back(p, 1);
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Named>())
                    .geom_traits(Kernel());
  check("points within larger elements", named, np);
  BOOST_CHECK(CGAL::closest_pair(named, np) == CGAL::closest_pair(points));
  const auto bound = CGAL::within_distance(0.01);
  BOOST_CHECK(CGAL::find_close_pair(named, bound, np) == CGAL::find_close_pair(points, bound));
}

BOOST_AUTO_TEST_CASE(bound_of_any_number_type)
{
  const auto points = make_points<Maker>({{0, 0}, {3, 4}, {3, 4.5}});
  const Pairs expected = {{0, 1}, {1, 2}};
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(5))) == expected);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(5u))) == expected);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(5l))) == expected);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(5.f))) == expected);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(5.l))) == expected);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(CGAL::Exact_rational(5))))
              == expected);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(CGAL::Exact_integer(5))))
              == expected);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_squared_distance(25))) == expected);
  BOOST_CHECK(near_pairs(points, CGAL::within_squared_distance(25).open()) == (Pairs{{1, 2}}));
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(std::nextafter(5., 0.)))
              == (Pairs{{1, 2}}));
}

// Integers of any length hold neither 1.5 nor a third; the squared bound is none of them.
BOOST_AUTO_TEST_CASE(integers_as_coordinates_take_bounds_that_are_no_integers)
{
  using Point = CGAL::Simple_cartesian<CGAL::Exact_integer>::Point_2;
  CGAL::Exact_integer far = 1; // no double holds far + 1
  for(int i = 0; i < 120; ++i)
    far *= 2;
  const std::vector<Point> points
    = {{0, 0}, {1, 1}, {3, 3}, {3, 4}, {far, far}, {far + 1, far + 1}};
  const Pairs near = {{0, 1}, {2, 3}, {4, 5}};
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_distance(1.5))) == near);
  BOOST_CHECK(sorted(near_pairs(points, CGAL::within_squared_distance(2.5))) == near);
  BOOST_CHECK_EQUAL(near_pairs(points, CGAL::within_distance(CGAL::Exact_rational(4) / 3)).size(),
                    1u);
  BOOST_CHECK(CGAL::has_close_pair(points, CGAL::within_distance(1.5)));
  BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(0.5)));
  BOOST_CHECK(CGAL::closest_pair(points) == Pair(2, 3));
}

BOOST_AUTO_TEST_CASE(infinite_bound_reports_all_pairs)
{
  const auto points = make_points<Maker>({{0, 0}, {1e308, -1e308}, {-1e308, 1e308}});
  BOOST_CHECK_EQUAL(near_pairs(points, CGAL::within_distance(infinity)).size(), 3u);
  BOOST_CHECK_EQUAL(near_pairs(points, CGAL::within_distance(infinity).open()).size(), 3u);
}

// Nobody reads the elements: it would take long, and most of their memory is never there.
BOOST_AUTO_TEST_CASE(closest_pair_refuses_2_to_the_31_points_at_once)
{
  if constexpr(sizeof(std::size_t) > 4) {
    const std::size_t size = (std::size_t(1) << 31) - 1;
    const std::unique_ptr<char[]> memory(new char[size]);
    const auto range = boost::make_iterator_range(memory.get(), memory.get() + size);
    const auto np = CGAL::parameters::point_map(Points_at_origin());
    BOOST_CHECK_THROW(CGAL::closest_pair(range, np), std::length_error);
    BOOST_CHECK_THROW(CGAL::find_close_pair(range, CGAL::within_distance(1), np),
                      std::length_error);
  }
}

#ifdef __SSE2__
BOOST_AUTO_TEST_CASE(flushing_denormal_numbers_to_zero_is_refused)
{
  const auto points = make_points<Maker>(lattice_points(2, 3, 1));
  const std::vector<std::pair<Point, double>> balls = {{points[0], 1}, {points[1], 1}};
  const CGAL::Thick_ball_traits_d<Point> traits(balls);
  const auto ignore = [](std::size_t, std::size_t) {};
  const auto bound = CGAL::within_distance(1);
  const unsigned int state = _mm_getcsr();
  for(const unsigned int flag : {0x8000u, 0x0040u}) { // results are flushed, arguments are
    _mm_setcsr(state | flag);
    BOOST_CHECK_THROW(CGAL::fixed_radius_near_neighbors(points, bound, ignore),
                      std::runtime_error);
    BOOST_CHECK_THROW(CGAL::profile_scene(points, bound), std::runtime_error);
    BOOST_CHECK_THROW(CGAL::closest_pair(points), std::runtime_error);
    BOOST_CHECK_THROW(CGAL::find_close_pair(points, bound), std::runtime_error);
    BOOST_CHECK_THROW(
      CGAL::thick_self_intersection_d(balls, ignore, CGAL::parameters::geom_traits(traits)),
      std::runtime_error);
    BOOST_CHECK_THROW(CGAL::fixed_radius_near_neighbors(balls, bound, ignore), std::runtime_error);
    BOOST_CHECK_THROW(
      CGAL::fixed_radius_near_neighbors(
        balls, bound, ignore, CGAL::parameters::geom_traits(Distances_at_origin())),
      std::runtime_error);
    BOOST_CHECK_THROW(CGAL::thick_feature_self_intersection_d(points, ignore), std::runtime_error);
    _mm_setcsr(state);
    BOOST_CHECK(CGAL::fixed_radius_near_neighbors(points, bound, ignore));
  }
}
#endif
