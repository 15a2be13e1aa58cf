// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The ways to the closest pair of a scene and to a close one, ready to be run.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_CLOSEST_PAIR_ENTRIES_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_CLOSEST_PAIR_ENTRIES_H

#include "measuring/timing.h"
#include "methods/closest_pair_algorithms.h"
#include "methods/delaunay.h"
#include "methods/kd_tree.h"
#include "methods/nanoflann.h"
#include "methods/sort_of_x.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace thick_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A way to an answer, and the answer that is expected of it: the squared distance of the closest
// pair, or whether there is a close one.
struct Entry
{
  std::string name;
  double target; // in times of the sort; 0: none
  double expected;
  Run<double> run;
  double seconds = std::numeric_limits<double>::infinity(); // the least so far
};

inline void measure(Entry& entry)
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
    return {{"std::sort of x", 0, 0, sort_of_x<double>(scene_)},
            {"closest_pair", Dimension == 2 ? 0.5 : 0.8, least_,
             [this] { return square_of(CGAL::closest_pair(points_)); }},
            {"has_close_pair, no", Dimension == 2 ? 0.35 : 0.6, 0,
             [this] { return CGAL::has_close_pair(points_, below_); }},
            {"has_close_pair, yes", 0.15, 1,
             [this, heavy] { return CGAL::has_close_pair(points_, heavy); }}};
  }

  // The algorithms of [L] and the randomised one, and the rivals. For distinct points.
  std::vector<Entry> others() const
  {
    std::vector<Entry> entries
      = {{"divide and conquer", 0, least_, [this] { return square_of(algorithms_.by_division()); }},
         {"incremental grid", 0, least_,
          [this] { return square_of(algorithms_.by_incremental_cells()); }}};
    if(points_.size() > 1000000)
      return entries;
    entries.push_back({"grid of cells r, hashing, no", 0, 0,
                       [this] { return algorithms_.has_pair_in_cells(below_, true); }});
    entries.push_back({"grid of cells r, order, no", 0, 0,
                       [this] { return algorithms_.has_pair_in_cells(below_, false); }});
    entries.push_back({"Delaunay", 0, least_,
                       [this] { return delaunay_closest<Kernel>(points_); }});
    entries.push_back({"Kd_tree", 0, least_,
                       [this] { return kd_tree_closest<Kernel>(points_); }});
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
    entries.push_back({"nanoflann", 0, least_, [this] { return nanoflann_closest(points_); }});
#endif
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

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_CLOSEST_PAIR_ENTRIES_H
