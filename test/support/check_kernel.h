// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The matrix of kernels and scenes, on one kernel: the near pairs of every scene, closed and open,
// one set and two, by the default route and by recursion; and its closest and close pairs.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_KERNEL_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_KERNEL_H

#include "check_closest_pair.h"
#include "check_pairs.h"

namespace test_support {

// The points at even positions, or those at odd ones.
template <class T>
std::vector<T> every_other(const std::vector<T>& all, std::size_t first)
{
  std::vector<T> result;
  for(std::size_t i = first; i < all.size(); i += 2)
    result.push_back(all[i]);
  return result;
}

// Of the pairs of the whole set, those between even positions and odd ones, in their own numbering.
inline Pairs between_even_and_odd(const Pairs& pairs)
{
  Pairs result;
  for(const Pair& p : pairs)
    if((p.first + p.second) % 2 == 1)
      result.emplace_back((p.first % 2 == 0 ? p.first : p.second) / 2,
                          (p.first % 2 == 0 ? p.second : p.first) / 2);
  return result;
}

// Checks the pairs of a scene as `Maker` makes it, with the bound that belongs to that.
template <class Maker, class NT>
void check_scene(const Point_scene& scene, const CGAL::Distance_bound<NT>& bound)
{
  BOOST_TEST_CONTEXT(scene)
  {
    const Truth& truth = truth_of(scene);
    const auto points = make_points<Maker>(scene.points);
    check_pairs("closed", truth.pairs, near_pairs(points, bound));
    check_pairs("by recursion", truth.pairs,
                near_pairs_by_recursion(points, bound, scene.dimension));
    check_pairs("open", truth.open_pairs, near_pairs(points, bound.open()));
    check_pairs("two sets", between_even_and_odd(truth.pairs),
                near_pairs(every_other(points, 0), every_other(points, 1), bound));
  }
}

template <class Maker>
void check_scene(const Point_scene& scene)
{
  with_bound(scene.radius, [&](const auto& bound) { check_scene<Maker>(scene, bound); });
}

template <class Maker>
void check_scenes(const Scenes& scenes)
{
  for(const Point_scene& scene : scenes) {
    check_scene<Maker>(scene);
    check_closest_scene<Maker>(scene);
  }
}

template <class Maker>
void check_kernel(int dimension)
{
  check_scenes<Maker>(all_scenes(dimension));
}

// The scenes as they are after rounding to floats, without those that a float cannot hold.
inline Scenes float_scenes(int dimension)
{
  Scenes scenes;
  for(Point_scene scene : all_scenes(dimension)) {
    bool is_finite = true;
    for(Coordinates& c : scene.points)
      for(double& x : c) {
        x = static_cast<float>(x);
        is_finite = is_finite && std::isfinite(x);
      }
    if(is_finite)
      scenes.push_back(scene);
  }
  return scenes;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_KERNEL_H
