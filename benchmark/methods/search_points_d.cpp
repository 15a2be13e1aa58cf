// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points in four dimensions and more, in Epick_d. The boxes that box intersection gets are of a
// dimension that the compiler knows, whether it knows that of the points or not.

#include "box_intersection.h"
#include "object_methods.h"

#include <CGAL/Epick_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <stdexcept>
#include <type_traits>

namespace thick_benchmark {

namespace {

// Of search(points, r, tally, dimension), where the dimension is an integral constant.
template <class Tag, int Dimension, class Search>
Run<Tally> run_in_dimension(const Scene& scene, const Search& search)
{
  std::vector<typename CGAL::Epick_d<Tag>::Point_d> points;
  for(std::size_t i = 0; i < scene.size(); ++i)
    points.emplace_back(scene.point(i), scene.point(i) + Dimension);
  return [points, search, r = scene.r] {
    Tally tally;
    search(points, r, tally, std::integral_constant<int, Dimension>());
    return tally;
  };
}

template <int Dimension, class Search>
Run<Tally> run_in_dimension(const Scene& scene, Dimension_kind kind, const Search& search)
{
  using Static = CGAL::Dimension_tag<Dimension>;
  return kind == Dimension_kind::STATIC
           ? run_in_dimension<Static, Dimension>(scene, search)
           : run_in_dimension<CGAL::Dynamic_dimension_tag, Dimension>(scene, search);
}

template <class Search>
Run<Tally> run_on_points_d(const Scene& scene, Dimension_kind kind, const Search& search)
{
  switch(scene.dimension) {
  case 4: return run_in_dimension<4>(scene, kind, search);
  case 5: return run_in_dimension<5>(scene, kind, search);
  case 6: return run_in_dimension<6>(scene, kind, search);
  case 8: return run_in_dimension<8>(scene, kind, search);
  default: throw std::invalid_argument("points of a dimension that is not measured");
  }
}

} // namespace

Search search_points_d(const Scene& scene, Dimension_kind kind)
{
  Search search;
  search.sequential
    = run_on_points_d(scene, kind, [](const auto& points, double r, Tally& tally, auto) {
        CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(r), tally);
      });
  return search;
}

Method<Tally> boxes_of_points_d(std::ptrdiff_t cutoff, Dimension_kind kind)
{
  const auto search = [=](const auto& points, double r, Tally& tally, auto dimension) {
    box_intersection<CGAL::Sequential_tag>(boxes_around<dimension()>(points, r, outwards),
                                           is_near_exactly(points, r, dimension()), tally,
                                           cutoff);
  };
  return {"boxes, cutoff " + std::to_string(cutoff),
          [=](const Scene& scene) { return run_on_points_d(scene, kind, search); }};
}

} // namespace thick_benchmark
