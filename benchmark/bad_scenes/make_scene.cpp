// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/Work.h"
#include "support/point_generators.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace thick_benchmark {
namespace {

using Positions = std::vector<std::size_t>;
using test_support::Random;

// A change as it applies to one axis of the boxes at some positions.
struct Task
{
  std::vector<Made_box>& boxes;
  const Positions& positions;
  std::size_t axis;
  double a, b;
  Random& random;

  double& low(std::size_t i) const { return boxes[positions[i]].low[axis]; }
  double& extent(std::size_t i) const { return boxes[positions[i]].extent[axis]; }

  // Sets coordinates to function(coordinate, index).
  template <class Function>
  void set(const Function& function) const
  {
    for(std::size_t i = 0; i < positions.size(); ++i)
      low(i) = function(low(i), i);
  }
};

// Equally likely numbers below 1 that depend on two indices alone.
double hashed(std::size_t i, std::size_t axis)
{
  return Random(static_cast<unsigned int>(7919 * i + axis)).uniform();
}

std::size_t number_of(double a)
{
  return a >= 1 ? static_cast<std::size_t>((std::min)(a, 1e6)) : 1;
}

void sort_boxes(const Task& t)
{
  std::vector<Made_box> sorted;
  for(const std::size_t i : t.positions)
    sorted.push_back(t.boxes[i]);
  std::sort(sorted.begin(), sorted.end(), [&](const Made_box& p, const Made_box& q) {
    return p.low[t.axis] < q.low[t.axis];
  });
  for(std::size_t i = 0; i < sorted.size(); ++i)
    t.boxes[t.positions[i]] = sorted[i];
}

void set_spans(const Task& t)
{
  for(std::size_t i = 0; i < t.positions.size(); ++i) {
    const std::pair<double, double> ends = std::minmax({t.random.uniform(), t.random.uniform()});
    t.low(i) = t.a + ends.first * t.b;
    t.extent(i) = (ends.second - ends.first) * std::fabs(t.b);
  }
}

struct Kind
{
  std::string name;
  void (*apply)(const Task&);
};

// Kinds that place single coordinates.
std::vector<Kind> placing_kinds()
{
  return {
    // anew between a and a + b
    {"place", [](const Task& t) {
       t.set([&](double, std::size_t) { return t.a + t.b * t.random.uniform(); });
     }},
    // a decades below b, as many in each
    {"log", [](const Task& t) {
       t.set([&](double, std::size_t) { return t.b * std::pow(10, -t.a * t.random.uniform()); });
     }},
    // b (1 + a)^i
    {"nested", [](const Task& t) {
       t.set([&](double, std::size_t i) { return t.b * std::pow(1 + t.a, i); });
     }},
    // equal steps from a to a + b, in order
    {"steps", [](const Task& t) {
       const double count = static_cast<double>(t.positions.size());
       t.set([&](double, std::size_t i) { return t.a + t.b * static_cast<double>(i) / count; });
     }}};
}

// Kinds that move coordinates to others.
std::vector<Kind> moving_kinds()
{
  return {
    // from [0, 1] to [a, a + b]
    {"squeeze", [](const Task& t) { t.set([&](double x, std::size_t) { return t.a + t.b * x; }); }},
    // multiples of 1/a, and a share b of what is lost
    {"bands", [](const Task& t) {
       t.set([&](double x, std::size_t) {
         const double whole = std::floor(t.a * x);
         return (whole + t.b * (t.a * x - whole)) / t.a;
       });
     }},
    // a clusters, b times as large as the scene
    {"clusters", [](const Task& t) {
       const std::size_t count = number_of(t.a);
       t.set([&](double x, std::size_t i) { return hashed(i % count, t.axis) + t.b * x; });
     }},
    // the coordinates of the first a of them, again and again
    {"copy", [](const Task& t) {
       const std::size_t count = number_of(t.a);
       t.set([&](double, std::size_t i) { return t.low(i % count); });
     }},
    // a + b times the coordinate along the axis before
    {"follow", [](const Task& t) {
       const std::size_t other = t.axis == 0 ? 1 : t.axis - 1;
       t.set([&](double, std::size_t i) {
         return t.a + t.b * t.boxes[t.positions[i]].low[other];
       });
     }}};
}

// Kinds that set extents.
std::vector<Kind> extent_kinds()
{
  return {
    // between a and a + b
    {"extent", [](const Task& t) {
       for(std::size_t i = 0; i < t.positions.size(); ++i)
         t.extent(i) = std::fabs(t.a + t.b * t.random.uniform());
     }},
    // at least a, larger than e with probability (a / e)^(1/b)
    {"law", [](const Task& t) {
       for(std::size_t i = 0; i < t.positions.size(); ++i)
         t.extent(i)
           = (std::min)(1., std::fabs(t.a) * std::pow(t.random.uniform() + 1e-12, -std::fabs(t.b)));
     }},
    // between two random places of [a, a + b]
    {"span", set_spans}};
}

const std::vector<Kind>& kinds()
{
  static const std::vector<Kind> kinds = [] {
    std::vector<Kind> all = {{"sort", sort_boxes}};
    for(const auto& some : {placing_kinds(), moving_kinds(), extent_kinds()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return kinds;
}

// Whether a sample of 512 of n elements, at equal steps, looks at element i.
bool is_sampled(std::size_t i, std::size_t n)
{
  const std::size_t step = (i * 512 + n - 1) / n;
  return step * n / 512 == i;
}

struct Place_of_change
{
  std::string name;
  bool (*holds)(std::size_t i, std::size_t n, double share, Random& random);
};

const std::vector<Place_of_change>& places()
{
  using Size = std::size_t;
  static const std::vector<Place_of_change> places = {
    {"all", [](Size, Size, double, Random&) { return true; }},
    {"first", [](Size i, Size n, double share, Random&) {
       return static_cast<double>(i) < share * static_cast<double>(n);
     }},
    {"last", [](Size i, Size n, double share, Random&) {
       return static_cast<double>(i) >= (1 - share) * static_cast<double>(n);
     }},
    {"random", [](Size, Size, double share, Random& random) { return random.uniform() < share; }},
    {"every", [](Size i, Size, double share, Random&) { // of 1/share
       return i % (std::max)(Size(1), static_cast<Size>(1 / share)) == 0;
     }},
    {"others", [](Size i, Size, double share, Random&) { // than every
       return i % (std::max)(Size(1), static_cast<Size>(1 / share)) != 0;
     }},
    {"sampled", [](Size i, Size n, double, Random&) { return is_sampled(i, n); }},
    {"unseen", [](Size i, Size n, double, Random&) { return !is_sampled(i, n); }},
    {"one", [](Size i, Size n, double share, Random&) {
       return i == (std::min)(static_cast<Size>(share * static_cast<double>(n)), n - 1);
     }}};
  return places;
}

template <class Named>
const Named& find(const std::vector<Named>& all, const std::string& name)
{
  for(const Named& one : all)
    if(one.name == name)
      return one;
  throw std::invalid_argument("No change has the name or place " + name);
}

void apply(const Change& change, Made_scene& scene, Random& random)
{
  const std::size_t n = scene.boxes.size();
  const Place_of_change& place = find(places(), change.where);
  Positions positions;
  for(std::size_t i = 0; i < n; ++i)
    if(place.holds(i, n, change.share, random))
      positions.push_back(i);
  const double a = change.a.at(static_cast<double>(n), scene.reach);
  const double b = change.b.at(static_cast<double>(n), scene.reach);
  for(int axis = 0; axis < scene.dimension; ++axis)
    if(change.axis == axis || change.axis == scene.dimension)
      find(kinds(), change.kind).apply(
        {scene.boxes, positions, static_cast<std::size_t>(axis), a, b, random});
}

} // namespace

Made_scene make_scene(const Recipe& recipe, int dimension)
{
  const double n = static_cast<double>(recipe.n);
  Made_scene scene{dimension, std::vector<Made_box>(recipe.n), recipe.reach.at(n, 1),
                   static_cast<std::size_t>(n * recipe.first_share)};
  Random random(recipe.seed);
  for(Made_box& box : scene.boxes)
    for(int axis = 0; axis < dimension; ++axis) {
      box.low[static_cast<std::size_t>(axis)] = random.uniform();
      box.extent[static_cast<std::size_t>(axis)] = scene.reach;
    }
  for(const Change& change : recipe.changes)
    apply(change, scene, random);
  return scene;
}

} // namespace thick_benchmark
