// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of polygons on a small lattice, where most of them touch: rings that touch and cross
// themselves, edges that are passed twice, bridges, antennas, holes that touch rings and holes.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_INTERIOR_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_INTERIOR_SCENES_H

#include "feature_scenes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

inline Lattice_point lattice_point(Random& random, std::int64_t side)
{
  return {below(random, side + 1), below(random, side + 1), 0};
}

inline Chain any_chain(Random& random, std::size_t size, std::int64_t side)
{
  Chain chain(size);
  for(Lattice_point& p : chain)
    p = lattice_point(random, side);
  return chain;
}

// A closed chain of short steps, which often goes back.
inline Chain walk(Random& random, std::size_t size, std::int64_t side)
{
  Chain chain = {lattice_point(random, side)};
  while(chain.size() < size) {
    Lattice_point p = chain.back();
    const std::size_t axis = random.below(2);
    p[axis] = (std::min)((std::max)(p[axis] + below(random, 5) - 2, std::int64_t(0)), side);
    chain.push_back(p);
  }
  return chain;
}

inline void append(Chain& chain, const Chain& more)
{
  chain.insert(chain.end(), more.begin(), more.end());
}

// Loops of three vertices, connected by a chain that is passed to and fro.
inline Chain loops_and_bridges(Random& random, std::int64_t side)
{
  Chain ring = any_chain(random, 3, side);
  Chain bridge = {ring.front()};
  for(std::size_t loops = 1 + random.below(2); loops != 0; --loops) {
    append(bridge, any_chain(random, 1 + random.below(2), side));
    append(ring, bridge);
    if(random.below(4) != 0)
      append(ring, any_chain(random, 2, side));
    ring.push_back(bridge.back());
  }
  append(ring, Chain(bridge.rbegin(), bridge.rend()));
  return ring;
}

// A square with a hole in some of its cells: all of the cell, or half of it, or a corner of it.
inline Lattice_feature sieve(Random& random, std::int64_t side)
{
  const std::int64_t count = 1 + below(random, 3), cell = 2;
  const Lattice_point at = {below(random, side), below(random, side), 0};
  Lattice_feature feature = {Feature_kind::WITH_HOLES, {square(at[0], at[1], count * cell)}};
  for(std::int64_t i = 0; i < count * count; ++i) {
    Chain hole = square(at[0] + cell * (i % count), at[1] + cell * (i / count), cell);
    const std::size_t kind = random.below(6);
    if(kind == 0)
      hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(random.below(4)));
    else if(kind == 1)
      hole[0][0] += 1, hole[0][1] += 1, hole.erase(hole.begin() + 2);
    if(random.below(2) == 0)
      std::reverse(hole.begin(), hole.end());
    if(kind < 4)
      feature.chains.push_back(hole);
  }
  return feature;
}

inline Lattice_feature any_polygon(Random& random, std::int64_t side)
{
  switch(random.below(8)) {
  case 0:
  case 1: return {Feature_kind::POLYGON, {any_chain(random, 3 + random.below(3), side)}};
  case 2: return {Feature_kind::POLYGON, {any_chain(random, random.below(9), side)}};
  case 3: return {Feature_kind::POLYGON, {walk(random, 4 + random.below(9), side)}};
  case 4: return {Feature_kind::POLYGON, {loops_and_bridges(random, side)}};
  case 5:
    return {Feature_kind::POLYGONS,
            {any_chain(random, 3, side), walk(random, 1 + random.below(6), side)}};
  case 6: {
    const std::int64_t size = 1 + below(random, side);
    return {Feature_kind::POLYGON, {square(below(random, side), below(random, side), size)}};
  }
  default: return sieve(random, side);
  }
}

inline Lattice_feature any_feature(Random& random, std::int64_t side)
{
  const std::size_t kind = random.below(4);
  if(kind == 0)
    return {Feature_kind::POINT, {any_chain(random, 1, side)}};
  if(kind == 1)
    return {Feature_kind::POLYLINE, {any_chain(random, random.below(5), side)}};
  return any_polygon(random, side);
}

inline Lattice_features any_polygons(std::uint64_t seed, std::size_t size, std::int64_t side)
{
  Random random(seed);
  Lattice_features features;
  for(std::size_t i = 0; i < size; ++i)
    features.push_back(any_polygon(random, side));
  return features;
}

inline Lattice_features any_features(std::uint64_t seed, std::size_t size, std::int64_t side)
{
  Random random(seed);
  Lattice_features features;
  for(std::size_t i = 0; i < size; ++i)
    features.push_back(any_feature(random, side));
  return features;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_INTERIOR_SCENES_H
