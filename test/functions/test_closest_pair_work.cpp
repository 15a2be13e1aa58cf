// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the search for the closest pair is linear at all scales, whoever makes the input:
// looks at points are counted.

#include "support/check_closest_pair.h"
#include "support/counted_points.h"

using namespace test_support;

namespace {

// Looks per point, of the search without the scan.
template <int Dimension>
double looks_per_point(const Points& scene)
{
  using Point = typename Epick_points<Dimension>::Point;
  using Counted = Counted_points<Point>;
  const auto points = make_points<Epick_points<Dimension>>(scene);
  std::size_t looks = 0;
  const Counted counted = {points, looks};
  const internal::Scene scene_of_points = scene_of(Elements_of<Point>(points));
  internal::Unwatched_progress progress;
  closest_of_many(counted, scene_of_points, progress);
  return static_cast<double>(looks) / static_cast<double>(points.size());
}

using Make_scene = std::function<Points(int dimension, std::size_t size)>;

// Uniform points take 1.5 to 3 looks per point.
void check_work(const std::string& name, const Make_scene& make, double max_looks = 16)
{
  for(const std::size_t n : {10000, 40000}) {
    const double plane = looks_per_point<2>(make(2, n));
    const double space = looks_per_point<3>(make(3, n));
    BOOST_TEST_MESSAGE(name << ", " << n << " points: " << plane << ' ' << space);
    BOOST_CHECK_MESSAGE(plane <= max_looks, name << ", 2D: " << plane);
    BOOST_CHECK_MESSAGE(space <= max_looks, name << ", 3D: " << space);
  }
}

// Every k-th point in a box of its own at the origin, the others in [1, 2]^d.
Make_scene boxes_of_sides(const std::vector<double>& sides)
{
  return [sides](int dimension, std::size_t size) {
    Points points = uniform_points(dimension, size, 0, 1, 2);
    for(std::size_t i = 0; i < size; ++i)
      for(double& x : points[i])
        x = i % (sides.size() + 1) == 0 ? 1 + x : x * sides[i % (sides.size() + 1) - 1];
    return points;
  };
}

// Moves each coordinate, given as a number in [0, 1).
Make_scene uniform_moved(const std::function<double(double)>& move)
{
  return [move](int dimension, std::size_t size) {
    Points points = uniform_points(dimension, size, 0, 1, 3);
    for(Coordinates& c : points)
      for(double& x : c)
        x = move(x);
    return points;
  };
}

} // namespace

BOOST_AUTO_TEST_CASE(points_of_a_geometric_sequence_take_linear_work)
{
  check_work("diagonal", [](int dimension, std::size_t size) {
    Points points;
    for(std::size_t i = 0; i < size; ++i)
      points.emplace_back(dimension, std::pow(1 + 600. / static_cast<double>(size),
                                              static_cast<double>(i)));
    return points;
  });
}

BOOST_AUTO_TEST_CASE(boxes_of_any_sizes_take_linear_work)
{
  for(const double side : {1e-16, 1e-19, 1e-26, 1e-120, 1e-300})
    check_work("a box of side " + std::to_string(std::log10(side)), boxes_of_sides({side}));
  check_work("boxes of three scales", boxes_of_sides({1e-20, 1e-60}));
  check_work("a huge box", boxes_of_sides({1e300}));
}

BOOST_AUTO_TEST_CASE(coordinates_of_all_scales_take_linear_work)
{
  check_work("log-uniform", uniform_moved([](double x) { return std::pow(10, -300 * x); }));
  check_work("log-uniform of both signs", uniform_moved([](double x) {
    return x < 0.5 ? -std::pow(10, 600 - 1200 * x - 300) : std::pow(10, 1200 * x - 900);
  }));
  for(const double scale : {1e-300, 1e-170, 1e200})
    check_work("uniform", uniform_moved([scale](double x) { return x * scale; }));
  check_work("beyond the differences of doubles", uniform_moved([](double x) {
    return (2 * x - 1) * 1.7e308;
  }));
}

// All neighbors are at the same distance, or nearly so: .1 is no multiple of a power of two. Slabs
// look at points in order, once for each pass.
BOOST_AUTO_TEST_CASE(points_with_many_ties_take_linear_work)
{
  const auto lattice = [](int dimension, std::size_t size, double step) {
    const double side = std::floor(std::pow(static_cast<double>(size), 1. / dimension) + 1e-9);
    return shuffled(lattice_points(dimension, static_cast<std::size_t>(side), step), 4);
  };
  const double max_looks = 32;
  for(const double step : {1., 0.1, 1e-321, 1e250})
    check_work("lattice", [&](int dimension, std::size_t size) {
      return lattice(dimension, size, step);
    }, max_looks);
  check_work("every other point of a lattice", [&](int dimension, std::size_t size) {
    Points points;
    for(const Coordinates& c : lattice(dimension, 2 * size, 1))
      if(std::fmod(std::accumulate(c.begin(), c.end(), 0.), 2) == 0)
        points.push_back(c);
    return points;
  }, max_looks);
  check_work("a lattice and a point far out", [&](int dimension, std::size_t size) {
    Points points = lattice(dimension, size, 1);
    points[0].assign(static_cast<std::size_t>(dimension), 1e9);
    return points;
  }, max_looks);
  check_work("equal steps on a diagonal", [](int dimension, std::size_t size) {
    Points points;
    for(std::size_t i = 0; i < size; ++i)
      points.emplace_back(dimension, 0.14 + 0.0088 * (static_cast<double>(i)
                                                      / static_cast<double>(size)));
    return points;
  }, max_looks);
}

// Half of the points are equal. The others had one hash when hashes had no keys: all coordinates
// but the last are free, and the last one makes up for them.
BOOST_AUTO_TEST_CASE(points_that_are_made_for_a_hash_take_linear_work)
{
  const auto with_one_hash = [](int dimension, std::size_t size) {
    Points points = uniform_points(dimension, size, 1, 1, 5);
    Random random(6);
    for(std::size_t i = 0; i < size / 2; ++i)
      do {
        std::uint64_t hash = 0;
        for(int axis = 0; axis + 1 < dimension; ++axis) {
          points[i][axis] = 1 + random.uniform();
          hash ^= (hash >> 32) ^ internal::radix_key(points[i][axis]);
          hash *= 0x9e3779b97f4a7c15;
        }
        const std::uint64_t key = hash ^ (hash >> 32);
        const std::uint64_t sign = std::uint64_t(1) << 63;
        const std::uint64_t bits = (key & sign) != 0 ? key ^ sign : ~key;
        std::memcpy(&points[i].back(), &bits, sizeof(bits));
      } while(!(std::fabs(points[i].back()) < 1e300));
    for(std::size_t i = size / 2; i < size; ++i)
      points[i] = points[size / 2];
    return points;
  };
  check_work("made for a hash", with_one_hash);
}
