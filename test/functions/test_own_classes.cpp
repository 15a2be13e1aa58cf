// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What users write: objects with an id, which are what their base is, objects of no kernel, and
// traits with another functor, which are asked.

#include "support/found_pairs.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/intersections.h>
#include <CGAL/thick_feature_intersection_d.h>

using namespace test_support;
using CGAL::within_distance;

namespace plans {

// Predicates of this kernel are those of rounded doubles.
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Triangle = Kernel::Triangle_3;

template <class Base>
struct With_id : Base
{
  With_id(const Base& base, int number) : Base(base), id(number) {}
  int id;
};

// A wire that meets others only on its own layer.
struct Wire : Segment
{
  Wire(const Segment& segment, int number) : Segment(segment), layer(number) {}
  int layer;
};

bool do_intersect(const Wire& a, const Wire& b)
{
  return a.layer == b.layer && CGAL::do_intersect(Segment(a), Segment(b));
}

// The same of a class that no other derives from.
struct Last_wire final : Wire
{
  using Wire::Wire;
};

bool do_intersect(const Last_wire& a, const Last_wire& b)
{
  return a.layer == b.layer;
}

// Two classes with a test of both, and none of one of them.
struct Pin : Point
{
  using Point::Point;
};

bool do_intersect(const Wire& wire, const Pin&)
{
  return wire.layer == 1;
}

// A wire with a radius, which meets others only on its own layer.
struct Thick_wire : std::pair<Segment, double>
{
  Thick_wire(const Segment& segment, double radius, int number)
    : std::pair<Segment, double>(segment, radius), layer(number)
  {}
  CGAL::Bbox_2 bbox() const { return CGAL::Bbox_2(-9, -9, 9, 9); }
  int layer;
};

bool do_intersect(const Thick_wire& a, const Thick_wire& b)
{
  return a.layer == b.layer;
}

// A class of its own, and no pair of an object and a radius. There is no test of two of them.
struct Span : std::pair<int, int>
{
  Span(int begin, int end) : std::pair<int, int>(begin, end) {}
  CGAL::Bbox_2 bbox() const { return CGAL::Bbox_2(first, 0, second, 1); }
};

bool do_intersect(const Span& span, const Thick_wire& wire)
{
  return span.first <= wire.layer && wire.layer <= span.second;
}

// A wire that is wider than its base, and has a box of its own.
struct Wide_wire : Segment
{
  using Segment::Segment;
  CGAL::Bbox_2 bbox() const
  {
    const CGAL::Bbox_2 box = Segment::bbox();
    return {box.xmin() - 1, box.ymin() - 1, box.xmax() + 1, box.ymax() + 1};
  }
};

bool do_intersect(const Wide_wire& a, const Wide_wire& b)
{
  return CGAL::do_overlap(a.bbox(), b.bbox());
}

// A segment that has its box at hand.
struct Boxed : Segment, CGAL::Bbox_2
{
  explicit Boxed(const Segment& segment) : Segment(segment), CGAL::Bbox_2(segment.bbox()) {}
};

// A point whose members hide those of its base.
struct Misleading : Point
{
  Misleading(double x, double y) : Point(x, y) {}
  double cartesian(int) const { return 0; }
  int dimension() const { return 3; }
};

// Numbers are small integers, so the test is exact.
struct Disk
{
  double x, y, radius;

  CGAL::Bbox_2 bbox() const { return {x - radius, y - radius, x + radius, y + radius}; }
};

bool do_intersect(const Disk& a, const Disk& b)
{
  const double radii = a.radius + b.radius;
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) <= radii * radii;
}

// The package has a function of this name for its own use, and is not to find this one.
void bounding_box(const Disk&);

} // namespace plans

