// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair and a close pair, in multiples of std::sort of the x-coordinates in the same
// process: a row per promise, and the other methods. The chart has all methods for 10^3 to 10^7
// points.
//
// Points are uniform in the unit square or cube, or all the same. Methods take turns, and the least
// time of the processor counts; what takes more than a second is measured once.

#include "closest_pair_entries.h"
#include "print.h"
#include "table.h"

#include "measuring/speed_up.h"
#include "scenes/generators.h"

#include <iostream>
#include <optional>

namespace thick_benchmark {
namespace {

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
               fixed(entry.seconds / sort, 2),
               entry.target == 0 ? "" : "<= " + fixed(entry.target, 2),
               entry.target == 0 ? "" : entry.seconds <= entry.target * sort ? "met" : "missed");
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
