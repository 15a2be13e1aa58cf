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

inline void decide(const Exact_points& points, std::size_t i, std::size_t j, const Pair& name,
                   Truth& truth)
{
  const int sign = points.compare_distance_with_radius(i, j);
  if(sign <= 0)
    truth.pairs.push_back(name);
  if(sign < 0)
    truth.open_pairs.push_back(name);
  if(sign == 0)
    ++truth.boundary;
}

// One set: pairs (i, j) with i < j.
inline Truth brute_force(const Points& points, const Radius& radius)
{
  const Exact_points exact(points, radius);
  Truth truth{};
  for(std::size_t i = 0; i < exact.size(); ++i)
    for(std::size_t j = i + 1; j < exact.size(); ++j)
      decide(exact, i, j, Pair(i, j), truth);
  return truth;
}

inline Points concatenated(Points a, const Points& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Two sets: pairs (i in a, j in b).
inline Truth brute_force(const Points& a, const Points& b, const Radius& radius)
{
  const Exact_points exact(concatenated(a, b), radius);
  Truth truth{};
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t j = 0; j < b.size(); ++j)
      decide(exact, i, a.size() + j, Pair(i, j), truth);
  return truth;
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
