// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Generators of points in any dimension. A seed gives the same points on every platform: only
// std::mt19937_64 itself, + - * and exact scalings are used, no distribution of the standard
// library and no function of libm.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_POINT_GENERATORS_H
#define THICK_INTERSECTION_TEST_SUPPORT_POINT_GENERATORS_H

#include "point_scene.h"

namespace test_support {

class Random
{
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // A multiple of 2^-53 in [0, 1).
  double uniform() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }

  // A multiple of 2^-bits in [0, 1), bits <= 53.
  double fixed_point(int bits)
  {
    return std::ldexp(static_cast<double>(engine_() >> (64 - bits)), -bits);
  }

  // The modulo favours small values by less than size / 2^64, which no test can see.
  std::uint64_t below(std::uint64_t size) { return engine_() % size; }

  // Mean 0, variance 1: twelve uniforms are close enough to a Gaussian to make clusters.
  double bell()
  {
    double sum = -6;
    for(int i = 0; i < 12; ++i)
      sum += uniform();
    return sum;
  }

private:
  std::mt19937_64 engine_;
};

inline Points uniform_points(int dimension, std::size_t n, double low, double side,
                             std::uint64_t seed)
{
  Random random(seed);
  Points points(n, Coordinates(dimension));
  for(Coordinates& p : points)
    for(double& x : p)
      x = low + side * random.uniform();
  return points;
}

// Integers from 0 to side - 1.
inline Points integer_points(int dimension, std::size_t n, std::size_t side, Random& random)
{
  Points points(n, Coordinates(dimension));
  for(Coordinates& p : points)
    for(double& x : p)
      x = static_cast<double>(random.below(side));
  return points;
}

// Bells of standard deviation `spread` around centres that are uniform in the unit cube.
inline Points clustered_points(int dimension, std::size_t n, std::size_t clusters, double spread,
                               std::uint64_t seed)
{
  const Points centres = uniform_points(dimension, clusters, 0, 1, seed);
  Random random(seed + 1);
  Points points;
  for(std::size_t i = 0; i < n; ++i) {
    Coordinates p = centres[random.below(clusters)];
    for(double& x : p)
      x += spread * random.bell();
    points.push_back(p);
  }
  return points;
}

// A Levy flight: steps of every length.
inline Points flight_points(int dimension, std::size_t n)
{
  std::mt19937_64 random(5);
  Points points = {Coordinates(dimension, 0)};
  while(points.size() < n) {
    Coordinates c = points.back();
    const double step = 1 / (1e-9 + std::ldexp(static_cast<double>(random() >> 11), -53));
    for(double& x : c)
      x += step * (std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5);
    points.push_back(c);
  }
  return points;
}

// All points with coordinates offset + unit * i, 0 <= i < m, each rounded as written.
inline Points lattice_points(int dimension, std::size_t m, double unit, double offset = 0)
{
  Points points(1);
  for(int axis = 0; axis < dimension; ++axis) {
    Points longer;
    for(const Coordinates& p : points)
      for(std::size_t i = 0; i < m; ++i) {
        longer.push_back(p);
        longer.back().push_back(offset + unit * static_cast<double>(i));
      }
    points.swap(longer);
  }
  return points;
}

inline Points identical_points(int dimension, std::size_t n, double value)
{
  return Points(n, Coordinates(dimension, value));
}

// n points start + step * i along one axis, with all other coordinates equal to `start`.
inline Points axis_points(int dimension, std::size_t n, int axis, double start, double step)
{
  Points points = identical_points(dimension, n, start);
  for(std::size_t i = 0; i < n; ++i)
    points[i][axis] = start + step * static_cast<double>(i);
  return points;
}

// n points i * direction, exactly collinear while i * direction[axis] fits a double.
inline Points oblique_points(const Coordinates& direction, std::size_t n)
{
  Points points;
  for(std::size_t i = 0; i < n; ++i) {
    points.push_back(direction);
    for(double& x : points.back())
      x *= static_cast<double>(i);
  }
  return points;
}

// `copies` of the whole list one after the other: equal points are far apart in the input.
inline Points repeated(const Points& points, std::size_t copies)
{
  Points result;
  for(std::size_t copy = 0; copy < copies; ++copy)
    result.insert(result.end(), points.begin(), points.end());
  return result;
}

// std::shuffle may differ between standard libraries; this one does not.
template <class Items>
Items shuffled(Items items, Random& random)
{
  for(std::size_t i = items.size(); i > 1; --i)
    std::swap(items[i - 1], items[random.below(i)]);
  return items;
}

template <class Items>
Items shuffled(Items items, std::uint64_t seed)
{
  Random random(seed);
  return shuffled(std::move(items), random);
}

// The same points in a higher dimension, the new coordinates all equal to `value`.
inline Points embedded(Points points, int dimension, double value = 0)
{
  for(Coordinates& p : points)
    p.resize(dimension, value);
  return points;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_POINT_GENERATORS_H
