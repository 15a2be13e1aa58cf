// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Calls on few elements in the plane: their processor time, and over that of a double loop on plain
// doubles or of box_self_intersection_d(). Figures are medians of 7 rounds, each over many random
// scenes.

#include "print.h"
#include "table.h"

#include "measuring/timing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace thick_benchmark {
namespace {

using Point = CGAL::Epick::Point_2;
using Box = CGAL::Box_intersection_d::Box_d<double, 2>;

volatile std::size_t sink; // so that no search is left out

struct Scene
{
  std::vector<Point> points;
  std::vector<Box> boxes;
  double r; // n/2 pairs are near
};

std::vector<Scene> scenes_of(std::size_t size)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Scene> scenes((std::max)(std::size_t(8), 2000 / size));
  for(Scene& scene : scenes) {
    const double n = static_cast<double>(size);
    scene.r = std::sqrt(1 / (3.14159 * (n - 1)));
    for(std::size_t i = 0; i < size; ++i) {
      double low[] = {uniform(random), uniform(random)};
      double high[] = {low[0] + scene.r / 2, low[1] + scene.r / 2};
      scene.points.emplace_back(low[0], low[1]);
      scene.boxes.emplace_back(low, high);
    }
  }
  return scenes;
}

double square(const Point& p, const Point& q)
{
  const double x = p.x() - q.x(), y = p.y() - q.y();
  return x * x + y * y;
}

void near_by_loop(Scene& scene)
{
  std::size_t sum = 0;
  for(std::size_t i = 0; i < scene.points.size(); ++i)
    for(std::size_t j = i + 1; j < scene.points.size(); ++j)
      if(square(scene.points[i], scene.points[j]) <= scene.r * scene.r)
        sum += i ^ j;
  sink = sum;
}

void near(Scene& scene)
{
  std::size_t sum = 0;
  CGAL::fixed_radius_near_neighbors(scene.points, CGAL::within_distance(scene.r),
                                    [&](std::size_t i, std::size_t j) { sum += i ^ j; });
  sink = sum;
}

void closest_by_loop(Scene& scene)
{
  double least = 4;
  std::size_t closest = 0;
  for(std::size_t i = 0; i < scene.points.size(); ++i)
    for(std::size_t j = i + 1; j < scene.points.size(); ++j)
      if(const double s = square(scene.points[i], scene.points[j]); s < least) {
        least = s;
        closest = i ^ j;
      }
  sink = closest;
}

void closest(Scene& scene)
{
  const auto [i, j] = CGAL::closest_pair(scene.points);
  sink = i ^ j;
}

void boxes_by_cgal(Scene& scene)
{
  std::size_t sum = 0;
  CGAL::box_self_intersection_d(scene.boxes.begin(), scene.boxes.end(),
                                [&](const Box& a, const Box& b) { sum += a.id() ^ b.id(); });
  sink = sum;
}

void boxes(Scene& scene)
{
  std::size_t sum = 0;
  CGAL::thick_box_self_intersection_d(
    scene.boxes.begin(), scene.boxes.end(),
    [&](const Box& a, const Box& b) { sum += a.id() ^ b.id(); });
  sink = sum;
}

// The nanoseconds of a call.
double time_of(void (*search)(Scene&), std::vector<Scene>& scenes)
{
  const std::size_t repetitions = 1 + 2000 / scenes[0].points.size();
  const double seconds = processor_seconds_of([&] {
    for(std::size_t i = 0; i < repetitions; ++i)
      for(Scene& scene : scenes)
        search(scene);
  });
  return 1e9 * seconds / static_cast<double>(repetitions * scenes.size());
}

void print_row(std::size_t size)
{
  using Search = void (*)(Scene&);
  const std::array<std::array<Search, 2>, 3> searches
    = {{{near, near_by_loop}, {closest, closest_by_loop}, {boxes, boxes_by_cgal}}};
  std::vector<Scene> scenes = scenes_of(size);
  std::vector<std::string> cells;
  for(const auto& [ours, other] : searches) {
    const std::vector<Seconds> times
      = time_in_turns({[&, search = ours] { return time_of(search, scenes); },
                       [&, search = other] { return time_of(search, scenes); }}, 7, 0);
    cells.push_back(fixed(median(times, [](const Seconds& s) { return s[0]; }), 0));
    cells.push_back(fixed(median(times, [](const Seconds& s) { return s[0] / s[1]; }), 2));
  }
  print_line(size, cells[0], cells[1], cells[2], cells[3], cells[4], cells[5]);
}

} // namespace

void print_table(const Settings&)
{
  print_head({">n", ">near pairs, ns", ">/ loop", ">closest pair, ns", ">/ loop", ">boxes, ns",
              ">/ CGAL"});
  for(const std::size_t size : {2, 3, 4, 6, 8, 12, 16, 32, 64, 100, 128, 200})
    print_row(size);
}

} // namespace thick_benchmark
