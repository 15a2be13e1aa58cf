// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "Contestant.h"

#include "methods/all_pairs.h"
#include "methods/box_intersection.h"
#include "methods/kd_tree.h"
#include "methods/nanoflann.h"
#include "methods/ours.h"
#include "methods/recursive_route.h"
#include "methods/rtree.h"
#include "methods/sort_of_x.h"
#ifdef THICK_BENCHMARK_HAS_ANN
#include "methods/ann.h"
#endif

namespace thick_benchmark {

namespace {

// search(points, r, tally) on points of EPICK.
template <class Search>
auto on_epick(const Search& search)
{
  return on_points<Tally, Epick>(search);
}

template <class Points>
using Traits_of = CGAL::Thick_point_traits_d<typename Points::value_type>;

auto by_recursive_route(Pivot pivot, Base_case base_case)
{
  return on_epick([=](const auto& points, double r, Tally& tally) {
    const Traits_of<std::decay_t<decltype(points)>> traits(CGAL::within_distance(r));
    recursive_route(points, traits, {pivot, base_case, 0}, tally);
  });
}

} // namespace

void add_ours(Contestants& all)
{
  const std::size_t any = 100000000;
  const auto epick = [](const Scene& scene) { return search_epick(scene).sequential; };
  const auto epeck = [](const Scene& scene) { return search_epeck(scene).sequential; };
  all.push_back({{"Thick_intersection_d", epick}, Precision::EXACT, any});
#ifdef CGAL_LINKED_WITH_TBB
  const auto parallel = [](const Scene& scene) { return search_epick(scene).parallel; };
  all.push_back({{"Thick_intersection_d, 2 threads", parallel}, Precision::EXACT, any});
#endif
  all.push_back({{"Thick_intersection_d, EPECK", epeck}, Precision::EXACT, 1000000, true});
  all.push_back({{"std::sort of x", sort_of_x<Tally>}, Precision::NONE, any});
  const auto by_all_pairs = on_epick([](const auto& points, double r, Tally& tally) {
    all_pairs(points.size(), is_near_exactly(points, r), tally);
  });
  all.push_back({{"all pairs", by_all_pairs}, Precision::EXACT, 10000});
}

void add_recursive_routes(Contestants& all)
{
  const auto add_variant = [&](const std::string& name, const auto& prepare) {
    all.push_back({{"[V03], " + name, prepare}, Precision::EXACT, 1000000, true});
  };
  all.push_back({{"[V03]", by_recursive_route(Pivot::MEDIAN, Base_case::SWEEP)}, Precision::EXACT,
                 10000000});
  add_variant("walk", by_recursive_route(Pivot::MEDIAN, Base_case::WALK));
  add_variant("dimension 0", by_recursive_route(Pivot::MEDIAN, Base_case::DIMENSION_ZERO));
  add_variant("random pivot", by_recursive_route(Pivot::RANDOM, Base_case::SWEEP));
  add_variant("random pivot, walk", by_recursive_route(Pivot::RANDOM, Base_case::WALK));
  add_variant("random pivot, dimension 0",
              by_recursive_route(Pivot::RANDOM, Base_case::DIMENSION_ZERO));
  add_variant("reach 2D", on_epick([](const auto& points, double r, Tally& tally) {
                using Point = typename std::decay_t<decltype(points)>::value_type;
                recursive_route(points, Literal_reach_traits<Point>(r), Recursion_options(), tally);
              }));
}

void add_boxes(Contestants& all)
{
  for(const std::ptrdiff_t cutoff : {10, 30, 100, 300, 1000}) {
    const std::string name = "box_self_intersection_d, cutoff " + std::to_string(cutoff);
    const auto sequential = on_epick([=](const auto& points, double r, Tally& tally) {
      box_intersection<CGAL::Sequential_tag>(boxes_around(points, r, outwards),
                                             is_near_exactly(points, r), tally, cutoff);
    });
    all.push_back({{name, sequential}, Precision::EXACT, cutoff == 300 ? 10000000u : 1000000u});
#ifdef CGAL_LINKED_WITH_TBB
    const auto parallel = on_epick([=](const auto& points, double r, Tally& tally) {
      const Parallel_tally sum;
      box_intersection<CGAL::Parallel_tag>(boxes_around(points, r, outwards),
                                           is_near_exactly(points, r), sum, cutoff);
      tally = sum.sum();
    });
    all.push_back({{name + ", 2 threads", parallel}, Precision::EXACT, 1000000, true});
#endif
  }
}

void add_trees(Contestants& all)
{
  const auto kd_tree = on_epick([](const auto& points, double r, Tally& tally) {
    kd_tree_search<Epick>(points, r, tally);
  });
  all.push_back({{"Kd_tree + Fuzzy_sphere", kd_tree}, Precision::ROUNDED, 1000000});
  const auto rtree = on_epick([](const auto& points, double r, Tally& tally) {
    const auto is_near = is_near_exactly(points, r);
    rtree_search(points, r, outwards, [&](const auto& a, const auto& b) {
      if(a.second < b.second && is_near(a.second, b.second))
        tally(a.second, b.second);
    });
  });
  all.push_back({{"Boost.Geometry rtree", rtree}, Precision::EXACT, 1000000});
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
  const auto nanoflann = on_epick([](const auto& points, double r, Tally& tally) {
    nanoflann_search(points, nanoflann_closed(r), tally);
  });
  all.push_back({{"nanoflann", nanoflann}, Precision::ROUNDED, 10000000});
#endif
#ifdef THICK_BENCHMARK_HAS_ANN
  const auto ann = on_epick([](const auto& points, double r, Tally& tally) {
    ann_search(points, r, tally);
  });
  all.push_back({{"ANN", ann}, Precision::ROUNDED, 1000000, true});
#endif
}

} // namespace thick_benchmark
