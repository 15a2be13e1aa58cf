// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of polylines and polygons on a lattice, where most features touch others, and some are
// degenerate or cross themselves.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_FEATURE_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_FEATURE_SCENES_H

#include "feature_oracle.h"
#include "point_generators.h"

namespace test_support {

struct Feature_scene
{
  std::string name;
  Lattice_features features;
};

inline std::int64_t below(Random& random, std::int64_t size)
{
  return static_cast<std::int64_t>(random.below(static_cast<std::size_t>(size)));
}

inline Chain random_chain(Random& random, int dimension, std::size_t size, std::int64_t side,
                          std::int64_t extent)
{
  const Lattice_point corner = {below(random, side), below(random, side), below(random, side)};
  Chain chain(size);
  for(Lattice_point& p : chain)
    for(std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
      p[axis] = corner[axis] + below(random, extent + 1);
  return chain;
}

inline Chain square(std::int64_t x, std::int64_t y, std::int64_t side)
{
  return {{x, y, 0}, {x + side, y, 0}, {x + side, y + side, 0}, {x, y + side, 0}};
}

// Polylines, polygons that may cross themselves, and points. Some have no vertices.
inline Feature_scene random_scene(const std::string& name, int dimension, std::size_t size,
                                  std::int64_t side, std::int64_t extent)
{
  Feature_scene scene = {name, {}};
  Random random(size);
  for(std::size_t i = 0; i < size; ++i) {
    const auto chain
      = [&](std::size_t count) { return random_chain(random, dimension, count, side, extent); };
    const std::size_t kind = dimension == 2 ? random.below(8) : random.below(3);
    if(kind == 0)
      scene.features.push_back({Feature_kind::POINT, {chain(1)}});
    else if(kind < 3)
      scene.features.push_back({Feature_kind::POLYLINE, {chain(random.below(6))}});
    else if(kind < 6)
      scene.features.push_back({Feature_kind::POLYGON, {chain(random.below(8))}});
    else
      scene.features.push_back({Feature_kind::POLYGONS,
                                {chain(1 + random.below(6)), chain(1 + random.below(6))}});
  }
  return scene;
}

// Cells of a lattice that have edges in common, in both orientations, and polylines along edges.
inline Feature_scene cell_scene()
{
  Feature_scene scene = {"cells", {}};
  Random random(1);
  for(int i = 0; i < 200; ++i) {
    const std::int64_t x = 4 * below(random, 12), y = 4 * below(random, 12);
    Chain cell = square(x, y, random.below(5) == 0 ? 12 : 4);
    if(random.below(2) == 0)
      std::reverse(cell.begin(), cell.end());
    if(random.below(2) == 0)
      cell.resize(1 + random.below(4));
    scene.features.push_back(
      {random.below(3) == 0 ? Feature_kind::POLYLINE : Feature_kind::POLYGON, {cell}});
  }
  return scene;
}

// Frames, each in the hole of the one before it, and features between, in and on them.
inline Feature_scene frame_scene()
{
  Feature_scene scene = {"frames", {}};
  Random random(2);
  for(std::int64_t i = 0; i < 12; ++i) {
    const Chain hole = square(7 * i + 3, 7 * i + 3, 200 - 14 * i - 6);
    const Chain outer = square(7 * i, 7 * i, 200 - 14 * i);
    if(i % 3 == 2) // the hole touches the outer boundary
      scene.features.push_back({Feature_kind::WITH_HOLES, {outer, {hole[0], hole[1], outer[2]}}});
    else
      scene.features.push_back({Feature_kind::WITH_HOLES, {outer, hole}});
  }
  for(int i = 0; i < 150; ++i) {
    const auto kind = random.below(3) == 0   ? Feature_kind::POINT
                      : random.below(2) == 0 ? Feature_kind::POLYLINE
                                             : Feature_kind::POLYGON;
    const std::size_t size = kind == Feature_kind::POINT ? 1 : 3;
    scene.features.push_back({kind, {random_chain(random, 2, size, 200, 3)}});
  }
  for(std::int64_t i = 0; i < 40; ++i)
    scene.features.push_back({Feature_kind::POLYGON, {square(i, i, 200 - 2 * i)}});
  return scene;
}

// A square with many holes, some of which touch each other, and small features in and between them.
inline Feature_scene sieve_scene()
{
  Feature_scene scene = {"sieve", {}};
  Random random(3);
  Lattice_feature sieve = {Feature_kind::WITH_HOLES, {square(0, 0, 200)}};
  for(std::int64_t x = 0; x < 16; ++x)
    for(std::int64_t y = 0; y < 16; ++y) {
      const Chain hole = square(2 + 12 * x, 2 + 12 * y, random.below(4) == 0 ? 12 : 6);
      sieve.chains.push_back({hole[0], hole[1], hole[2]});
    }
  scene.features.push_back(sieve);
  for(int i = 0; i < 250; ++i)
    scene.features.push_back({Feature_kind::POLYLINE,
                              {random_chain(random, 2, 1 + random.below(2), 204, 2)}});
  return scene;
}

// A comb, a spiral, and stars, with small features in and between their arms.
inline Feature_scene large_ring_scene()
{
  Feature_scene scene = {"large rings", {}};
  Chain comb = {{0, 0, 0}}, spiral, back;
  for(std::int64_t i = 0; i < 60; ++i) {
    comb.insert(comb.begin(), {4 * i, 300, 0});
    comb.insert(comb.begin(), {4 * i + 2, 10 + i, 0});
    const std::int64_t r = 300 - 4 * i;
    const std::int64_t d = r - 2, s = i % 4;
    spiral.push_back({s == 0 || s == 3 ? -r : r, s < 2 ? -r : r, 0});
    back.insert(back.begin(), {s == 0 || s == 3 ? -d : d, s < 2 ? -d : d, 0});
  }
  comb.push_back({0, 300, 0});
  spiral.insert(spiral.end(), back.begin(), back.end());
  for(Lattice_point& p : spiral)
    for(std::size_t axis = 0; axis < 2; ++axis)
      p[axis] += 300;
  scene.features.push_back({Feature_kind::POLYGON, {comb}});
  scene.features.push_back({Feature_kind::POLYGON, {spiral}});
  Random random(4);
  for(int star = 0; star < 3; ++star)
    scene.features.push_back(
      {Feature_kind::POLYGON, {random_chain(random, 2, 70, 200, 300)}}); // crosses itself
  for(int i = 0; i < 250; ++i)
    scene.features.push_back({Feature_kind::POLYLINE,
                              {random_chain(random, 2, 1 + random.below(2), 600, 1)}});
  return scene;
}

inline std::vector<Feature_scene> feature_scenes(int dimension)
{
  std::vector<Feature_scene> scenes
    = {random_scene("random", dimension, 250, dimension == 2 ? 60 : 14, 9),
       random_scene("tiny", dimension, 80, 3, 2), random_scene("few", dimension, 6, 2, 6)};
  if(dimension == 2)
    for(const Feature_scene& scene :
        {cell_scene(), frame_scene(), sieve_scene(), large_ring_scene()})
      scenes.push_back(scene);
  return scenes;
}

// A few features of many segments each, most of whose boxes meet: tracks that stay at a place, with
// many equal points, zigzags whose segments all cross, and polygons one in another.
inline std::vector<Feature_scene> crowded_feature_scenes()
{
  Random random(5);
  Feature_scene tracks = {"tracks", {}}, zigzags = {"zigzags", {}}, bands = {"bands", {}};
  for(std::int64_t i = 0; i < 9; ++i) {
    const Lattice_point at = {3 * below(random, 4), 3 * below(random, 4), 0};
    Chain track(300, at), zigzag;
    for(std::size_t k = 0; k < track.size(); k += 1 + random.below(9))
      track[k] = {at[0] + below(random, 4), at[1] + below(random, 4), 0};
    tracks.features.push_back({Feature_kind::POLYLINE, {track}});
    const std::int64_t x = i < 6 ? 0 : 2000, step = i < 3 ? 0 : 500 * (i % 2);
    for(std::int64_t k = 0; k < 300; ++k)
      zigzag.push_back(k % 2 ? Lattice_point{x + k, 400 + k + step, 0}
                             : Lattice_point{x + 400 + k + step, k, 0});
    zigzags.features.push_back({Feature_kind::POLYLINE, {zigzag}});
    Lattice_feature polygons = {Feature_kind::POLYGONS, {}};
    for(std::int64_t k = 0; k < 80; ++k) {
      const std::int64_t d = 9 * k + (i < 2 ? 0 : i) + (i % 3 == 2 ? 2000 : 0);
      polygons.chains.push_back(square(d, d, i < 6 ? 1800 - 18 * k : 1));
    }
    bands.features.push_back(polygons);
  }
  for(Feature_scene* scene : {&tracks, &zigzags, &bands})
    for(int i = 0; i < 20; ++i)
      scene->features.push_back({Feature_kind::POINT, {random_chain(random, 2, 1, 12, 900)}});
  return {tracks, zigzags, bands};
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_FEATURE_SCENES_H
