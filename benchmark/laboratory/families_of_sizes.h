// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rectangles, cuboids and balls whose sizes differ more and more, and their intersecting pairs.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_FAMILIES_OF_SIZES_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_FAMILIES_OF_SIZES_H

#include "columns.h"

#include "scenes/object_generators.h"

#include "support/exact_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace lab {

using test_support::Rational;

// ---- families -----------------------------------------------------------------------------------

struct Family
{
  std::string shape;
  std::string name;
  Object_scene scene;
};

// Sizes are such that about n pairs are expected.
inline std::vector<Family> families_of_boxes(int dimension, std::size_t n, std::size_t dense)
{
  const std::string shape = dimension == 2 ? "2D rectangles" : "3D cuboids";
  const double k = static_cast<double>(n);
  return {
    {shape, "uniform", uniform_boxes(dimension, n, k)},
    {shape, "power law", power_law_boxes(dimension, n, k)},
    {shape, "six decades", log_uniform_boxes(dimension, n, k)},
    {shape, "one giant", boxes_with_giant(dimension, n, k)},
    {shape, "nested", nested_boxes(dimension, dense)},
    {shape, "identical", identical_boxes(dimension, dense)},
    dimension == 2 ? Family{shape, "thin", thin_boxes(n, k)} : Family{shape, "beams", beams(n, k)},
    {shape, "trap for trees", trap(dimension, n)},
    {shape, "integers", integer_objects(Shape::BOX, dimension, n)},
    {shape, "decimals", decimal_objects(Shape::BOX, dimension, n)},
  };
}

inline std::vector<Family> families_of_balls(std::size_t n, std::size_t dense)
{
  const std::string shape = "3D balls";
  const double k = static_cast<double>(n);
  return {
    {shape, "uniform", uniform_balls(n, k)},
    {shape, "power law", power_law_balls(n, k)},
    {shape, "six decades", log_uniform_balls(n, k)},
    {shape, "one giant", balls_with_giant(n, k)},
    {shape, "nested", nested_balls(dense)},
    {shape, "identical", identical_balls(dense)},
    {shape, "integers", integer_objects(Shape::BALL, 3, n)},
    {shape, "decimals", decimal_objects(Shape::BALL, 3, n)},
  };
}

// `dense` is the number of objects where all of them meet.
inline std::vector<Family> families_of_sizes(std::size_t n, std::size_t dense)
{
  std::vector<Family> all = families_of_boxes(2, n, dense);
  for(std::vector<Family> families : {families_of_boxes(3, n, dense), families_of_balls(n, dense)})
    for(Family& family : families)
      all.push_back(std::move(family));
  return all;
}

// ---- the truth: a sweep along the first axis ----------------------------------------------------

// Of three coordinates and a radius each.
inline bool do_balls_meet(const double* a, const double* b)
{
  Rational square = 0;
  for(int axis = 0; axis < 3; ++axis) {
    const Rational difference = Rational(a[axis]) - Rational(b[axis]);
    square += difference * difference;
  }
  const Rational sum = Rational(a[3]) + Rational(b[3]);
  return square <= sum * sum;
}

struct Swept_box
{
  double low[3] = {};
  double high[3] = {};
  std::size_t position;

  bool meets(const Swept_box& other) const
  {
    for(int axis = 1; axis < 3; ++axis)
      if(low[axis] > other.high[axis] || other.low[axis] > high[axis])
        return false;
    return true;
  }
};

// Boxes of balls are rounded outwards.
inline Swept_box swept_box(const Object_scene& scene, std::size_t position)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool is_ball = scene.shape == Shape::BALL;
  const double* x = scene.object(position);
  Swept_box box;
  box.position = position;
  for(int axis = 0; axis < scene.dimension; ++axis) {
    box.low[axis] = is_ball ? std::nextafter(x[axis] - x[3], -infinity) : x[axis];
    box.high[axis] = is_ball ? std::nextafter(x[axis] + x[3], infinity) : x[scene.dimension + axis];
  }
  return box;
}

inline Pairs true_pairs(const Object_scene& scene)
{
  const bool are_balls = scene.shape == Shape::BALL;
  std::vector<Swept_box> boxes;
  for(std::size_t i = 0; i < scene.size(); ++i)
    boxes.push_back(swept_box(scene, i));
  std::sort(boxes.begin(), boxes.end(),
            [](const Swept_box& a, const Swept_box& b) { return a.low[0] < b.low[0]; });
  Pairs pairs;
  for(auto a = boxes.begin(); a != boxes.end(); ++a)
    for(auto b = a + 1; b != boxes.end() && b->low[0] <= a->high[0]; ++b)
      if(a->meets(*b)
         && (!are_balls || do_balls_meet(scene.object(a->position), scene.object(b->position))))
        pairs.push_back(std::minmax(a->position, b->position));
  return test_support::sorted(std::move(pairs));
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_FAMILIES_OF_SIZES_H
