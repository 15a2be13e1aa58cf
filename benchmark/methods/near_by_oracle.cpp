// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "near_methods.h"

#include "support/distance_oracle.h"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace thick_benchmark {

namespace {

using boost::multiprecision::mpz_int;
using test_support::Rational;
using Hull = test_support::Hull_vectors<mpz_int>;

// Coordinates of scenes are multiples of this power of two.
constexpr int digits = 80;

mpz_int scaled(double x)
{
  const double number = std::ldexp(x, digits);
  if(number != std::trunc(number))
    throw std::invalid_argument("A coordinate has too many digits.");
  return mpz_int(number);
}

Hull hull_of(const Object_scene& scene, std::size_t i)
{
  Hull hull;
  for(std::size_t corner = 0; corner < corners_of(scene.shape); ++corner) {
    hull.emplace_back();
    for(std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimension); ++axis)
      hull.back()[axis]
        = scaled(scene.object(i)[corner * static_cast<std::size_t>(scene.dimension) + axis]);
  }
  return hull;
}

// Whether the boxes of two objects are apart by more than the distance along an axis.
bool are_apart(const Hull& a, const Hull& b, const mpz_int& r)
{
  for(std::size_t axis = 0; axis < 3; ++axis) {
    const auto less = [=](const auto& p, const auto& q) { return p[axis] < q[axis]; };
    const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), less);
    const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), less);
    if((*low_b)[axis] - (*high_a)[axis] > r || (*low_a)[axis] - (*high_b)[axis] > r)
      return true;
  }
  return false;
}

} // namespace

Pair_list near_pairs_by_oracle(const Near_scene& scene)
{
  std::vector<Hull> hulls;
  for(std::size_t i = 0; i < scene.objects.size(); ++i)
    hulls.push_back(hull_of(scene.objects, i));
  const mpz_int r = scaled(scene.r);
  Pair_list pairs;
  for(std::size_t i = 0; i < hulls.size(); ++i)
    for(std::size_t j = i + 1; j < hulls.size(); ++j)
      if(!are_apart(hulls[i], hulls[j], r)
         && test_support::squared_distance_of_hulls(hulls[i], hulls[j]) <= Rational(r * r))
        pairs(i, j);
  return pairs;
}

} // namespace thick_benchmark
