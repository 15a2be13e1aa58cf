// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangle meshes as features: which types are meshes, what the functions for features promise of
// them, and what is wrong with some.

#include "support/check_solids.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <limits>
#include <list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace test_support;

namespace {

using Point = Epick::Point_3;
using Polyline = std::vector<Point>;
using Surface = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Epick>;
using Any_soup = std::pair<std::vector<Point>, std::vector<std::vector<std::int16_t>>>;

template <class Mesh>
struct With_id : Mesh
{
  int id = 0;
};

Surface surface(const Lattice_mesh& mesh)
{
  return *mesh_of<Epick>(soup_of<Epick>(mesh, {}, true));
}

// Cubes, of which the second is inside the first, and the third is not.
template <class Mesh, class Base = Mesh>
std::vector<Mesh> three_cubes()
{
  std::vector<Mesh> cubes(3);
  CGAL::copy_face_graph(surface(cube_mesh(0, 9)), static_cast<Base&>(cubes[0]));
  CGAL::copy_face_graph(surface(cube_mesh(1, 2)), static_cast<Base&>(cubes[1]));
  CGAL::copy_face_graph(surface(cube_mesh(20, 29)), static_cast<Base&>(cubes[2]));
  return cubes;
}

template <class Features>
Pairs pairs_of(const Features& features)
{
  return sorted(reported([&](auto collect) {
    CGAL::thick_feature_self_intersection_d(features, collect);
  }));
}

} // namespace

BOOST_AUTO_TEST_CASE(meshes_of_many_types)
{
  const Pairs first_pair = {{0, 1}};
  BOOST_CHECK(pairs_of(three_cubes<Surface>()) == first_pair);
  BOOST_CHECK(pairs_of(three_cubes<Polyhedron>()) == first_pair);
  BOOST_CHECK((pairs_of(three_cubes<With_id<Surface>, Surface>()) == first_pair));
  BOOST_CHECK((pairs_of(three_cubes<With_id<Polyhedron>, Polyhedron>()) == first_pair));

  const auto [points, triples] = soup_of<Epick>(cube_mesh(0, 9), {}, true);
  using List_soup = std::pair<std::list<Point>, std::deque<std::list<int>>>;
  With_id<List_soup> soup;
  soup.first.assign(points.begin(), points.end());
  for(const auto& triple : triples)
    soup.second.emplace_back(triple.begin(), triple.end());
  const std::vector<std::variant<With_id<List_soup>, Point, Polyhedron>> features
    = {soup, Point(1, 1, 1), Point(9, 9, 10), three_cubes<Polyhedron>()[1]};
  BOOST_CHECK(pairs_of(features) == Pairs({{0, 1}, {0, 3}, {1, 3}}));
}

BOOST_AUTO_TEST_CASE(removed_faces_are_no_longer_there)
{
  std::vector<Surface> cubes = three_cubes<Surface>();
  CGAL::Euler::remove_face(halfedge(*faces(cubes[0]).begin(), cubes[0]), cubes[0]);
  BOOST_CHECK(pairs_of(cubes).empty());
}

BOOST_AUTO_TEST_CASE(two_ranges_hold_meshes_and_polylines)
{
  const std::vector<Polyline> lines = {{Point(1, 1, 1), Point(2, 3, 4)}, {Point(30, 1, 1)}};
  Pairs pairs;
  CGAL::thick_feature_intersection_d(lines, three_cubes<Surface>(), std::back_inserter(pairs));
  BOOST_CHECK(sorted(pairs) == Pairs({{0, 0}, {0, 1}}));
  std::vector<std::pair<Surface, Polyline>> elements;
  CGAL::thick_feature_intersection_d<CGAL::Parallel_tag>(
    three_cubes<Surface>(), lines, CGAL::with_elements(std::back_inserter(elements)));
  BOOST_REQUIRE_EQUAL(elements.size(), 2u);
  for(const auto& [mesh, line] : elements)
    BOOST_CHECK(line == lines[0]);
}

BOOST_AUTO_TEST_CASE(hollows_are_not_inside)
{
  const Surface shell = surface(joined(cube_mesh(0, 20), cube_mesh(2, 18)));
  const std::vector<std::variant<Surface, Point>> features
    = {shell, surface(cube_mesh(5, 9)), Point(1, 10, 10), Point(6, 6, 6), Point(2, 2, 2)};
  BOOST_CHECK(pairs_of(features) == Pairs({{0, 2}, {0, 4}, {1, 3}}));
}

