// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair of a scene on one kernel, by every method.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_CLOSEST_PAIR_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_CLOSEST_PAIR_H

#include "brute_force.h"
#include "closest_pair_oracle.h"
#include "kernels.h"
#include "robustness_families.h"
#include "scenes.h"

#include <CGAL/closest_pair.h>

#include <boost/test/unit_test.hpp>

#include <map>
#include <numeric>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;

template <class Point>
using Elements_of = internal::Elements<std::vector<Point>>;

template <class Point>
CGAL::Scene_profile profile_of(const std::vector<Point>& points)
{
  return CGAL::profile_scene(points, CGAL::within_distance(0));
}

template <class Point>
Pair closest_by_division(const std::vector<Point>& points)
{
  return internal::divide_and_conquer<CGAL::Sequential_tag>(Elements_of<Point>(points),
                                                            profile_of(points));
}

constexpr int static_dimension(CGAL::Dynamic_dimension_tag) { return 0; }
template <int Dimension>
constexpr int static_dimension(CGAL::Dimension_tag<Dimension>)
{
  return Dimension;
}

// By the randomised grid; nothing if it says that doubles are too coarse, or that points are equal.
template <int Dimension, class Point>
std::optional<Pair> closest_by_grid(const std::vector<Point>& points, std::uint64_t seed)
{
  const Elements_of<Point> elements(points);
  const CGAL::Scene_profile profile = profile_of(points);
  std::vector<std::uint32_t> positions(points.size());
  std::iota(positions.begin(), positions.end(), 0);
  internal::Pair_minimum<Elements_of<Point>> minimum(elements, profile);
  internal::Closest_pair_grid<Dimension, Elements_of<Point>> grid(
    elements, positions, profile.dimension(),
    internal::greatest_error(elements, profile.dimension()), seed);
  return grid.search(minimum) ? std::optional<Pair>(minimum.pair()) : std::nullopt;
}

template <class Point, class NT>
std::optional<Pair> close_by_grid(const std::vector<Point>& points,
                                  const CGAL::Distance_bound<NT>& bound,
                                  internal::Bucket_access access)
{
  using Exact = internal::Exact_number_t<internal::Coordinate_t<Point>>;
  const Elements_of<Point> elements(points);
  const internal::Squared_bound<Exact> squared_bound(bound);
  const int dimension = points.empty() ? 0 : points.front().dimension();
  return internal::Close_pair_grid<CGAL::Sequential_tag, Elements_of<Point>>(
    elements, squared_bound, dimension, access).find(internal::All_positions(points.size()));
}

inline const Closest& known_closest(const Points& points)
{
  static std::map<Points, Closest> known;
  auto found = known.find(points);
  if(found == known.end())
    found = known.emplace(points, closest_of_doubles(points)).first;
  return found->second;
}

inline void check_pair(const std::string& method, const Pair& expected, const Pair& found)
{
  BOOST_CHECK_MESSAGE(expected == found, method << ": (" << found.first << ", " << found.second
                                                << ") instead of (" << expected.first << ", "
                                                << expected.second << ')');
}

template <class Maker>
void check_closest_pair(const Points& scene)
{
  const auto points = make_points<Maker>(scene);
  const Pair expected = known_closest(scene).pair;
  check_pair("default", expected, CGAL::closest_pair(points));
  check_pair("another seed", expected,
             CGAL::closest_pair(points, CGAL::parameters::random_seed(7)));
  check_pair("division", expected, closest_by_division(points));
  using Dimension = typename CGAL::Ambient_dimension<typename Maker::Point>::type;
  if(const auto pair = closest_by_grid<static_dimension(Dimension())>(points, 1))
    check_pair("grid", expected, *pair);
}

// A pair was found if there is one, and it is one of them.
inline void check_close_pair(const std::string& method, const Pairs& all,
                             const std::optional<Pair>& found)
{
  if(!found)
    BOOST_CHECK_MESSAGE(all.empty(), method << ": none found of " << all.size());
  else
    BOOST_CHECK_MESSAGE(std::binary_search(all.begin(), all.end(), *found),
                        method << ": (" << found->first << ", " << found->second << ")");
}

template <class Maker, class NT>
void check_close_pair(const std::vector<typename Maker::Point>& points,
                      const CGAL::Distance_bound<NT>& bound, const Pairs& all)
{
  check_close_pair("default", all, CGAL::find_close_pair(points, bound));
  check_close_pair("hashing", all, close_by_grid(points, bound, internal::Bucket_access::HASHING));
  check_close_pair("order", all,
                   close_by_grid(points, bound, internal::Bucket_access::SORTED_ORDER));
}

// At the distance of the closest pair, and at that of the scene, closed and open.
template <class Maker>
void check_closest_scene(const Point_scene& scene)
{
  BOOST_TEST_CONTEXT(scene)
  {
    const auto points = make_points<Maker>(scene.points);
    const Truth& truth = truth_of(scene);
    with_bound(scene.radius, [&](const auto& bound) {
      check_close_pair<Maker>(points, bound, truth.pairs);
      check_close_pair<Maker>(points, bound.open(), truth.open_pairs);
    });
    if(points.size() >= 2)
      check_closest_pair<Maker>(scene.points);
  }
}

inline Scenes closest_pair_scenes(int dimension)
{
  Scenes scenes = small_scenes(dimension);
  if(dimension == 2 || dimension == 3)
    for(const Point_scene& family : robustness_families(dimension))
      scenes.push_back(family);
  return scenes;
}

template <class Maker>
void check_closest_scenes(int dimension)
{
  for(const Point_scene& scene : closest_pair_scenes(dimension))
    check_closest_scene<Maker>(scene);
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_CLOSEST_PAIR_H
