// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points in four dimensions and more, in Epick_d with the dimension known to the compiler.

#include "box_intersection.h"
#include "object_methods.h"

#include <CGAL/Epick_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <stdexcept>

namespace thick_benchmark {

namespace {

template <int Dimension>
using Point_d = typename CGAL::Epick_d<CGAL::Dimension_tag<Dimension>>::Point_d;

template <int Dimension, class Search>
Run<Tally> run_in_dimension(const Scene& scene, const Search& search)
{
  std::vector<Point_d<Dimension>> points;
  for(std::size_t i = 0; i < scene.size(); ++i)
    points.emplace_back(scene.point(i), scene.point(i) + Dimension);
  return [points, search, r = scene.r] {
    Tally tally;
    search(points, r, tally);
    return tally;
  };
}

// Of search(points, r, tally).
template <class Search>
Run<Tally> run_on_points_d(const Scene& scene, const Search& search)
{
  switch(scene.dimension) {
  case 4: return run_in_dimension<4>(scene, search);
  case 5: return run_in_dimension<5>(scene, search);
  case 6: return run_in_dimension<6>(scene, search);
  case 8: return run_in_dimension<8>(scene, search);
  default: throw std::invalid_argument("points of a dimension that is not measured");
  }
}

} // namespace

Search search_points_d(const Scene& scene)
{
  Search search;
  search.sequential = run_on_points_d(scene, [](const auto& points, double r, Tally& tally) {
    CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(r), tally);
  });
  return search;
}

Method<Tally> boxes_of_points_d(std::ptrdiff_t cutoff)
{
  return {"boxes, cutoff " + std::to_string(cutoff), [=](const Scene& scene) {
            return run_on_points_d(scene, [=](const auto& points, double r, Tally& tally) {
              box_intersection<CGAL::Sequential_tag>(boxes_around(points, r, outwards),
                                                     is_near_exactly(points, r), tally, cutoff);
            });
          }};
}

} // namespace thick_benchmark