BOOST_AUTO_TEST_CASE(callback_and_progress_stop_the_search)
{
  std::vector<Surface> nested;
  for(std::int64_t i = 0; i < 20; ++i)
    nested.push_back(surface(cube_mesh(i, 100 - i)));
  std::size_t count = 0;
  BOOST_CHECK(!CGAL::thick_feature_self_intersection_d(
    nested, [&](std::size_t, std::size_t) { return ++count < 7; }));
  BOOST_CHECK_EQUAL(count, 7u);
  double last = 0;
  BOOST_CHECK(CGAL::thick_feature_self_intersection_d(
    nested, [&](std::size_t, std::size_t) {}, CGAL::parameters::callback([&](double done) {
      last = done;
      return true;
    })));
  BOOST_CHECK_EQUAL(last, 1);
  BOOST_CHECK(!CGAL::thick_feature_self_intersection_d(
    nested, [](std::size_t, std::size_t) {},
    CGAL::parameters::callback([](double) { return false; })));
}

BOOST_AUTO_TEST_CASE(meshes_without_faces_are_in_no_pair)
{
  Surface vertices;
  vertices.add_vertex(Point(1, 1, 1));
  const std::vector<Surface> meshes = {vertices, surface(cube_mesh(0, 9)), Surface()};
  BOOST_CHECK(pairs_of(meshes).empty());
}

BOOST_AUTO_TEST_CASE(errors_name_the_feature_and_the_face)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point> points
    = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, nan, 0)};
  const auto message = [&](const std::vector<std::vector<std::int16_t>>& triples) {
    const std::vector<Any_soup> soups = {{points, {{0, 1, 2}}}, {points, triples}};
    return refusal([&] { pairs_of(soups); });
  };
  BOOST_CHECK_EQUAL(message({{0, 1, 2}, {2, 1, 0}}), "");
  BOOST_CHECK_EQUAL(message({{0, 1, 2}, {2, 1, 3}}),
                    "Coordinate 1 of vertex of face 1 of feature 1 is NaN or infinite.");
  BOOST_CHECK_EQUAL(message({{0, 1}}), "Face 0 of feature 1 is no triangle.");
  BOOST_CHECK_EQUAL(message({{0, 1, 2}, {0, 1, 2, 0}}), "Face 1 of feature 1 is no triangle.");
  BOOST_CHECK_EQUAL(message({{0, 1, 2}, {0, 1, 2}, {0, 4, 1}}),
                    "Face 2 of feature 1 has an index beyond the points.");
  BOOST_CHECK_EQUAL(message({{0, 1, -1}}), "Face 0 of feature 1 has an index beyond the points.");
  const std::vector<Any_soup> alone = {{points, {{0, 1, 2}, {2, 1, 3}}}};
  BOOST_CHECK_EQUAL(refusal([&] { pairs_of(alone); }),
                    "Coordinate 1 of vertex of face 1 of feature 0 is NaN or infinite.");

  std::vector<Surface> meshes = three_cubes<Surface>();
  meshes[2].point(*vertices(meshes[2]).begin()) = points[3];
  const std::string other = refusal([&] { pairs_of(meshes); });
  BOOST_CHECK(contains(other, "Coordinate 1 of vertex of face ")
              && contains(other, " of feature 2 is NaN or infinite."));
  CGAL::Euler::join_face(*std::prev(halfedges(meshes[1]).end()), meshes[1]);
  std::size_t face = 0;
  for(const auto f : faces(meshes[1])) {
    if(meshes[1].degree(f) != 3)
      break;
    ++face;
  }
  BOOST_CHECK_GT(face, 0u);
  BOOST_CHECK_EQUAL(refusal([&] { pairs_of(meshes); }),
                    "Face " + std::to_string(face) + " of feature 1 is no triangle.");

  const std::vector<std::variant<Polyline, Surface>> mixed
    = {surface(cube_mesh(0, 9)), Polyline{Point(99, 0, 0), Point(99, nan, 0)}};
  BOOST_CHECK_EQUAL(refusal([&] { pairs_of(mixed); }),
                    "Coordinate 1 of vertex of feature 1 is NaN or infinite.");
}
