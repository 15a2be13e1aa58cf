// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Search in Delaunay triangulations of points in space, where CGAL has no range search: from each
// vertex breadth first through those within r, which are connected to it inside their ball. [L]

#include "columns.h"

#include "support/kernels.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

namespace lab {
namespace {

// With the square of r as the number type of the kernel has it.
template <class Kernel>
Found find_by_delaunay(const Point_scene& scene)
{
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
  using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
  using Triangulation
    = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
  using Vertex_handle = typename Triangulation::Vertex_handle;

  std::vector<std::pair<typename Kernel::Point_3, std::size_t>> vertices;
  for(const auto& p :
      test_support::make_points<test_support::Cartesian_points<Kernel, 3>>(scene.points))
    vertices.emplace_back(p, vertices.size());
  const typename Kernel::FT r(length_of(scene.radius));
  const typename Kernel::FT square = r * r;
  return timed(true, [&](Pairs& pairs) {
    const Triangulation triangulation(vertices.begin(), vertices.end()); // equal points become one
    std::vector<Vertex_handle> near, adjacent;
    std::vector<std::size_t> last_centre(vertices.size(), vertices.size());
    for(const Vertex_handle centre : triangulation.finite_vertex_handles()) {
      last_centre[centre->info()] = centre->info();
      near.assign(1, centre);
      for(std::size_t next = 0; next < near.size(); ++next) {
        adjacent.clear();
        triangulation.finite_adjacent_vertices(near[next], std::back_inserter(adjacent));
        for(const Vertex_handle v : adjacent)
          if(std::exchange(last_centre[v->info()], centre->info()) != centre->info()
             && CGAL::compare_squared_distance(centre->point(), v->point(), square)
                  != CGAL::LARGER) {
            near.push_back(v);
            pairs.emplace_back(centre->info(), v->info());
          }
      }
    }
  });
}

} // namespace

std::vector<Method> delaunay_methods_3()
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  return {{"Delaunay EPICK", "library", find_by_delaunay<Epick>},
          {"Delaunay EPECK", "library", find_by_delaunay<Epeck>}};
}

} // namespace lab
