// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair, in multiples of std::sort of the x-coordinates in the same
// process: a row per promise, and the other methods. The chart has all methods for 10^3 to 10^7
// points.
//
// Points are uniform in the unit square or cube, or all the same. Methods take turns, and the least
// time of the processor counts; what takes more than a second is measured once.

#include "goal.h"
#include "print.h"
#include "table.h"

#include "measuring/speed_up.h"
#include "measuring/timing.h"
#include "methods/closest_pair_algorithms.h"
#include "methods/delaunay.h"
#include "methods/kd_tree.h"
#include "methods/Method.h"
#include "scenes/generators.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace thick_benchmark {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A way to an answer, and the answer that is expected of it: the squared distance of the closest
// pair, or whether there is a close one.
struct Entry
{
  std::string name;
  Goal goal; // in times of the sort
  double expected;
  Run<double> run;
  double seconds = std::numeric_limits<double>::infinity(); // the least so far
};

void measure(Entry& entry)
{
  double result = 0;
  const double seconds = processor_seconds_of([&] { result = entry.run(); });
  if(result != entry.expected)
    throw std::runtime_error(entry.name + ": " + std::to_string(result) + " instead of "
                             + std::to_string(entry.expected));
  entry.seconds = std::min(entry.seconds, seconds);
}

template <int Dimension>
class Entries
{
  using Point = Point_t<Kernel, Dimension>;

public:
  explicit Entries(const Scene& scene)
    : scene_(scene), points_(make_points<Kernel, Dimension>(scene)), algorithms_(points_),
      least_(square_of(CGAL::closest_pair(points_))),
      below_(CGAL::within_squared_distance(0.99 * least_).open())
  {}
  Entries(const Entries&) = delete; // the entries refer to it

  // What is promised, after the sort.
  std::vector<Entry> promised() const
  {
    // A cell of this side has 0.2 points on average, so some of them have five or more.
    const auto heavy = CGAL::within_distance(
      std::pow(0.2 / static_cast<double>(points_.size()), 1. / Dimension));
    return {{"std::sort of x", {}, 0, sort_of_x<double>(scene_)},
            {"closest_pair", at_most(Dimension == 2 ? 0.5 : 0.8), least_,
             [this] { return square_of(CGAL::closest_pair(points_)); }},
            {"has_close_pair, no", at_most(Dimension == 2 ? 0.35 : 0.6), 0,
             [this] { return CGAL::has_close_pair(points_, below_); }},
            {"has_close_pair, yes", at_most(0.15), 1,
             [this, heavy] { return CGAL::has_close_pair(points_, heavy); }}};
  }

  // The algorithms of [L], and the rivals. For distinct points.
  std::vector<Entry> others() const
  {
    std::vector<Entry> entries
      = {{"divide and conquer", {}, least_,
          [this] { return square_of(algorithms_.by_division()); }}};
    if(points_.size() > 1000000)
      return entries;
    entries.push_back({"grid of cells r, no", {}, 0,
                       [this] { return algorithms_.has_pair_in_cells(below_); }});
    entries.push_back({"Delaunay", {}, least_,
                       [this] { return delaunay_closest<Kernel>(points_); }});
    entries.push_back({"Kd_tree", {}, least_,
                       [this] { return kd_tree_closest<Kernel>(points_); }});
    return entries;
  }

private:
  template <class Positions>
  double square_of(const Positions& pair) const
  {
    return CGAL::squared_distance(points_[pair.first], points_[pair.second]);
  }

  const Scene& scene_;
  const std::vector<Point> points_;
  const Closest_pair_algorithms<Dimension, Point> algorithms_;
  const double least_; // the squared distance of the closest pair
  const CGAL::Distance_bound<double> below_; // no pair is within it
};

// ---- the tables ---------------------------------------------------------------------------------

Scene uniform_scene(int dimension, std::size_t n)
{
  return uniform(dimension, n, static_cast<double>(n) / 2);
}

void take_turns(std::vector<Entry>& entries, int rounds)
{
  for(int round = 0; round < rounds; ++round)
    for(Entry& entry : entries)
      if(round == 0 || entry.seconds <= 1)
        measure(entry);
}

