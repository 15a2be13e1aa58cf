// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether points are inside rings of many vertices: by trees, and by the parity of a steep ray.

#include "support/feature_oracle.h"
#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/Thick_intersection_d/internal/features/Ring_trees.h>

BOOST_AUTO_TEST_SUITE(Ring_trees)

using namespace test_support;
using internal::Place;

// Coordinates are integers times a unit, from an origin.
template <class Kernel>
struct Rings
{
  using Segment = typename Kernel::Segment_2;

  typename Kernel::Point_2 point(const Lattice_point& p) const
  {
    return {origin + unit * static_cast<double>(p[0]), origin + unit * static_cast<double>(p[1])};
  }

  void add_ring(const Chain& ring)
  {
    trees.begin_ring(static_cast<Place>(segments.size()));
    for(std::size_t i = 0; i < ring.size(); ++i)
      segments.emplace_back(point(ring[i]), point(ring[(i + 1) % ring.size()]));
  }

  // Makes a tree of the rings that were added since the last one.
  void end_polygon()
  {
    tree = trees.add_tree(tree.last, static_cast<Place>(segments.size()));
  }

  bool is_inside(const Lattice_point& p) const
  {
    const Segment ray(point(p), point({p[0] + 1, p[1] + 2, 0})); // begins there
    return trees.is_inside(ray, tree);
  }

  typename Kernel::FT unit = 1, origin = 0;
  std::vector<Segment> segments;
  internal::Ring_trees<Segment> trees{segments};
  internal::Halved_range tree = {0, 0, 0}; // of the last polygon
};

// Any closed chain: it may cross itself, and has many vertices at equal heights.
Chain any_ring(Random& random, std::size_t size, std::size_t side)
{
  Chain ring;
  for(std::size_t i = 0; i < size; ++i)
    ring.push_back({static_cast<std::int64_t>(random.below(side)),
                    static_cast<std::int64_t>(random.below(side)), 0});
  return ring;
}

// A closed chain of short edges, whose tree has small boxes.
Chain wandering_ring(Random& random, std::size_t size)
{
  Chain ring = {{100, 100, 0}};
  while(ring.size() < size) {
    Lattice_point p = ring.back();
    for(std::size_t axis = 0; axis < 2; ++axis)
      p[axis] += static_cast<std::int64_t>(random.below(7)) - 3;
    ring.push_back(p);
  }
  return ring;
}

bool is_on_ring(const Lattice_point& p, const Chain& ring)
{
  for(std::size_t i = 0; i < ring.size(); ++i)
    if(do_segments_meet({p, p}, {ring[i], ring[(i + 1) % ring.size()]}))
      return true;
  return false;
}

template <class Kernel>
void check_rings(const std::vector<Chain>& polygon, const typename Kernel::FT& unit,
                 std::size_t step, const typename Kernel::FT& origin = 0)
{
  Rings<Kernel> rings;
  rings.unit = unit;
  rings.origin = origin;
  rings.add_ring({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}});
  rings.end_polygon();
  for(const Chain& ring : polygon)
    rings.add_ring(ring);
  rings.end_polygon();
  std::size_t wrong = 0, inside = 0;
  Lattice_point low = polygon[0][0], high = low;
  for(const Chain& ring : polygon)
    for(const Lattice_point& p : ring)
      for(std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = (std::min)(low[axis], p[axis]);
        high[axis] = (std::max)(high[axis], p[axis]);
      }
  const auto stride = static_cast<std::int64_t>(step);
  for(std::int64_t x = low[0] - 1; x <= high[0] + 1; x += stride)
    for(std::int64_t y = low[1] - 1; y <= high[1] + 1; y += stride) {
      const Lattice_point p = {x, y, 0};
      if(std::any_of(polygon.begin(), polygon.end(),
                     [&](const Chain& ring) { return is_on_ring(p, ring); }))
        continue;
      const auto count = std::count_if(polygon.begin(), polygon.end(), [&](const Chain& ring) {
        return is_inside_ring(p, ring);
      });
      wrong += rings.is_inside(p) != (count % 2 != 0);
      inside += count % 2 != 0;
    }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(inside, 0u);
}

BOOST_AUTO_TEST_CASE(rings_of_any_size)
{
  Random random(1);
  for(const std::size_t size : {3, 4, 9, 16, 17, 33, 64, 100, 300})
    check_rings<Double_kernel>({any_ring(random, size, 30)}, 1, 1);
  for(const std::size_t size : {50, 200, 1000})
    check_rings<Double_kernel>({wandering_ring(random, size)}, 1, 2);
}

BOOST_AUTO_TEST_CASE(several_rings)
{
  Random random(2);
  for(const std::size_t size : {3, 7, 20, 40, 90}) {
    std::vector<Chain> rings;
    for(int k = 0; k < 5; ++k)
      rings.push_back(k % 2 == 0 ? any_ring(random, size, 40) : wandering_ring(random, size));
    check_rings<Double_kernel>(rings, 1, 2);
  }
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_no_doubles)
{
  Random random(3);
  check_rings<Epeck>({any_ring(random, 30, 12)}, Epeck::FT(1) / 3, 1);
  check_rings<Epeck>({wandering_ring(random, 80)}, Epeck::FT(1) / 3, 1);
}

// The bounds of all coordinates overlap: exact numbers decide which vertices are above a ray.
BOOST_AUTO_TEST_CASE(coordinates_without_a_double_between_them)
{
  Random random(5);
  check_rings<Epeck>({any_ring(random, 20, 10)}, std::ldexp(1., -80), 1, 1);
}

BOOST_AUTO_TEST_CASE(box_of_a_polygon)
{
  Random random(4);
  Rings<Double_kernel> rings;
  rings.add_ring({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}});
  rings.end_polygon();
  rings.add_ring(wandering_ring(random, 200));
  rings.end_polygon();
  CGAL::Bbox_2 box;
  for(Place segment = rings.tree.first; segment != rings.tree.last; ++segment)
    box += rings.segments[segment].bbox();
  BOOST_CHECK(rings.trees.box(rings.tree) == box);
}

BOOST_AUTO_TEST_SUITE_END()
