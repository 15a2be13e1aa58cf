// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs of the user's elements instead of positions, and pairs for output iterators: the same pairs
// as of positions, and nothing is looked up but what is reported.

#include "support/check_pairs.h"
#include "support/kernels.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Surface_mesh.h>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Point_set = CGAL::Point_set_3<Point>;

namespace {

const auto bound = CGAL::within_distance(0.2);

std::vector<Point> some_points(std::size_t size, unsigned int seed)
{
  return make_points<Cartesian_points<Kernel, 3>>(uniform_points(3, size, 0, 1, seed));
}

// A mesh of vertices without faces, from which every third vertex is removed.
Mesh make_mesh_with_gaps(const std::vector<Point>& points)
{
  Mesh mesh;
  for(const Point& point : points)
    mesh.add_vertex(point);
  for(std::size_t i = 0; i < points.size(); i += 3)
    mesh.remove_vertex(Vertex(static_cast<Mesh::size_type>(i)));
  return mesh;
}

// The pairs of positions i < j with i and j not divisible by 3.
Pairs without_removed(const Pairs& pairs)
{
  Pairs result;
  for(const Pair& pair : pairs)
    if(pair.first % 3 != 0 && pair.second % 3 != 0)
      result.push_back(pair);
  return result;
}

using Box = std::array<double, 4>;

struct Bbox_of_box
{
  using key_type = Box;
  using value_type = CGAL::Bbox_2;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  friend value_type get(const Bbox_of_box&, const Box& b) { return {b[0], b[1], b[2], b[3]}; }
};

template <class Descriptor>
Pairs numbers_of(const std::vector<std::pair<Descriptor, Descriptor>>& pairs)
{
  Pairs numbers;
  for(const auto& pair : pairs)
    numbers.emplace_back(static_cast<std::size_t>(pair.first),
                         static_cast<std::size_t>(pair.second));
  return numbers;
}

} // namespace

BOOST_AUTO_TEST_CASE(vertices_of_a_mesh_after_removals)
{
  const std::vector<Point> points = some_points(600, 1);
  const Mesh mesh = make_mesh_with_gaps(points);
  const Pairs expected = without_removed(near_pairs(points, bound));
  BOOST_REQUIRE_GT(expected.size(), 100u);

  const auto np = CGAL::parameters::point_map(mesh.points());
  std::vector<std::pair<Vertex, Vertex>> pairs;
  CGAL::fixed_radius_near_neighbors(mesh.vertices(), bound,
                                    CGAL::with_elements(std::back_inserter(pairs)), np);
  check_pairs("written", expected, numbers_of(pairs));

  Pairs called;
  const auto call = [&](Vertex v, Vertex w) { called.emplace_back(v, w); };
  CGAL::fixed_radius_near_neighbors(mesh.vertices(), bound, CGAL::with_elements(call), np);
  BOOST_CHECK(called == numbers_of(pairs));
}

// The iterators over such a mesh go through it vertex by vertex.
BOOST_AUTO_TEST_CASE(vertices_of_a_large_mesh_after_removals_take_linear_time)
{
  const Mesh mesh = make_mesh_with_gaps(some_points(300000, 2));
  std::size_t count = 0;
  CGAL::fixed_radius_near_neighbors(
    mesh.vertices(), CGAL::within_distance(0.001), [&](std::size_t, std::size_t) { ++count; },
    CGAL::parameters::point_map(mesh.points()));
  BOOST_CHECK_LT(count, 1000u);
}

BOOST_AUTO_TEST_CASE(points_of_a_point_set_after_removals)
{
  const std::vector<Point> points = some_points(600, 3);
  Point_set set;
  for(const Point& point : points)
    set.insert(point);
  set.remove(set.begin() + 10);
  set.remove(set.begin() + 20);
  std::vector<std::pair<Point_set::Index, Point_set::Index>> pairs;
  CGAL::fixed_radius_near_neighbors(set, bound, CGAL::with_elements(std::back_inserter(pairs)));
  Pairs expected;
  for(const Pair& pair : near_pairs(points, bound))
    if(!set.is_removed(pair.first) && !set.is_removed(pair.second))
      expected.push_back(pair);
  Pairs found = numbers_of(pairs);
  for(Pair& pair : found) // removal changes the order of the set
    pair = {(std::min)(pair.first, pair.second), (std::max)(pair.first, pair.second)};
  check_pairs("elements", expected, found);
}