// Measures what is promised, and the other methods if wanted. What is returned has been run, and
// cannot be run again.
template <int Dimension>
std::vector<Entry> measured(const Scene& scene, bool with_others, int rounds)
{
  const Entries<Dimension> all(scene);
  std::vector<Entry> entries = all.promised();
  if(with_others)
    for(const Entry& entry : all.others())
      entries.push_back(entry);
  take_turns(entries, rounds);
  return entries;
}

// Returns the seconds of the sort, which are the unit unless another one is given: equal numbers
// are sorted in no time.
template <int Dimension>
double print_rows(const Scene& scene, bool with_others,
                  std::optional<double> unit = std::nullopt)
{
  const std::vector<Entry> entries = measured<Dimension>(scene, with_others, 5);
  const double sort = unit.value_or(entries.front().seconds);
  for(const Entry& entry : entries)
    print_line(scene.name, scene.size(), entry.name, fixed(1000 * entry.seconds, 1),
               figure(entry.seconds / sort), target_of(entry.goal),
               verdict(entry.seconds / sort, entry.goal));
  return sort;
}

#ifdef CGAL_LINKED_WITH_TBB

// function(tag) is measured for both tags of concurrency.
template <class Function>
void print_speed_up(const std::string& name, const Scene& scene, const Function& function)
{
  const auto sequential = [&] { function(CGAL::Sequential_tag()); };
  const auto parallel = [&] { function(CGAL::Parallel_tag()); };
  const Speed_up speed_up = measure_speed_up(sequential, parallel, sequential);
  print_line(scene.name, scene.size(), name, fixed(speed_up.milliseconds, 1),
             fixed(speed_up.of_search, 2), fixed(speed_up.of_machine, 2));
}

template <int Dimension>
void print_speed_ups(std::size_t n)
{
  const Two_threads two_threads;
  const Scene scene = uniform_scene(Dimension, n);
  const auto points = make_points<Kernel, Dimension>(scene);
  const auto [i, j] = CGAL::closest_pair(points);
  const auto below
    = CGAL::within_squared_distance(CGAL::squared_distance(points[i], points[j])).open();
  print_speed_up("closest_pair", scene,
                 [&](auto tag) { CGAL::closest_pair<decltype(tag)>(points); });
  print_speed_up("has_close_pair, no", scene,
                 [&](auto tag) { CGAL::has_close_pair<decltype(tag)>(points, below); });
}

#endif // CGAL_LINKED_WITH_TBB

template <int Dimension>
void print_rows_of_dimension(bool is_quick)
{
  const std::size_t n = is_quick ? 1000 : 1000000;
  print_rows<Dimension>(uniform_scene(Dimension, n), true);
  const double sort = print_rows<Dimension>(uniform_scene(Dimension, 10 * n), false);
  print_rows<Dimension>(identical(Dimension, 10 * n), false, sort);
}

void print_both_tables(bool is_quick)
{
  print_head({"scene", ">n", "method", ">ms", ">time / std::sort", ">target", "verdict"});
  print_rows_of_dimension<2>(is_quick);
  print_rows_of_dimension<3>(is_quick);
#ifdef CGAL_LINKED_WITH_TBB
  const std::size_t n = is_quick ? 10000 : 1000000;
  std::cout << '\n';
  print_head({"scene", ">n", "method", ">ms of 2 threads", ">speed-up", ">machine"});
  print_speed_ups<2>(n);
  print_speed_ups<3>(n);
#endif
}

template <int Dimension>
void print_chart(std::size_t n)
{
  const Scene scene = uniform_scene(Dimension, n);
  for(const Entry& entry : measured<Dimension>(scene, true, n <= 100000 ? 7 : 3))
    std::cout << Dimension << ',' << n << ",\"" << entry.name << "\"," << entry.seconds << '\n';
}

void print_charts(bool is_quick)
{
  std::cout << "dimension,n,method,seconds\n";
  for(std::size_t n = 1000; n <= (is_quick ? 10000 : 10000000); n *= 10) {
    print_chart<2>(n);
    print_chart<3>(n);
  }
}

} // namespace

void print_table(const Settings& settings)
{
  settings.is_chart ? print_charts(settings.is_quick) : print_both_tables(settings.is_quick);
}

} // namespace thick_benchmark
