// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether interiors overlap, on doubles: polygons on small lattices against points between all of
// their edges, and what is rare there.

#include "support/interior_oracle.h"
#include "support/interior_scenes.h"
#include "support/unit_test.h"

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/interiors.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <variant>

BOOST_AUTO_TEST_SUITE(Interiors_overlap)

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Polyline = std::vector<Point>;
using Polygon = CGAL::Polygon_2<Kernel>;
using With_holes = CGAL::Polygon_with_holes_2<Kernel>;
using Polygons = std::vector<With_holes>;
using Feature = std::variant<Polyline, Polygons>;

Polyline points_of(const Chain& chain)
{
  Polyline points;
  for(const Lattice_point& p : chain)
    points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]));
  return points;
}

Polygon polygon(const Chain& chain)
{
  const Polyline points = points_of(chain);
  return Polygon(points.begin(), points.end());
}

Polygons polygons(const Lattice_feature& feature)
{
  Polygons polygons;
  for(const Chain& chain : feature.chains)
    if(feature.kind == Feature_kind::WITH_HOLES && !polygons.empty())
      polygons[0].add_hole(polygon(chain));
    else if(!chain.empty())
      polygons.emplace_back(polygon(chain));
  return polygons;
}

template <class Function>
auto converted(const Lattice_features& features, const Function& function)
{
  std::vector<decltype(function(features[0]))> result;
  std::transform(features.begin(), features.end(), std::back_inserter(result), function);
  return result;
}

template <class... Ranges>
Pairs pairs_between(Ranges&&... ranges)
{
  return sorted(reported([&](const Pair_collector& collector) {
    CGAL::thick_feature_intersection_d(ranges..., collector);
  }));
}

Pairs overlaps(const std::vector<Polygons>& features)
{
  return sorted(reported([&](const Pair_collector& collector) {
    CGAL::thick_feature_self_intersection_d(CGAL::interiors(features), collector);
  }));
}

bool do_overlap(const Chain& a, const Chain& b)
{
  const auto as_feature = [](const Chain& chain) {
    return polygons({Feature_kind::POLYGON, {chain}});
  };
  return !overlaps({as_feature(a), as_feature(b)}).empty();
}

