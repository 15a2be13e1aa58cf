// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The methods that are compared. Those that take long to compile have a file of their own.

#ifndef THICK_INTERSECTION_BENCHMARK_COMPARE_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_COMPARE_METHODS_H

#include "../support/Scene.h"
#include "../support/Tally.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace thick_benchmark {

using Run = std::function<Tally()>;

enum class Answer {
  EXACT,   // must be ours
  ROUNDED, // may differ from ours, and tells by how much
  NONE     // is no search
};

struct Method
{
  std::string name;
  Answer answer;
  std::size_t largest_n; // more points would take minutes
  bool is_variant;       // measured on the scenes of time against n only
  std::function<Run(const Scene&)> prepare;
};

using Methods = std::vector<Method>;

void add_ours(Methods& methods);
void add_book_variants(Methods& methods);
void add_box_intersection(Methods& methods);
void add_delaunay_epick(Methods& methods);
void add_delaunay_epeck(Methods& methods);
void add_kd_tree(Methods& methods);
void add_nanoflann(Methods& methods);
void add_rtree(Methods& methods);
void add_ann(Methods& methods);

// ---- to make them -------------------------------------------------------------------------------

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Kernel, int Dimension, class Search>
Run run_on_points(const Scene& scene, const Search& search)
{
  using Points = std::vector<Point_t<Kernel, Dimension>>;
  const auto points = std::make_shared<const Points>(make_points<Kernel, Dimension>(scene));
  return [points, search, r = scene.r] {
    Tally tally;
    search(*points, r, tally);
    return tally;
  };
}

// search(points, r, callback), on the points of a kernel.
template <class Kernel = Epick, class Search>
std::function<Run(const Scene&)> on_points(const Search& search)
{
  return [search](const Scene& scene) {
    return scene.dimension == 2 ? run_on_points<Kernel, 2>(scene, search)
                                : run_on_points<Kernel, 3>(scene, search);
  };
}

#ifdef CGAL_LINKED_WITH_TBB
// The same for a search that calls its callback from several threads.
template <class Search>
std::function<Run(const Scene&)> on_points_in_parallel(const Search& search)
{
  const auto with_own_tally = [search](const auto& points, double r, Tally& tally) {
    const Parallel_tally sum;
    search(points, r, sum);
    tally = sum.sum();
  };
  return on_points<Epick>(with_own_tally);
}
#endif

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_COMPARE_METHODS_H
