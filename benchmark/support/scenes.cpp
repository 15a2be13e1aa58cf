// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>

namespace thick_benchmark {

namespace {

const double pi = 3.14159265358979323846;

// A seed gives the same points with every standard library: its distributions are not used.
class Random
{
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // A multiple of 2^-53 in [0, 1).
  double uniform() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }

  std::size_t below(std::size_t size) { return static_cast<std::size_t>(engine_() % size); }

  // Mean 0, variance 1: the transformation of Box and Muller.
  double gaussian()
  {
    return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * pi * uniform());
  }

private:
  std::mt19937_64 engine_;
};

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

// The probability that two uniform points of the unit square or cube are within r <= 1 (square and
// cube line picking).
double probability_within(int dimension, double r)
{
  return dimension == 2
           ? r * r * (pi - r * (8. / 3 - r / 2))
           : r * r * r * (4 * pi / 3 - r * (3 * pi / 2 - r * (8. / 5 - r / 6)));
}

void shuffle(Scene& scene)
{
  const std::size_t dimension = static_cast<std::size_t>(scene.dimension);
  const auto point = [&](std::size_t i) {
    return scene.coordinates.begin() + static_cast<std::ptrdiff_t>(i * dimension);
  };
  Random random(2);
  for(std::size_t i = scene.size(); i > 1; --i)
    std::swap_ranges(point(i - 1), point(i), point(random.below(i)));
}

std::vector<std::pair<double, double>> read_tsplib(const std::string& file)
{
  std::ifstream in(file);
  std::vector<std::pair<double, double>> points;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double number, x, y;
    if(words >> number >> x >> y)
      points.emplace_back(x, y);
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
  std::size_t n = 1;
  for(int axis = 0; axis < dimension; ++axis)
    n *= m;
  Scene scene = empty_scene("lattice", dimension, n);
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t axis = 0, rest = i; axis < static_cast<std::size_t>(dimension);
        ++axis, rest /= m)
      scene.coordinates.push_back(unit * static_cast<double>(rest % m));
  shuffle(scene);
  scene.r = unit;
  return scene;
}

Scene tiled(const std::string& tsplib_file, std::size_t n)
{
  const auto tile = read_tsplib(tsplib_file);
  double width = 0, height = 0;
  for(const auto& p : tile) {
    width = (std::max)(width, p.first + 1);
    height = (std::max)(height, p.second + 1);
  }
  const std::size_t copies = (n + tile.size() - 1) / tile.size();
  const std::size_t columns
    = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(copies) * height / width)));
  Scene scene = empty_scene("tiled", 2, n);
  for(std::size_t copy = 0; copy < copies; ++copy)
    for(const auto& p : tile)
      if(scene.size() < n) {
        scene.coordinates.push_back(p.first + width * static_cast<double>(copy % columns));
        scene.coordinates.push_back(p.second + height * static_cast<double>(copy / columns));
      }
  shuffle(scene);
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
      scene.coordinates.push_back(cluster.centre[axis] + cluster.width * random.gaussian());
  }
  return scene;
}

Scene levy_flight(int dimension, std::size_t n)
{
  Scene scene = empty_scene("Levy flight", dimension, n);
  Random random(4);
  std::vector<double> place(static_cast<std::size_t>(dimension), 0.);
  while(scene.size() < n) {
    double direction[3], square = 0;
    for(std::size_t axis = 0; axis < place.size(); ++axis) {
      direction[axis] = random.gaussian();
      square += direction[axis] * direction[axis];
    }
    const double length = 1 / (1 - random.uniform());
    for(std::size_t axis = 0; axis < place.size(); ++axis)
      place[axis] += length * direction[axis] / std::sqrt(square);
    scene.coordinates.insert(scene.coordinates.end(), place.begin(), place.end());
  }
  shuffle(scene);
  return scene;
}

Scene oblique_plane(std::size_t n)
{
  Scene scene = empty_scene("oblique plane", 3, n);
  Random random(5);
  while(scene.size() < n) {
    const double s = random.uniform(), t = random.uniform();
    for(const double x : {0.6 * s + 0.2 * t, 0.7 * t - 0.3 * s, 0.5 * s + 0.4 * t})
      scene.coordinates.push_back(x);
  }
  return scene;
}

Scene oblique_line(std::size_t n)
{
  Scene scene = empty_scene("oblique line", 3, n);
  Random random(6);
  while(scene.size() < n) {
    const double t = random.uniform();
    for(const double x : {0.6 * t, -0.3 * t, 0.7 * t})
      scene.coordinates.push_back(x);
  }
  return scene;
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