namespace {

using plans::Kernel;
using plans::Point;
using plans::Segment;
using plans::Triangle;
using plans::With_id;

template <class Base>
std::vector<With_id<Base>> with_ids(const std::vector<Base>& objects)
{
  std::vector<With_id<Base>> result;
  for(const Base& object : objects)
    result.emplace_back(object, static_cast<int>(result.size()));
  return result;
}

template <class Object, class Traits>
Pairs pairs_by_traits(const std::vector<Object>& objects, const Traits& traits)
{
  return pairs_of(objects, CGAL::parameters::geom_traits(traits));
}

// Long segments whose ends are off by a few units in the last place, and short ones that they touch
// or miss.
std::vector<Segment> nearly_touching_segments()
{
  std::vector<Segment> segments;
  for(int i = 0; i < 40; ++i)
    for(int j = 0; j < 4; ++j)
      segments.emplace_back(Point(.5 + i * 0x1p-53, .5 + j * 0x1p-53), Point(24, 24));
  for(int i = 0; i < 6; ++i)
    segments.emplace_back(Point(12 + i, 12 + i), Point(12 + i, 20));
  return segments;
}

// By rational numbers, which share no code with the package.
Pairs exact_pairs(const std::vector<Segment>& segments)
{
  using Exact_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const CGAL::Cartesian_converter<Kernel, Exact_kernel> exact;
  std::vector<Exact_kernel::Segment_2> exact_segments;
  for(const Segment& segment : segments)
    exact_segments.push_back(exact(segment));
  return pairs_where(segments.size(), [&](std::size_t i, std::size_t j) {
    return CGAL::do_intersect(exact_segments[i], exact_segments[j]);
  });
}

// Two touch, one is flat, one is a point, one is apart.
std::vector<Triangle> degenerate_triangles()
{
  using P = Kernel::Point_3;
  return {{P(0, 0, 0), P(2, 0, 0), P(1, 0, 0)},   {P(1, -1, 0), P(1, 1, 0), P(1, 0, 0)},
          {P(0, 0, 0), P(0, 0, 0), P(0, 0, 0)},   {P(-1, -1, 0), P(3, -1, 0), P(0, 3, 0)},
          {P(0, 0, 9), P(1, 0, 9), P(0, 1, 9)}};
}

// ---- objects ------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(segment_with_an_id_is_decided_exactly)
{
  const std::vector<Segment> segments = nearly_touching_segments();
  const auto objects = with_ids(segments);
  const Pairs expected = exact_pairs(segments);
  BOOST_REQUIRE(expected.size() > 100);
  BOOST_CHECK(pairs_of(objects) == expected);
  BOOST_CHECK(near_pairs_of(objects, within_distance(0)) == expected);

  // Its traits may be named, and derived from another type than the elements have.
  using Object = With_id<Segment>;
  BOOST_CHECK(pairs_by_traits(objects, CGAL::Thick_object_traits_d<Object>(objects)) == expected);
  BOOST_CHECK(pairs_by_traits(objects, CGAL::Thick_object_traits_d<Segment>(segments))
              == expected);

  // In a variant, and in one of two ranges.
  const std::vector<std::variant<Point, Object>> variants(objects.begin(), objects.end());
  BOOST_CHECK(pairs_of(variants) == expected);
  BOOST_CHECK_EQUAL(pairs_between(objects, segments).size(),
                    2 * expected.size() + segments.size());

  CGAL::Scene_profile profile;
  Pairs pairs;
  CGAL::thick_self_intersection_d(objects, Pair_collector{pairs}, profile);
  BOOST_CHECK(sorted(pairs) == expected);
  BOOST_CHECK_EQUAL(profile.degree(), 2);
}

BOOST_AUTO_TEST_CASE(derived_objects_may_be_degenerate)
{
  const std::vector<Triangle> triangles = degenerate_triangles();
  const Pairs expected = {{0, 1}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  BOOST_CHECK(pairs_of(triangles) == expected);
  BOOST_CHECK(pairs_of(with_ids(triangles)) == expected);
  BOOST_CHECK(near_pairs_of(with_ids(triangles), within_distance(.5))
              == near_pairs_of(triangles, within_distance(.5)));
  auto objects = with_ids(triangles);
  objects.emplace_back(
    Triangle({0, 0, 0}, {1, 0, 0}, {NAN, 0, 0}), 5);
  BOOST_CHECK_THROW(pairs_of(objects), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(box_and_point_with_an_id_are_known)
{
  const auto boxes = with_ids<CGAL::Bbox_2>({{0, 0, 1, 1}, {1, 1, 2, 2}, {5, 5, 6, 6}});
  BOOST_CHECK(pairs_of(boxes) == (Pairs{{0, 1}}));
  BOOST_CHECK(near_pairs_of(boxes, within_distance(5)) == (Pairs{{0, 1}, {1, 2}}));
  const auto points = with_ids<Point>({{0, 0}, {0, 0}, {3, 4}});
  BOOST_CHECK(pairs_of(points) == (Pairs{{0, 1}}));
  BOOST_CHECK(near_pairs_of(points, within_distance(5)) == (Pairs{{0, 1}, {0, 2}, {1, 2}}));
  const std::vector<std::pair<With_id<Point>, double>> balls = {{points[0], 2}, {points[2], 3}};
  BOOST_CHECK(pairs_of(balls) == (Pairs{{0, 1}}));
  BOOST_CHECK(near_pairs_of(balls, within_distance(0)) == (Pairs{{0, 1}}));
}

// Points of a kernel that counts references have their coordinates elsewhere, and not in the array.
BOOST_AUTO_TEST_CASE(points_may_have_their_coordinates_elsewhere)
{
  std::vector<CGAL::Cartesian<double>::Point_2> points;
  for(int i = 0; i < 400; ++i)
    points.emplace_back(i % 20, i / 20);
  BOOST_CHECK_EQUAL(near_pairs_of(points, within_distance(1)).size(), 2 * 19 * 20);
}

BOOST_AUTO_TEST_CASE(derived_object_with_a_test_of_its_own_is_asked)
{
  const Segment across({0, 0}, {2, 2}), other({0, 2}, {2, 0});
  const std::vector<plans::Wire> wires = {{across, 1}, {other, 2}, {other, 1}, {across, 2}};
  BOOST_CHECK(pairs_of(wires) == (Pairs{{0, 2}, {1, 3}}));
  const std::vector<plans::Last_wire> last = {{across, 1}, {other, 2}, {other, 1}};
  BOOST_CHECK(pairs_of(last) == (Pairs{{0, 2}}));

  // Its box is its own, too.
  const std::vector<plans::Wide_wire> wide
    = {{Point(0, 0), Point(9, 0)}, {Point(0, 2), Point(9, 2)}, {Point(0, 5), Point(9, 5)}};
  BOOST_CHECK(pairs_of(wide) == (Pairs{{0, 1}}));

  // So it is if it has a radius.
  const std::vector<plans::Thick_wire> thick
    = {{across, 1, 1}, {other, 1, 2}, {Segment({8, 8}, {9, 9}), 1, 1}};
  BOOST_CHECK(pairs_of(thick) == (Pairs{{0, 2}}));

  // A class may derive from a pair of other things, and have a test with another class alone.
  const std::vector<plans::Span> spans = {{0, 1}, {2, 5}};
  BOOST_CHECK(pairs_between(spans, thick) == (Pairs{{0, 0}, {0, 2}, {1, 1}}));

  // An object of another class is tested as the segment that it is.
  const auto [long_ones, short_ones] = split(nearly_touching_segments(), 160);
  std::vector<plans::Wire> long_wires;
  for(const Segment& segment : long_ones)
    long_wires.emplace_back(segment, 1);
  BOOST_CHECK(pairs_between(long_wires, short_ones) == pairs_between(long_ones, short_ones));

  // The test of two classes is asked in either order.
  const std::vector<plans::Pin> pins = {{1, 1}};
  BOOST_CHECK(pairs_between(wires, pins) == (Pairs{{0, 0}, {2, 0}}));
  BOOST_CHECK(pairs_between(pins, wires) == (Pairs{{0, 0}, {0, 2}}));
}

BOOST_AUTO_TEST_CASE(segment_with_its_box_is_a_segment)
{
  const std::vector<Segment> segments = nearly_touching_segments();
  std::vector<plans::Boxed> boxed;
  for(const Segment& segment : segments)
    boxed.emplace_back(segment);
  BOOST_CHECK(pairs_of(boxed) == exact_pairs(segments));
}

BOOST_AUTO_TEST_CASE(members_that_hide_those_of_a_point_are_not_asked)
{
  std::vector<plans::Misleading> points;
  for(int i = 0; i < 400; ++i)
    points.emplace_back(i % 20, i / 20);
  BOOST_CHECK_EQUAL(near_pairs_of(points, within_distance(1)).size(), 2 * 19 * 20);
  points.resize(16, {0, 0});
  BOOST_CHECK_EQUAL(near_pairs_of(points, within_distance(1)).size(), 15);
}

struct Vacant_parcel : CGAL::Polygon_2<Kernel>
{
  using CGAL::Polygon_2<Kernel>::Polygon_2;
  bool is_empty() const { return true; } // no house is on it
};

struct Open_parcel : CGAL::Polygon_with_holes_2<Kernel>
{
  using CGAL::Polygon_with_holes_2<Kernel>::Polygon_with_holes_2;
  bool is_unbounded() const { return true; } // it has no fence
};

BOOST_AUTO_TEST_CASE(members_that_hide_those_of_a_polygon_are_not_asked)
{
  const Point corners[] = {{0, 0}, {1, 0}, {0, 1}};
  const std::vector<Vacant_parcel> parcels(2, Vacant_parcel(corners, corners + 3));
  const std::vector<Open_parcel> others(1, Open_parcel(parcels[0]));
  const auto pairs = reported([&](auto collect) {
    CGAL::thick_feature_intersection_d(parcels, others, collect);
  });
  BOOST_CHECK(sorted(pairs) == (Pairs{{0, 0}, {1, 0}}));
}

BOOST_AUTO_TEST_CASE(derived_features_are_what_their_base_is)
{
  using Polygon = CGAL::Polygon_2<Kernel>;
  using Polygon_with_holes = CGAL::Polygon_with_holes_2<Kernel>;
  const auto square = [](double low, double high) {
    const Point corners[] = {{low, low}, {high, low}, {high, high}, {low, high}};
    return Polygon(corners, corners + 4);
  };
  const auto pairs_of_features = [](const auto& features) {
    return sorted(reported([&](auto collect) {
      CGAL::thick_feature_self_intersection_d(features, collect);
    }));
  };
  // The second square is inside the first one: its boundary is not enough.
  BOOST_CHECK(pairs_of_features(with_ids<Polygon>({square(0, 9), square(2, 3)}))
              == (Pairs{{0, 1}}));
  Polygon_with_holes ring(square(0, 9));
  ring.add_hole(square(1, 8));
  BOOST_CHECK(pairs_of_features(with_ids<Polygon_with_holes>(
                {ring, Polygon_with_holes(square(2, 3)), Polygon_with_holes(square(0, 1))}))
              == (Pairs{{0, 2}}));
  const auto tracks = std::vector<std::vector<With_id<Point>>>{
    with_ids<Point>({{0, 0}, {2, 2}}), with_ids<Point>({{0, 2}, {2, 0}}),
    with_ids<Point>({{5, 5}})};
  BOOST_CHECK(pairs_of_features(tracks) == (Pairs{{0, 1}}));
  BOOST_CHECK(pairs_of_features(with_ids<Point>({{5, 5}, {5, 5}})) == (Pairs{{0, 1}}));
}

// ---- objects of no kernel -----------------------------------------------------------------------

using plans::Disk;

std::vector<Disk> random_disks(std::size_t n)
{
  Random random(1);
  const auto number = [&](std::uint64_t end) { return static_cast<double>(random.below(end)); };
  std::vector<Disk> disks;
  for(std::size_t i = 0; i < n; ++i) {
    const double x = number(200), y = number(200);
    disks.push_back({x, y, number(6)});
  }
  disks.front().radius = 80; // one giant
  return disks;
}

Pairs meeting_disks(const std::vector<Disk>& disks)
{
  return pairs_where(disks.size(), [&](std::size_t i, std::size_t j) {
    return do_intersect(disks[i], disks[j]);
  });
}

// A tile meets a segment if their boxes meet.
struct Tile
{
  CGAL::Bbox_2 box;
  CGAL::Bbox_2 bbox() const { return box; }
};

bool do_intersect(const Tile& tile, const plans::Segment& segment)
{
  return CGAL::do_overlap(tile.box, segment.bbox());
}

// Traits like those of the package, without intervals: three predicates are left.
struct Traits_without_intervals : CGAL::Thick_object_traits_d<Disk>
{
  using CGAL::Thick_object_traits_d<Disk>::Thick_object_traits_d;
  Interval_d interval_d_object() const = delete;
};

BOOST_AUTO_TEST_CASE(a_class_with_a_box_and_a_test_is_searched_without_traits)
{
  const std::vector<Disk> disks = random_disks(3000);
  const Pairs expected = meeting_disks(disks);
  BOOST_REQUIRE_GT(expected.size(), disks.size() / 2);
  check_pairs("in sequence", expected, pairs_of(disks));
  check_pairs("in parallel", expected, pairs_of<CGAL::Parallel_if_available_tag>(disks));
}

// Segments are not cut: what the stretches of them meet does not matter to the test.
BOOST_AUTO_TEST_CASE(a_class_is_asked_about_all_segments_whose_boxes_it_meets)
{
  Random random(3);
  std::vector<plans::Segment> segments;
  for(int i = 0; i < 20; ++i)
    segments.emplace_back(plans::Point(random.uniform(), random.uniform()),
                          plans::Point(random.uniform(), random.uniform()));
  std::vector<Tile> tiles;
  for(int i = 0; i < 1000; ++i) {
    const double x = random.uniform(), y = random.uniform();
    tiles.push_back({CGAL::Bbox_2(x, y, x + .01, y + .01)});
  }
  Pairs expected, found;
  for(std::size_t i = 0; i < tiles.size(); ++i)
    for(std::size_t j = 0; j < segments.size(); ++j)
      if(do_intersect(tiles[i], segments[j]))
        expected.emplace_back(i, j);
  CGAL::thick_intersection_d(tiles, segments, std::back_inserter(found));
  check_pairs("tiles and segments", expected, found);
}

BOOST_AUTO_TEST_CASE(derived_traits_without_intervals_take_the_recursive_route)
{
  const std::vector<Disk> disks = random_disks(300);
  check_pairs("disks", meeting_disks(disks),
              pairs_by_traits(disks, Traits_without_intervals(disks)));
}

// ---- radii --------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(radii_may_be_numbers_of_another_type)
{
  using Rational = CGAL::Exact_rational;
  const Point origin(0, 0), other(1, 0), third(2, 0);
  const Rational fraction = Rational(1) / 3;
  const std::vector<std::pair<Point, Rational>> balls
    = {{origin, fraction}, {other, 2 * fraction}, {third, fraction - Rational(1) / 1000000000}};
  BOOST_CHECK(pairs_of(balls) == (Pairs{{0, 1}}));
  BOOST_CHECK(near_pairs_of(balls, within_distance(0)) == (Pairs{{0, 1}}));
  BOOST_CHECK(near_pairs_of(balls, within_distance(1e-9)) == (Pairs{{0, 1}, {1, 2}}));

  // Of 62 bits, so that the rest is a number of this type as well, where it is wider than a double.
  const long double part = std::ldexp(std::floor(std::ldexp(1.L / 3, 62)), -62);
  const std::vector<std::pair<Point, long double>> long_balls
    = {{origin, part}, {other, 1 - part}, {third, std::nextafter(part, 0.L)}};
  BOOST_CHECK(pairs_of(long_balls) == (Pairs{{0, 1}}));
  const std::vector<std::variant<std::pair<Point, float>, Segment>> kinds
    = {std::pair(origin, .5f), Segment({.5, -1}, {.5, 1})};
  BOOST_CHECK(pairs_of(kinds) == (Pairs{{0, 1}}));
}

// With a radius, a wire is the segment that its base is, although it has a test of its own.
BOOST_AUTO_TEST_CASE(profile_has_the_grid_of_derived_objects_with_radii)
{
  const std::vector<std::pair<plans::Wire, double>> wires
    = {{{Segment({0, 0}, {2, .25}), 1}, 1}, {{Segment({0, 2.25}, {2, 2.25}), 2}, 1}};
  CGAL::Scene_profile profile;
  Pairs pairs;
  CGAL::thick_self_intersection_d(wires, Pair_collector{pairs}, profile);
  BOOST_CHECK(pairs == (Pairs{{0, 1}}));
  BOOST_CHECK_EQUAL(profile.grid_exponent(), -2);
}

// ---- traits -------------------------------------------------------------------------------------

// Traits of the package with another question: do two objects meet, unless they are equal?
template <class Traits>
struct Different_traits : Traits
{
  using Traits::Traits;
  using Object_d = typename Traits::Object_d;

  struct Do_intersect_d
  {
    const Traits& traits;
    bool operator()(const Object_d& a, const Object_d& b) const
    {
      return !(a == b) && traits.do_intersect_d_object()(a, b);
    }
  };

  Do_intersect_d do_intersect_d_object() const { return {*this}; }
};

struct Manhattan_distance
{
  int dimension() const { return 2; }
  struct Interval_d
  {
    std::pair<double, double> operator()(const Point& p, int axis) const
    {
      return {p[axis], p[axis]};
    }
  };
  struct Is_within_distance_d
  {
    template <class NT>
    bool operator()(const Point& p, const Point& q, const CGAL::Distance_bound<NT>& bound) const
    {
      return std::abs(p.x() - q.x()) + std::abs(p.y() - q.y()) <= bound.value();
    }
  };
  Interval_d interval_d_object() const { return {}; }
  Is_within_distance_d is_within_distance_d_object() const { return {}; }
};

BOOST_AUTO_TEST_CASE(traits_that_derive_from_those_of_the_package_are_asked)
{
  const Segment across({0, 0}, {2, 2}), other({0, 2}, {2, 0});
  const std::vector<Segment> segments = {across, other, across};
  const Pairs expected = {{0, 1}, {1, 2}}; // not the pair of equal objects
  using Segment_traits = CGAL::Thick_object_traits_d<Segment>;
  BOOST_CHECK(pairs_by_traits(segments, Different_traits<Segment_traits>(segments)) == expected);

  // Boxes would decide by themselves.
  const std::vector<CGAL::Bbox_2> boxes = {{0, 0, 1, 1}, {1, 1, 2, 2}, {0, 0, 1, 1}};
  using Box_traits = CGAL::Thick_object_traits_d<CGAL::Bbox_2>;
  BOOST_CHECK(pairs_by_traits(boxes, Different_traits<Box_traits>(boxes)) == expected);

  // Balls of one radius would be searched as points.
  const std::vector<std::pair<Point, double>> balls
    = {{Point(0, 0), 1}, {Point(2, 0), 1}, {Point(0, 0), 1}};
  using Ball_traits = CGAL::Thick_ball_traits_d<Point>;
  BOOST_CHECK(pairs_by_traits(balls, Different_traits<Ball_traits>(balls)) == expected);

  const std::vector<Point> points = {{0, 0}, {1, 0}, {0, 0}};
  using Point_traits = CGAL::Thick_point_traits_d<Point>;
  BOOST_CHECK(pairs_by_traits(points, Different_traits<Point_traits>(within_distance(1)))
              == expected);
}

// A functor that derives from that of the base is not cut down to it.
BOOST_AUTO_TEST_CASE(derived_functor_is_asked)
{
  using Base = CGAL::Thick_point_traits_d<Point>;
  struct Never : Base
  {
    using Base::Base;
    struct Functor : Base::Do_intersect_d
    {
      explicit Functor(const Base::Do_intersect_d& base) : Base::Do_intersect_d(base) {}
      bool operator()(const Point&, const Point&) const { return false; }
    };
    Functor do_intersect_d_object() const { return Functor(Base::do_intersect_d_object()); }
  };
  BOOST_CHECK(pairs_by_traits(std::vector<Point>{{0, 0}, {1, 0}}, Never(within_distance(1)))
                .empty());
}

BOOST_AUTO_TEST_CASE(distance_of_the_traits_is_that_of_points)
{
  const std::vector<Point> points = {{0, 0}, {.75, .75}, {1, .5}, {9, 9}};
  const auto np = CGAL::parameters::geom_traits(Manhattan_distance());
  Pairs pairs;
  CGAL::fixed_radius_near_neighbors(points, within_distance(1.25), Pair_collector{pairs}, np);
  BOOST_CHECK(pairs == (Pairs{{1, 2}}));
  BOOST_CHECK_EQUAL(CGAL::fixed_radius_neighbor_lists(points, within_distance(1.25), np)[0].size(),
                    0);
  pairs.clear();
  CGAL::fixed_radius_near_neighbors(points, points, within_distance(1.5), Pair_collector{pairs},
                                    np);
  BOOST_CHECK_EQUAL(pairs.size(), 10);
}

BOOST_AUTO_TEST_CASE(kernel_of_the_points_says_what_their_type_says)
{
  const std::vector<Point> points = {{0, 0}, {3, 4}};
  Pairs pairs;
  CGAL::Scene_profile profile;
  const auto np = CGAL::parameters::geom_traits(Kernel());
  CGAL::fixed_radius_near_neighbors(points, within_distance(5), Pair_collector{pairs}, profile, np);
  CGAL::fixed_radius_near_neighbors(with_ids(points), within_distance(5), Pair_collector{pairs},
                                    np);
  BOOST_CHECK_EQUAL(pairs.size(), 2);
  CGAL::thick_feature_self_intersection_d(points, Pair_collector{pairs}, np);
  BOOST_CHECK_EQUAL(pairs.size(), 2);
}

} // namespace