BOOST_AUTO_TEST_CASE(small_lattices)
{
  std::size_t wrong = 0, pairs = 0;
  for(std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::int64_t side = 2 + static_cast<std::int64_t>(seed % 6);
    const Lattice_features a = any_polygons(seed, 9, side), b = any_features(seed + 500, 9, side);
    const Pairs open = pairs_of_interiors(a), mixed = pairs_of_interiors(a, true, b, false);
    const std::vector<Polygons> polygons_a = converted(a, polygons);
    const std::vector<Feature> features_b = converted(b, [](const Lattice_feature& feature) {
      return feature.is_filled() ? Feature(polygons(feature))
                                 : Feature(points_of(feature.chains[0]));
    });
    Pairs swapped;
    for(const Pair& pair : pairs_between(features_b, CGAL::interiors(polygons_a)))
      swapped.emplace_back(pair.second, pair.first);
    wrong += overlaps(polygons_a) != open;
    wrong += pairs_between(CGAL::interiors(polygons_a), features_b) != mixed;
    wrong += sorted(swapped) != mixed;
    pairs += open.size() + mixed.size();
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(pairs, 500u);
}

// Both polygons cross themselves where they cross each other, off the lattice. An arm of one is
// between arms of the other one, or on them.
BOOST_AUTO_TEST_CASE(all_edges_cross_at_one_point)
{
  // Two triangles each, between two lines through a common point.
  const auto bow = [](const Lattice_point& p, const Lattice_point& q) {
    return Chain{p, {7 - p[0], 5 - p[1], 0}, {7 - q[0], 5 - q[1], 0}, q};
  };
  const std::vector<Lattice_point> ends
    = {{9, 3, 0}, {9, 6, 0}, {7, 8, 0}, {3, 8, 0}, {-1, 6, 0}, {-3, 4, 0}};
  for(std::size_t i = 0; i < ends.size(); ++i)
    for(std::size_t j = i + 1; j < ends.size(); ++j)
      for(std::size_t k = 0; k < ends.size(); ++k)
        for(std::size_t l = k + 1; l < ends.size(); ++l) {
          const bool expected = l > i && j > k;
          BOOST_CHECK_EQUAL(do_overlap(bow(ends[i], ends[j]), bow(ends[k], ends[l])), expected);
        }
}

// The place where a bridge goes from one part of a polygon to another one is far from them.
BOOST_AUTO_TEST_CASE(bridges_and_antennas)
{
  const Chain large = square(0, 0, 20);
  const Chain triangle = {{8, 8, 0}, {12, 8, 0}, {10, 12, 0}};
  for(std::size_t turn = 0; turn < 3; ++turn) {
    Chain ring = {{30, 10, 0}, {40, 10, 0}, {40, 15, 0}, {30, 10, 0}, {25, 11, 0}};
    append(ring, {triangle[turn], triangle[(turn + 1) % 3], triangle[(turn + 2) % 3],
                  triangle[turn], {25, 11, 0}});
    BOOST_CHECK(do_overlap(ring, large));
    BOOST_CHECK(do_overlap(large, ring));
  }
  BOOST_CHECK(!do_overlap({{30, 10, 0}, {40, 10, 0}, {40, 15, 0}, {30, 10, 0}, {10, 10, 0}},
                          large));
}

// An edge goes through both points where the ring touches it, and so does one of the other polygon,
// on the same line. They overlap in a triangle between these points.
BOOST_AUTO_TEST_CASE(a_ring_touches_an_edge_on_a_common_line)
{
  const Chain ring = {{0, 0, 0},  {10, 0, 0}, {10, -1, 0}, {6, -1, 0}, {6, 0, 0},
                      {4, 3, 0}, {3, 0, 0},  {3, -1, 0},  {0, -1, 0}};
  BOOST_CHECK(do_overlap(ring, {{-5, 0, 0}, {15, 0, 0}, {15, 9, 0}, {-5, 9, 0}}));
  BOOST_CHECK(!do_overlap(ring, {{3, 0, 0}, {6, 0, 0}, {4, -1, 0}}));
}

// Only edges of the triangle cross that line, and the common point is on an edge before them.
BOOST_AUTO_TEST_CASE(a_ring_runs_along_an_edge_and_crosses_it)
{
  const Chain ring = {{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {4, 5, 0}, {4, 3, 0},
                      {5, -2, 0}, {6, 3, 0}, {4, 3, 0},  {4, 5, 0}, {0, 5, 0}};
  const Chain below = {{-5, 0, 0}, {-5, -9, 0}, {15, -9, 0}, {15, 0, 0}};
  BOOST_CHECK(do_overlap(ring, below));
  BOOST_CHECK(do_overlap(below, ring));
}

// Edges of no length end where others begin, and tell of no arm.
BOOST_AUTO_TEST_CASE(all_vertices_are_repeated)
{
  const Chain ring = {{3, 4, 0}, {3, 4, 0}, {3, 2, 0}, {3, 2, 0}, {1, 2, 0},
                      {1, 2, 0}, {1, 4, 0}, {1, 4, 0}, {1, 4, 0}};
  const Chain triangle = {{1, 4, 0}, {1, 4, 0}, {1, 2, 0}, {1, 2, 0}, {3, 4, 0}, {3, 4, 0}};
  BOOST_CHECK(do_overlap(ring, triangle));
  BOOST_CHECK(do_overlap(triangle, ring));
}

// The first vertex is on an antenna in the other polygon.
BOOST_AUTO_TEST_CASE(antennas_inside)
{
  const Chain ring = {{5, 5, 0}, {8, 8, 0}, {12, 8, 0}, {10, 12, 0}, {8, 8, 0}};
  BOOST_CHECK(do_overlap(ring, square(0, 0, 20)));
  BOOST_CHECK(!do_overlap({{5, 5, 0}, {8, 8, 0}, {12, 8, 0}, {8, 8, 0}}, square(0, 0, 20)));
}

BOOST_AUTO_TEST_SUITE_END()
