// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "track_generators.h"

#include "support/point_generators.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace thick_benchmark {

namespace {

using test_support::Random;
using Place = std::array<double, 3>;

constexpr double day = 1440;

// Calls f(axis) for the coordinates of a place; others are zero.
template <class Function>
Place place_of(int dimension, const Function& f)
{
  Place place = {};
  for(int axis = 0; axis < dimension; ++axis)
    place[static_cast<std::size_t>(axis)] = f(static_cast<std::size_t>(axis));
  return place;
}

// The side of a square or cube with one of n points, on average.
double side_of_each(int dimension, std::size_t n)
{
  return std::pow(static_cast<double>(n), -1. / dimension);
}

// A leg that begins anywhere and goes up to a length along each axis.
Track leg(int dimension, double begin, double duration, double length, Random& random)
{
  const Place from = place_of(dimension, [&](std::size_t) { return random.uniform(); });
  const Place to = place_of(dimension, [&](std::size_t axis) {
    return from[axis] + length * (2 * random.uniform() - 1);
  });
  return {{begin, from}, {begin + duration, to}};
}

// Legs at times of their own, each of which shares the scene with about n / 96 others.
Track_scene legs_of_day(const std::string& name, int dimension, std::size_t n, double length,
                        double bound)
{
  const double side = side_of_each(dimension, n / 96 + 1);
  Track_scene scene = {name, dimension, {}, bound * side};
  Random random(n);
  for(std::size_t i = 0; i < n; ++i) {
    const double begin = day * random.uniform(), duration = 5 + 20 * random.uniform();
    scene.tracks.push_back(leg(dimension, begin, duration, length * side, random));
  }
  return scene;
}

} // namespace

std::size_t Track_scene::leg_count() const
{
  std::size_t count = 0;
  for(const Track& track : tracks)
    count += track.size() - 1;
  return count;
}

Track_scene short_legs(int dimension, std::size_t n, bool have_common_times)
{
  const bool is_plane = dimension == 2;
  if(!have_common_times)
    return legs_of_day("times of their own", dimension, n, 1, is_plane ? .44 : .5);
  const double side = side_of_each(dimension, n);
  Track_scene scene = {"common times", dimension, {}, (is_plane ? .56 : .53) * side};
  Random random(n);
  for(std::size_t i = 0; i < n; ++i)
    scene.tracks.push_back(leg(dimension, 0, 10, side, random));
  return scene;
}

Track_scene standing(int dimension, std::size_t n)
{
  return legs_of_day("standing still", dimension, n, 0, dimension == 2 ? .55 : .6);
}

Track_scene crossing_legs(int dimension, std::size_t n)
{
  Track_scene scene = {"crossing all", dimension, {}, 1 / static_cast<double>(n)};
  if(dimension == 3)
    scene.r = .65 * std::sqrt(scene.r);
  Random random(n);
  const auto anywhere
    = [&] { return place_of(dimension, [&](std::size_t) { return random.uniform(); }); };
  for(std::size_t i = 0; i < n; ++i)
    scene.tracks.push_back({{0, anywhere()}, {60, anywhere()}});
  return scene;
}

Track_scene one_long_track(std::size_t n)
{
  Track_scene scene = short_legs(2, 2 * n, false);
  scene.name = "one long track";
  Random random(n);
  const double step = .2 * side_of_each(2, n);
  Place place = {.5, .5};
  Track track;
  for(std::size_t i = 0; i < n; ++i) {
    track.push_back({day * static_cast<double>(i) / static_cast<double>(n), place});
    for(std::size_t axis = 0; axis < 2; ++axis)
      place[axis] = std::fabs(std::fmod(place[axis] + step * (2 * random.uniform() - 1), 1));
  }
  scene.tracks.push_back(track);
  return scene;
}

// A flight ends where a minute is missing.
Track_scene aircraft(const std::string& csv_file)
{
  constexpr double mile = 1852, bound = 5 * mile, degree = 60 * mile; // meters
  const double shrinking = std::cos(46.8 / 180 * 3.14159265358979); // of degrees of longitude
  std::ifstream in(csv_file);
  std::string line;
  if(!std::getline(in, line))
    throw std::runtime_error("cannot read " + csv_file);
  std::map<int, Track> flights;
  Track_scene scene = {"aircraft", 3, {}, bound};
  while(std::getline(in, line)) {
    double second, latitude, longitude, feet;
    int id;
    char comma;
    std::istringstream(line) >> second >> comma >> id >> comma >> latitude >> comma >> longitude
      >> comma >> feet;
    Track& track = flights[id];
    if(!track.empty() && track.back().time + 1 < second / 60)
      scene.tracks.push_back(std::exchange(track, {}));
    track.push_back(
      {second / 60, {degree * shrinking * longitude, degree * latitude, bound / 1000 * feet}});
  }
  for(const auto& [id, track] : flights)
    scene.tracks.push_back(track);
  const auto is_short = [](const Track& track) { return track.size() < 2; };
  scene.tracks.erase(std::remove_if(scene.tracks.begin(), scene.tracks.end(), is_short),
                     scene.tracks.end());
  return scene;
}

} // namespace thick_benchmark
