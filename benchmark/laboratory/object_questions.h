// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Questions about a set of objects, those whose boxes meet, and the right answers to them.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_QUESTIONS_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_QUESTIONS_H

#include "object_families.h"

#include "support/distance_oracle.h"
#include "support/exact_points.h"
#include "support/hull_oracle.h"
#include "support/pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace lab {

using test_support::Integer;
using test_support::Pairs;

// Whether the interiors of two convex sets meet, which have some: no plane at the origin has all
// differences of their vertices on one side, or in it. Those that two differences span are enough.
inline bool do_open_hulls_intersect(const test_support::Hull_vectors<Integer>& a,
                                    const test_support::Hull_vectors<Integer>& b, int dimension)
{
  using Vector = test_support::Hull_vector<Integer>;
  const test_support::Hull_vectors<Integer> all = test_support::differences_of(a, b);
  for(const Vector& u : all)
    for(const Vector& v : all) {
      const Vector normal = cross(u, dimension == 2 ? Vector{0, 0, 1} : v);
      if(test_support::is_null(normal))
        continue;
      if(std::all_of(all.begin(), all.end(),
                     [&](const Vector& w) { return dot(normal, w) >= 0; }))
        return false;
    }
  return true;
}

// The vertices of all objects, in integers: each axis has a unit of its own, 2^e, unless there are
// radii.
class Exact_objects
{
public:
  explicit Exact_objects(const Object_set& objects) : kind_(objects.kind)
  {
    const auto dimension = static_cast<std::size_t>(objects.kind.dimension);
    std::vector<int> units = unit_exponents(objects.numbers, dimension);
    if(!objects.radii.empty()) {
      units.push_back(unit_exponents(objects.radii, 1)[0]);
      units.assign(dimension, *std::min_element(units.begin(), units.end()));
    }
    for(double radius : objects.radii)
      radii_.push_back(in_units(radius, units[0]));
    for(std::size_t i = 0; i < objects.size(); ++i) {
      vertices_.emplace_back(objects.kind.vertices);
      const double* x = objects.object(i);
      for(auto& vertex : vertices_.back())
        for(std::size_t axis = 0; axis < dimension; ++axis)
          vertex[axis] = in_units(*x++, units[axis]);
    }
    for(double time : objects.times)
        times_.push_back(in_units(time, unit_exponents(objects.times, 1)[0]));
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    if(kind_.meaning == Meaning::OPEN)
      return do_open_hulls_intersect(vertices_[i], vertices_[j], kind_.dimension);
    if(kind_.meaning == Meaning::MOVING)
      return come_within(i, j, radii_[i] + radii_[j]);
    if(kind_.meaning != Meaning::THICK)
      return test_support::do_hulls_intersect(vertices_[i], vertices_[j]);
    const Integer sum = radii_[i] + radii_[j], square = sum * sum;
    return test_support::squared_distance_of_hulls(vertices_[i], vertices_[j])
           <= test_support::Rational(boost::multiprecision::mpz_int(square));
  }

private:
  // One point sees the other one go along a segment. Its ends are multiplied by both durations; a
  // leg that lasts for no time has no way either.
  bool come_within(std::size_t i, std::size_t j, const Integer& bound) const
  {
    using Vector = test_support::Hull_vector<Integer>;
    const Integer first = std::max(times_[2 * i], times_[2 * j]);
    const Integer last = std::min(times_[2 * i + 1], times_[2 * j + 1]);
    if(first > last)
      return false;
    const auto duration = [&](std::size_t k) {
      return std::max(Integer(times_[2 * k + 1] - times_[2 * k]), Integer(1));
    };
    const auto place_at = [&](const Integer& time, std::size_t k) {
      Vector place = difference(vertices_[k][1], vertices_[k][0]);
      for(std::size_t axis = 0; axis < 3; ++axis)
        place[axis] = duration(k) * vertices_[k][0][axis] + (time - times_[2 * k]) * place[axis];
      return place;
    };
    test_support::Hull_vectors<Integer> ends;
    for(const Integer& time : {first, last}) {
      const Vector a = place_at(time, i), b = place_at(time, j);
      ends.emplace_back();
      for(std::size_t axis = 0; axis < 3; ++axis)
        ends.back()[axis] = duration(j) * a[axis] - duration(i) * b[axis];
    }
    const Integer limit = bound * duration(i) * duration(j), square = limit * limit;
    return test_support::squared_distance_of_hulls(ends, {Vector{}})
           <= test_support::Rational(boost::multiprecision::mpz_int(square));
  }

  // All numbers along an axis have their last bits at its unit or above it.
  static std::vector<int> unit_exponents(const std::vector<double>& numbers, std::size_t dimension)
  {
    std::vector<int> units(dimension, std::numeric_limits<int>::max());
    for(std::size_t i = 0; i < numbers.size(); ++i)
      if(numbers[i] != 0)
        units[i % dimension] = std::min(units[i % dimension], std::ilogb(numbers[i]) - 52);
    return units;
  }

  static Integer in_units(double x, int unit)
  {
    if(x == 0)
      return 0;
    int exponent;
    const Integer significand(std::ldexp(std::frexp(x, &exponent), 53));
    return significand << (exponent - 53 - unit);
  }

  Kind kind_;
  std::vector<test_support::Hull_vectors<Integer>> vertices_;
  std::vector<Integer> radii_, times_;
};

struct Object_questions
{
  Object_set objects;
  Pairs pairs; // i < j
  std::vector<char> answers;

  std::size_t true_pairs() const
  {
    return static_cast<std::size_t>(std::count(answers.begin(), answers.end(), 1));
  }
};

inline bool do_boxes_meet(const Object_set& set, std::size_t i, std::size_t j)
{
  const double *a = set.object(i), *b = set.object(j);
  const double reach = (set.radius(i) + set.radius(j)) * (1 + 0x1p-40);
  for(int axis = 0; axis < set.kind.dimension; ++axis) {
    const auto ends = [&](const double* object) {
      std::pair<double, double> ends(object[axis], object[axis]);
      for(int v = 1; v < set.kind.vertices; ++v) {
        const double x = object[v * set.kind.dimension + axis];
        ends = {std::min(ends.first, x), std::max(ends.second, x)};
      }
      return ends;
    };
    const auto [a_low, a_high] = ends(a);
    const auto [b_low, b_high] = ends(b);
    if(a_low - b_high > reach || b_low - a_high > reach)
      return false;
  }
  return true;
}

// About all pairs whose boxes meet. Boxes with radii are a little larger than need be.
inline Object_questions questions_about(const Object_set& set)
{
  const Exact_objects exact(set);
  Object_questions questions = {set, {}, {}};
  for(std::size_t i = 0; i < set.size(); ++i)
    for(std::size_t j = i + 1; j < set.size(); ++j)
      if(do_boxes_meet(set, i, j)) {
        questions.pairs.emplace_back(i, j);
        questions.answers.push_back(exact.do_intersect(i, j));
      }
  return questions;
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_QUESTIONS_H
