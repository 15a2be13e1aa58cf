// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which interiors of polygons overlap, and which closed features are inside of polygons.

#include "support/check_interiors.h"
#include "support/seeds.h"

#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <utility>
#include <vector>

using namespace test_support;

using Point = Epick::Point_2;
using Polyline = std::vector<Point>;
using Polygon = CGAL::Polygon_2<Epick>;
using With_holes = CGAL::Polygon_with_holes_2<Epick>;

namespace {

Polygon polygon(const Chain& chain)
{
  const Polyline points = Features_2<Epick>::points(chain, Scale::ONE);
  return Polygon(points.begin(), points.end());
}

template <class Features>
Pairs overlaps(const Features& features)
{
  return sorted(reported([&](auto collect) {
    CGAL::thick_feature_self_intersection_d(CGAL::interiors(features), collect);
  }));
}

template <class Features, class Others>
Pairs insides(const Features& features, const Others& others)
{
  return sorted(reported([&](auto collect) {
    CGAL::thick_feature_intersection_d(CGAL::interiors(features), others, collect);
  }));
}

// Tiles of a floor, whose corners may be moved: neighbors have edges in common.
std::vector<Polygon> tiles(std::int64_t count, std::int64_t most)
{
  Random random(7);
  std::vector<Chain> rows;
  for(std::int64_t y = 0; y <= count; ++y) {
    rows.emplace_back();
    for(std::int64_t x = 0; x <= count; ++x)
      rows.back().push_back({10 * x + below(random, most), 10 * y + below(random, most), 0});
  }
  std::vector<Polygon> tiles;
  for(std::size_t y = 0; y + 1 < rows.size(); ++y)
    for(std::size_t x = 0; x + 1 < rows.size(); ++x)
      tiles.push_back(polygon({rows[y][x], rows[y][x + 1], rows[y + 1][x + 1], rows[y + 1][x]}));
  return tiles;
}

} // namespace

BOOST_AUTO_TEST_CASE(interiors_on_small_lattices)
{
  check_interior_scenes<Epick>(100, 150, 8, {Scale::ONE});
  check_interior_scenes<Epick>(900, 6, 60, {Scale::ONE});
}

BOOST_AUTO_TEST_CASE(random_interiors)
{
  check_seeds(60, [](std::uint64_t seed) {
    const Interior_scene scene = interior_scene(seed, 20, 2 + static_cast<std::int64_t>(seed % 9));
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_interiors<CGAL::Sequential_tag, Epick>(scene, Scale::ONE);
      check_interiors<CGAL::Parallel_tag, Epick>(scene, Scale::HUGE_POWER);
    }
  });
}

BOOST_AUTO_TEST_CASE(polygons_that_share_borders_do_not_overlap)
{
  for(const std::int64_t most : {1, 4}) {
    std::vector<Polygon> all = tiles(30, most);
    BOOST_CHECK(overlaps(all).empty());
    const std::size_t size = all.size();
    all.push_back(all[17]);
    BOOST_CHECK(overlaps(all) == Pairs({{17, size}}));
  }
}

BOOST_AUTO_TEST_CASE(equal_and_nested_polygons_overlap)
{
  const std::vector<Polygon> polygons
    = {polygon(square(0, 0, 9)), polygon(square(0, 0, 9)), polygon(square(3, 3, 1)),
       polygon(square(8, 8, 1)), polygon(square(9, 9, 1))};
  BOOST_CHECK(overlaps(polygons) == Pairs({{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}}));
}

BOOST_AUTO_TEST_CASE(what_fills_a_hole_does_not_overlap)
{
  With_holes frame(polygon(square(0, 0, 9)));
  frame.add_hole(polygon(square(3, 3, 3)));
  const std::vector<With_holes> polygons
    = {frame, With_holes(polygon(square(3, 3, 3))), With_holes(polygon(square(4, 4, 1))),
       With_holes(polygon(square(3, 3, 4)))};
  BOOST_CHECK(overlaps(polygons) == Pairs({{0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

BOOST_AUTO_TEST_CASE(a_union_has_the_interiors_of_its_members)
{
  const std::vector<std::vector<Polygon>> unions
    = {{polygon(square(0, 0, 2)), polygon(square(2, 0, 2))}, {polygon(square(4, 0, 2))},
       {polygon(square(9, 9, 1)), polygon(square(3, 1, 1))}};
  BOOST_CHECK(overlaps(unions) == Pairs({{0, 2}}));
  // The edge between two members is in the interior of none.
  BOOST_CHECK(insides(unions, Polyline{Point(1, 1), Point(2, 1)}) == Pairs({{0, 0}}));
}

BOOST_AUTO_TEST_CASE(closed_features_are_inside_if_a_point_of_them_is)
{
  const std::list<Polygon> polygons = {polygon(square(0, 0, 4))};
  const std::vector<Polyline> lines
    = {{Point(0, 0), Point(4, 0)}, {Point(0, 0), Point(4, 4)},  {Point(4, 4), Point(9, 9)},
       {Point(1, 1)},              {Point(4, 1)},               {Point(5, 5), Point(5, 9)},
       {Point(0, 0), Point(0, 4), Point(-1, 2), Point(1, 2)}};
  BOOST_CHECK(insides(polygons, lines) == Pairs({{0, 1}, {0, 3}, {0, 6}}));
  const std::vector<Polygon> closed = {polygon(square(-1, -1, 9)), polygon(square(4, 0, 4)),
                                       polygon({{2, 2, 0}}), polygon({{1, 4, 0}, {3, 4, 0}})};
  BOOST_CHECK(insides(polygons, closed) == Pairs({{0, 0}, {0, 2}}));
}

BOOST_AUTO_TEST_CASE(degenerate_polygons_have_no_interior)
{
  const std::vector<Polygon> polygons
    = {polygon(square(0, 0, 9)), polygon({{3, 3, 0}}), polygon({{1, 1, 0}, {5, 5, 0}}),
       polygon({{1, 1, 0}, {3, 3, 0}, {5, 5, 0}}), Polygon()};
  BOOST_CHECK(overlaps(polygons).empty());
}

BOOST_AUTO_TEST_CASE(ranges_with_maps_are_marked_too)
{
  const std::vector<Polygon> polygons = {polygon(square(0, 0, 4)), polygon(square(2, 2, 4))};
  const std::vector<std::size_t> positions = {1, 0, 0};
  Pairs pairs;
  CGAL::thick_feature_self_intersection_d(
    CGAL::interiors(positions), Pair_collector{pairs},
    CGAL::parameters::point_map(CGAL::make_property_map(polygons)));
  BOOST_CHECK(sorted(pairs) == Pairs({{0, 1}, {0, 2}, {1, 2}}));
}
