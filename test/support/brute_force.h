// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The truth: every pair, decided in exact integers.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_BRUTE_FORCE_H
#define THICK_INTERSECTION_TEST_SUPPORT_BRUTE_FORCE_H

#include "exact_points.h"
#include "pairs.h"

namespace test_support {

struct Truth
{
  Pairs pairs;          // at distance at most the radius, sorted
  Pairs open_pairs;     // closer than the radius, sorted
  std::size_t boundary; // at exactly the radius: pairs.size() - open_pairs.size()
};

// Pairs (i, j) with i < j.
inline Truth brute_force(const Points& points, const Radius& radius)
{
  const Exact_points exact(points, radius);
  Truth truth{};
  for(std::size_t i = 0; i < exact.size(); ++i)
    for(std::size_t j = i + 1; j < exact.size(); ++j) {
      const int sign = exact.compare_distance_with_radius(i, j);
      if(sign <= 0)
        truth.pairs.emplace_back(i, j);
      if(sign < 0)
        truth.open_pairs.emplace_back(i, j);
      truth.boundary += sign == 0;
    }
  return truth;
}

inline Points concatenated(Points a, const Points& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Computed once per process for equal points and radius, whatever the scene is called.
inline const Truth& truth_of(const Point_scene& scene)
{
  using Key = std::tuple<Points, std::optional<double>, std::string>;
  static std::map<Key, Truth> known;
  const Key key(scene.points, scene.radius.length(), scene.radius.square_text());
  auto found = known.find(key);
  if(found == known.end())
    found = known.emplace(key, brute_force(scene.points, scene.radius)).first;
  return found->second;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_BRUTE_FORCE_H