BOOST_AUTO_TEST_CASE(elements_of_two_ranges_of_different_types)
{
  const std::vector<Point> points = some_points(200, 4);
  const Mesh mesh = make_mesh_with_gaps(points);
  const std::list<Vertex> few = {Vertex(1), Vertex(2), Vertex(4)};
  Pairs found, expected;
  CGAL::fixed_radius_near_neighbors(
    few, mesh.vertices(), CGAL::within_distance(0.3),
    CGAL::with_elements([&](Vertex v, Vertex w) { found.emplace_back(v, w); }),
    CGAL::parameters::point_map(mesh.points()));
  for(const Vertex v : few)
    for(const Vertex w : mesh.vertices())
      if(CGAL::squared_distance(mesh.point(v), mesh.point(w)) <= 0.09)
        expected.emplace_back(v, w);
  check_pairs("elements", expected, found);
}

BOOST_AUTO_TEST_CASE(elements_are_those_of_the_range_and_not_copies)
{
  const std::vector<Point> points = some_points(200, 5);
  Pairs found;
  const bool is_complete = CGAL::fixed_radius_near_neighbors(
    points, bound, CGAL::with_elements([&](const Point& p, const Point& q) {
      found.emplace_back(&p - points.data(), &q - points.data());
      return true;
    }));
  BOOST_CHECK(is_complete);
  BOOST_CHECK(found == near_pairs(points, bound));
}

BOOST_AUTO_TEST_CASE(output_iterators_take_positions)
{
  const std::vector<Point> points = some_points(200, 6);
  Pairs found;
  CGAL::fixed_radius_near_neighbors(points, bound, std::back_inserter(found));
  BOOST_CHECK(found == near_pairs(points, bound));

  Pairs room(found.size());
  auto out = room.begin();
  CGAL::fixed_radius_near_neighbors(points, bound, out); // an lvalue advances
  BOOST_CHECK(out == room.end());
  BOOST_CHECK(room == found);
}

BOOST_AUTO_TEST_CASE(callback_of_elements_stops_the_search_by_returning_false)
{
  const std::vector<Point> points = some_points(200, 7);
  std::size_t calls = 0;
  auto stop = [&, left = 3](const Point&, const Point&) mutable {
    ++calls;
    return --left > 0;
  };
  const auto marked = CGAL::with_elements(stop);
  BOOST_CHECK(!CGAL::fixed_radius_near_neighbors(points, bound, marked));
  BOOST_CHECK_EQUAL(calls, 3u);
}

BOOST_AUTO_TEST_CASE(objects_behind_a_map)
{
  const std::vector<Box> boxes = {{0, 0, 1, 1}, {5, 5, 6, 6}, {1, 1, 2, 2}};
  const auto np = CGAL::parameters::point_map(Bbox_of_box());
  std::vector<std::pair<Box, Box>> pairs;
  CGAL::thick_self_intersection_d(boxes, CGAL::with_elements(std::back_inserter(pairs)), np);
  BOOST_REQUIRE_EQUAL(pairs.size(), 1u);
  BOOST_CHECK(pairs[0] == std::make_pair(boxes[0], boxes[2]));

  pairs.clear();
  const std::list<Box> others = {{7, 7, 8, 8}, {5.5, 5.5, 7, 7}};
  CGAL::thick_intersection_d(boxes, others, CGAL::with_elements(std::back_inserter(pairs)), np);
  BOOST_REQUIRE_EQUAL(pairs.size(), 1u);
  BOOST_CHECK(pairs[0] == std::make_pair(boxes[1], others.back()));
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(one_thread_at_a_time_writes_to_an_output_iterator)
{
  const std::vector<Point> points = some_points(20000, 8);
  Pairs found;
  CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(points, CGAL::within_distance(0.05),
                                                        std::back_inserter(found));
  BOOST_CHECK(sorted(found) == sorted(near_pairs(points, CGAL::within_distance(0.05))));
}
#endif
