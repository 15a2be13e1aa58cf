// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "generators.h"

#include "from_tests.h"

#include "support/point_generators.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace thick_benchmark {

namespace {

const double pi = 3.14159265358979323846;

using test_support::Points;
using test_support::Random;

// Mean 0, variance 1: the transformation of Box and Muller.
double gaussian(Random& random)
{
  return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * pi * random.uniform());
}

Scene empty_scene(const std::string& name, int dimension, std::size_t n)
{
  Scene scene{std::to_string(dimension) + "D " + name, dimension, {}, 0};
  scene.coordinates.reserve(n * static_cast<std::size_t>(dimension));
  return scene;
}

Scene uniform_points(const std::string& name, int dimension, std::size_t n)
{
  Scene scene = empty_scene(name, dimension, n);
  Random random(1);
  while(scene.size() < n)
    for(int axis = 0; axis < dimension; ++axis)
      scene.coordinates.push_back(random.uniform());
  return scene;
}

// The probability that two uniform points of the unit cube are within r <= 1 of each other. The
// difference |x - y| has density 2 (1 - u) along each axis. The product over the axes is expanded,
// and each term is integrated over the ball.
double probability_within(int dimension, double r)
{
  double sum = 0, choices = 1; // of k of d axes
  for(int k = 0; k <= dimension; ++k) {
    sum += choices * std::pow(-1, k) * std::pow(pi, (dimension - k) / 2.)
           * std::pow(r, dimension + k) / std::tgamma((dimension + k) / 2. + 1);
    choices *= static_cast<double>(dimension - k) / (k + 1);
  }
  return sum;
}

Points read_tsplib(const std::string& file)
{
  std::ifstream in(file);
  Points points;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double number, x, y;
    if(words >> number >> x >> y)
      points.push_back({x, y});
  }
  if(points.empty())
    throw std::runtime_error("There are no points in " + file + ".");
  return points;
}

} // namespace

Scene uniform(int dimension, std::size_t n, double k)
{
  Scene scene = uniform_points("uniform", dimension, n);
  const double probability = k / (static_cast<double>(n) * static_cast<double>(n - 1) / 2);
  double low = 0, high = 1;
  for(int step = 0; step < 60; ++step) {
    scene.r = (low + high) / 2;
    (probability_within(dimension, scene.r) < probability ? low : high) = scene.r;
  }
  return scene;
}

Scene dense(int dimension, std::size_t n)
{
  Scene scene = uniform_points("dense", dimension, n);
  scene.r = 2;
  return scene;
}

Scene lattice(int dimension, std::size_t m, double unit)
{
  return scene_of(std::to_string(dimension) + "D lattice",
                  test_support::shuffled(test_support::lattice_points(dimension, m, unit), 2),
                  unit, dimension);
}

Scene tiled(const std::string& tsplib_file, std::size_t n)
{
  const Points tile = read_tsplib(tsplib_file);
  double width = 0, height = 0;
  for(const auto& p : tile) {
    width = (std::max)(width, p[0] + 1);
    height = (std::max)(height, p[1] + 1);
  }
  const std::size_t copies = (n + tile.size() - 1) / tile.size();
  const std::size_t columns
    = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(copies) * height / width)));
  Points points;
  for(std::size_t copy = 0; copy < copies; ++copy)
    for(const auto& p : tile)
      if(points.size() < n)
        points.push_back({p[0] + width * static_cast<double>(copy % columns),
                          p[1] + height * static_cast<double>(copy / columns)});
  return scene_of("2D tiled", test_support::shuffled(std::move(points), 2), 0, 2);
}

Scene identical(int dimension, std::size_t n)
{
  Scene scene = empty_scene("identical", dimension, 0);
  scene.coordinates.assign(n * static_cast<std::size_t>(dimension), 0.5);
  return scene;
}

Scene mostly_identical(int dimension, std::size_t n)
{
  Scene scene = uniform_points("90 % identical", dimension, n);
  for(std::size_t i = 0; i < scene.coordinates.size(); ++i)
    if(i / static_cast<std::size_t>(dimension) % 10 != 0)
      scene.coordinates[i] = 0.5;
  scene.r = uniform(dimension, n, static_cast<double>(n)).r;
  return scene;
}

Scene clusters(int dimension, std::size_t n)
{
  struct Cluster
  {
    double centre[3];
    double width;
  };
  Random random(3);
  std::vector<Cluster> all(100);
  for(Cluster& cluster : all) {
    for(double& x : cluster.centre)
      x = random.uniform();
    cluster.width = std::pow(10, -1 - 3 * random.uniform());
  }
  Scene scene = empty_scene("clusters", dimension, n);
  while(scene.size() < n) {
    const Cluster& cluster = all[random.below(all.size())];
    for(int axis = 0; axis < dimension; ++axis)
      scene.coordinates.push_back(cluster.centre[axis] + cluster.width * gaussian(random));
  }
  return scene;
}

Scene levy_flight(int dimension, std::size_t n)
{
  Random random(4);
  Points points;
  std::vector<double> place(static_cast<std::size_t>(dimension), 0.);
  while(points.size() < n) {
    double direction[3], square = 0;
    for(std::size_t axis = 0; axis < place.size(); ++axis) {
      direction[axis] = gaussian(random);
      square += direction[axis] * direction[axis];
    }
    const double length = 1 / (1 - random.uniform());
    for(std::size_t axis = 0; axis < place.size(); ++axis)
      place[axis] += length * direction[axis] / std::sqrt(square);
    points.push_back(place);
  }
  return scene_of(std::to_string(dimension) + "D Levy flight",
                  test_support::shuffled(std::move(points), 2), 0, dimension);
}

Scene oblique_plane(std::size_t n)
{
  Random random(5);
  Points points;
  while(points.size() < n) {
    const double s = random.uniform(), t = random.uniform();
    points.push_back({0.6 * s + 0.2 * t, 0.7 * t - 0.3 * s, 0.5 * s + 0.4 * t});
  }
  return scene_of("3D oblique plane", points, 0, 3);
}

Scene oblique_line(std::size_t n)
{
  Random random(6);
  Points points;
  while(points.size() < n) {
    const double t = random.uniform();
    points.push_back({0.6 * t, -0.3 * t, 0.7 * t});
  }
  return scene_of("3D oblique line", points, 0, 3);
}

Scene with_fitting_distance(Scene scene, const Count& count)
{
  const auto extremes = std::minmax_element(scene.coordinates.begin(), scene.coordinates.end());
  const std::uint64_t n = scene.size();
  double high = *extremes.second - *extremes.first;
  double low = std::ldexp(high, -100);
  for(int step = 0; step < 100; ++step) {
    scene.r = std::sqrt(low) * std::sqrt(high);
    const std::uint64_t k = count(scene, 4 * n);
    if(n <= k && k <= 4 * n)
      return scene;
    (k < n ? low : high) = scene.r;
  }
  throw std::runtime_error("No distance gives " + scene.name + " between n and 4 n pairs.");
}

Scene with_fitting_integer_distance(Scene scene, const Count& count)
{
  const std::uint64_t n = scene.size();
  for(scene.r = 1; count(scene, n) < n; ++scene.r) {}
  return scene;
}

Scene with_outlier(Scene scene)
{
  scene.name += " with an outlier";
  for(int axis = 0; axis < scene.dimension; ++axis)
    scene.coordinates[static_cast<std::size_t>(axis)] = 1e15 * scene.r;
  return scene;
}

} // namespace thick_benchmark
