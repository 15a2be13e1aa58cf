// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Balls in the points of a maker, against all pairs tested in exact rational numbers, against
// CGAL::box_self_intersection_d() with the same test, and against the recursive route.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_CHECK_BALLS_H
#define THICK_INTERSECTION_TEST_SUPPORT_CHECK_BALLS_H

#include "check_pairs.h"
#include "parallel_pairs.h"
#include "point_scene.h"

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

struct Number_ball
{
  Coordinates center;
  double radius;
};
using Number_balls = std::vector<Number_ball>;

// Are the balls closer than the sum of their radii, tangent, or apart? In exact rationals.
inline int compare_distance_with_radii(const Number_ball& a, const Number_ball& b)
{
  CGAL::Exact_rational squared_distance(0);
  for(std::size_t i = 0; i < a.center.size(); ++i) {
    const CGAL::Exact_rational d
      = CGAL::Exact_rational(a.center[i]) - CGAL::Exact_rational(b.center[i]);
    squared_distance += d * d;
  }
  const CGAL::Exact_rational sum = CGAL::Exact_rational(a.radius) + CGAL::Exact_rational(b.radius);
  return CGAL::compare(squared_distance, CGAL::Exact_rational(sum * sum));
}

// Those that are tangent are left out if the most that a comparison may say is -1.
inline Pairs intersecting_balls(const Number_balls& balls, int most = 0)
{
  return pairs_where(balls.size(), [&](std::size_t i, std::size_t j) {
    return compare_distance_with_radii(balls[i], balls[j]) <= most;
  });
}

// By boxes around the balls. Sides of the boxes are rounded once.
template <int Dimension>
Pairs intersecting_balls_by_boxes(const Number_balls& balls)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, Dimension, std::size_t>;
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Box> boxes;
  for(const Number_ball& ball : balls) {
    double low[Dimension], high[Dimension];
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      low[axis] = std::nextafter(ball.center[axis] - ball.radius, -infinity);
      high[axis] = std::nextafter(ball.center[axis] + ball.radius, infinity);
    }
    boxes.emplace_back(low, high, boxes.size());
  }
  Pairs pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if(compare_distance_with_radii(balls[a.info()], balls[b.info()]) <= 0)
      pairs.push_back(std::minmax(a.info(), b.info()));
  });
  return pairs;
}

inline Pairs intersecting_balls_by_boxes(const Number_balls& balls, int dimension)
{
  return dimension == 2   ? intersecting_balls_by_boxes<2>(balls)
         : dimension == 3 ? intersecting_balls_by_boxes<3>(balls)
                          : intersecting_balls_by_boxes<5>(balls);
}

// Balls at places of a lattice, with radius(random, i), both in a unit.
template <class Radius>
Number_balls balls_on_lattice(int dimension, double unit, const Radius& radius)
{
  std::mt19937_64 random(static_cast<unsigned int>(dimension));
  Number_balls balls;
  for(std::size_t i = 0; i < 240; ++i) {
    Coordinates center;
    for(int axis = 0; axis < dimension; ++axis)
      center.push_back(unit * (static_cast<double>(random() % (dimension == 2 ? 60 : 16)) - 8));
    balls.push_back({center, unit * static_cast<double>(radius(random, i))});
  }
  return balls;
}

struct Ball_scene
{
  std::string name;
  Number_balls balls;
};

inline std::vector<Ball_scene> ball_scenes(int dimension, double unit)
{
  using Random = std::mt19937_64;
  const auto add = [&](const std::string& name, const auto& radius) {
    return Ball_scene{name, balls_on_lattice(dimension, unit, radius)};
  };
  std::vector<Ball_scene> scenes = {
    add("of one radius", [](Random&, std::size_t) { return 2; }),
    add("of any radii", [](Random& random, std::size_t) { return random() % 4; }),
    add("power law", [](Random& random, std::size_t) { return 30 / (1 + random() % 60); }),
    add("one giant", [](Random&, std::size_t i) { return i == 77 ? 40 : 1; }),
    add("without extent", [](Random& random, std::size_t) { return random() % 50 == 0; })};
  Ball_scene concentric = {"concentric", {}}, tangent = {"tangent from within", {}};
  for(int i = 0; i < 60; ++i) {
    Coordinates center(static_cast<std::size_t>(dimension), unit);
    concentric.balls.push_back({center, unit * i});
    center[0] = unit * i;
    tangent.balls.push_back({center, unit * i});
  }
  scenes.push_back(concentric);
  scenes.push_back(tangent);
  return scenes;
}

using Report = std::function<void(std::size_t, std::size_t)>;

// Searches the balls as one set, and as two sets.
template <class ConcurrencyTag, class Ball>
void check_ball_pairs(const std::vector<Ball>& balls, const Pairs& expected)
{
  using Traits = CGAL::Thick_ball_traits_d<typename Ball::first_type>;
  const Traits traits(balls);
  const Pairs one_set = collected([&](const Report& report) {
    CGAL::thick_self_intersection_d<ConcurrencyTag>(balls, report,
                                                    CGAL::parameters::geom_traits(traits));
  });
  const auto [a, b] = split(balls, balls.size() / 2);
  const Traits traits_of_both(a, b);
  const Pairs two_sets = collected([&, &a = a, &b = b](const Report& report) {
    CGAL::thick_intersection_d<ConcurrencyTag>(a, b, report,
                                               CGAL::parameters::geom_traits(traits_of_both));
  });
  check_pairs("balls", expected, one_set, two_sets, a.size());
}

// The recursive route finds the same pairs of one set. It is the one that the public functions
// compile.
template <class Ball>
void check_recursive_route(const std::vector<Ball>& balls, const Pairs& expected)
{
  namespace internal = CGAL::Thick_intersection_d::internal;
  const CGAL::Thick_ball_traits_d<typename Ball::first_type> traits(balls);
  const internal::Numbered_elements<std::vector<Ball>> elements(balls);
  internal::Unwatched_progress progress;
  check_pairs("recursive route", expected, collected([&](const Report& report) {
    internal::search_recursively(elements, internal::One_set(), traits, report, progress,
                                 internal::Threads());
  }));
}

// Balls of a maker of points, with radii that are numbers of its kernel. They are searched in
// sequence, in parallel if it is said, and by the recursive route.
template <class Maker, class FT = double, class... ConcurrencyTags>
struct Balls_of
{
  static void check(const Number_balls& number_balls, const Pairs& expected)
  {
    std::vector<std::pair<typename Maker::Point, FT>> balls;
    for(const Number_ball& ball : number_balls)
      balls.emplace_back(Maker::make(ball.center), FT(ball.radius));
    check_ball_pairs<CGAL::Sequential_tag>(balls, expected);
    (check_ball_pairs<ConcurrencyTags>(balls, expected), ...);
    check_recursive_route(balls, expected);
  }
};

// Every scene, as balls of each of these types. Returns the number of tangent ones.
template <class... Balls>
std::size_t check_ball_scenes(int dimension, double unit)
{
  std::size_t tangent = 0;
  for(const Ball_scene& scene : ball_scenes(dimension, unit))
    BOOST_TEST_CONTEXT(dimension << "D " << scene.name << ", unit " << unit)
    {
      const Pairs expected = intersecting_balls(scene.balls);
      tangent += expected.size() - intersecting_balls(scene.balls, -1).size();
      BOOST_CHECK(sorted(intersecting_balls_by_boxes(scene.balls, dimension)) == expected);
      (Balls::check(scene.balls, expected), ...);
    }
  return tangent;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_CHECK_BALLS_H
