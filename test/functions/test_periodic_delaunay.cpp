// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Near pairs of images and the closest pair, against the periodic Delaunay triangulation of CGAL:
// breadth-first search over its edges finds all images within the bound, as in a triangulation
// without periods (support/delaunay_oracle_3.h), and its shortest edge is the closest pair.

#include "support/periodic_oracle.h"
#include "support/point_generators.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <CGAL/periodic_closest_pair.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(periodic_delaunay)

using namespace test_support;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Triangulation = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;
using Offset = Offset_of<3>;
using Neighbor = std::pair<std::size_t, Offset>; // of a point that is not moved
using Pair = Image_pair<3>;

// Points in a cube, and their exact distances.
struct Scene
{
  std::vector<Point> points;
  Kernel::Iso_cuboid_3 domain;
  Lattice_scene<3> exact;
};

Scene scene_of(std::size_t size, double side, bool is_lattice, std::uint64_t seed)
{
  Scene scene;
  scene.domain = Kernel::Iso_cuboid_3(0, 0, 0, side, side, side);
  Random random(seed);
  std::set<std::vector<double>> coordinates;
  while(coordinates.size() < size) {
    std::vector<double> c;
    for(int axis = 0; axis < 3; ++axis) {
      const double x = is_lattice ? static_cast<double>(random.below(8)) / 8 : random.uniform();
      c.push_back((std::min)(x * side, std::nextafter(side, 0.)));
    }
    coordinates.insert(c);
  }
  for(const std::vector<double>& c : coordinates) {
    scene.points.emplace_back(c[0], c[1], c[2]);
    scene.exact.points.push_back(c);
  }
  for(std::size_t k = 0; k < 3; ++k) {
    scene.exact.vectors[k][k] = Rational(side);
    scene.exact.repeats[k] = true;
  }
  return scene;
}

Offset sum(const Offset& a, const Offset& b, int sign = 1)
{
  return {a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]};
}

// The Delaunay neighbors of each point.
std::vector<std::set<Neighbor>> delaunay_neighbors(const Scene& scene)
{
  Triangulation triangulation(scene.domain);
  triangulation.insert(scene.points.begin(), scene.points.end());
  std::map<Point, std::size_t> positions;
  for(std::size_t i = 0; i < scene.points.size(); ++i)
    positions[scene.points[i]] = i;
  std::vector<std::set<Neighbor>> neighbors(scene.points.size());
  for(auto segment = triangulation.periodic_segments_begin(Triangulation::STORED);
      segment != triangulation.periodic_segments_end(Triangulation::STORED); ++segment) {
    const auto& [p, o] = (*segment)[0];
    const auto& [q, r] = (*segment)[1];
    const Offset offset = {r[0] - o[0], r[1] - o[1], r[2] - o[2]};
    const std::size_t i = positions.at(p), j = positions.at(q);
    neighbors[i].emplace(j, offset);
    neighbors[j].emplace(i, sum({}, offset, -1));
  }
  return neighbors;
}

// Returns the pairs (i, j, offset) as the search reports them.
std::vector<Pair> pairs_by_breadth_first_search(const Scene& scene)
{
  const auto neighbors = delaunay_neighbors(scene);
  const Periodic_oracle<3> oracle(scene.exact);
  std::vector<Pair> pairs;
  for(std::size_t i = 0; i < scene.points.size(); ++i) {
    std::vector<Neighbor> within = {{i, {}}};
    std::set<Neighbor> seen = {within.front()};
    // Invariant: the images before number `next` have told their neighbors.
    for(std::size_t next = 0; next < within.size(); ++next) {
      const Neighbor at = within[next];
      for(const auto& [j, step] : neighbors[at.first]) {
        const Neighbor image(j, sum(at.second, step));
        if(oracle.square({i, j, image.second}) <= scene.exact.square && seen.insert(image).second)
          within.push_back(image);
      }
    }
    for(const auto& [j, offset] : within)
      if(i < j || (i == j && offset > Offset{}))
        pairs.emplace_back(i, j, offset);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Pair> found_pairs(const Scene& scene, double r)
{
  std::vector<Pair> found;
  CGAL::periodic_fixed_radius_near_neighbors(scene.points, scene.domain, CGAL::within_distance(r),
                                             std::back_inserter(found));
  std::sort(found.begin(), found.end());
  return found;
}

void check_pairs(Scene scene, double r)
{
  scene.exact.square = Rational(r) * Rational(r);
  const std::vector<Pair> expected = pairs_by_breadth_first_search(scene);
  BOOST_CHECK_GT(expected.size(), scene.points.size());
  BOOST_CHECK(found_pairs(scene, r) == expected);
}

BOOST_AUTO_TEST_CASE(random_points_have_the_pairs_of_the_triangulation)
{
  for(const double side : {1., 0.7})
    for(const double r : {0.15, 0.25})
      check_pairs(scene_of(300, side, false, 1), r * side);
}

// The triangulation is not unique, and the bound is a tie.
BOOST_AUTO_TEST_CASE(lattice_points_have_the_pairs_of_the_triangulation)
{
  for(const double r : {0.125, 0.25})
    check_pairs(scene_of(400, 1, true, 2), r);
}

// The bound is longer than the side: images of a point are near itself.
BOOST_AUTO_TEST_CASE(a_bound_beyond_the_domain_has_the_pairs_of_the_triangulation)
{
  check_pairs(scene_of(30, 0.3, false, 3), 0.35);
}

BOOST_AUTO_TEST_CASE(the_closest_pair_is_the_shortest_edge)
{
  for(std::uint64_t seed = 0; seed < 5; ++seed) {
    const Scene scene = scene_of(40 + 60 * seed, 0.7, seed == 2, seed);
    const Periodic_oracle<3> oracle(scene.exact);
    const auto neighbors = delaunay_neighbors(scene);
    Rational shortest = 1;
    for(std::size_t i = 0; i < neighbors.size(); ++i)
      for(const auto& [j, offset] : neighbors[i])
        shortest = (std::min)(shortest, oracle.square({i, j, offset}));
    BOOST_CHECK_EQUAL(oracle.square(CGAL::periodic_closest_pair(scene.points, scene.domain)),
                      shortest);
  }
}

BOOST_AUTO_TEST_SUITE_END()
