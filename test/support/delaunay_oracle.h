// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Breadth-first search on the Delaunay triangulation of space, from each distinct point through
// the points within the radius of it. Points of the plane are points of space, on a plane.
//
// The points of a ball around a vertex are connected to it inside the ball: the segment from q to
// the centre p leaves the Voronoi cell of q into the cell of a Delaunay neighbour s of q, and p
// lies on the side of s, so s is closer to p than q is. Cospherical points, where the triangulation
// is not unique, are the limit of such a case, with "not farther" for "closer".

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DELAUNAY_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_DELAUNAY_ORACLE_H

#include "distinct_points.h"
#include "exact_points.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <iterator>
#include <utility>
#include <vector>

namespace test_support {

namespace delaunay {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
using Data_structure =
  CGAL::Triangulation_data_structure_3<Vertex_base,
                                       CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Data_structure>;
using Neighbours = std::vector<std::vector<std::size_t>>;

inline Kernel::Point_3 point_3(const Coordinates& x)
{
  return Kernel::Point_3(x[0], x[1], x.size() == 2 ? 0 : x[2]);
}

// Adjacent vertices by number. Flat scenes give triangulations of dimension 2 or 1; a single point
// gives one of dimension 0, which has no edges to ask for.
inline Neighbours neighbours(const Points& points)
{
  std::vector<std::pair<Kernel::Point_3, std::size_t>> vertices;
  for(std::size_t i = 0; i < points.size(); ++i)
    vertices.emplace_back(point_3(points[i]), i);
  const Triangulation triangulation(vertices.begin(), vertices.end());
  Neighbours result(points.size());
  if(triangulation.dimension() < 1)
    return result;
  for(auto v : triangulation.finite_vertex_handles()) {
    std::vector<Triangulation::Vertex_handle> adjacent;
    triangulation.finite_adjacent_vertices(v, std::back_inserter(adjacent));
    for(auto w : adjacent)
      result[v->info()].push_back(w->info());
  }
  return result;
}

// The vertices within the radius of `source`, itself first.
inline std::vector<std::size_t> ball_around(std::size_t source, const Neighbours& neighbours,
                                            const Exact_points& exact)
{
  std::vector<std::size_t> reached(1, source);
  std::vector<bool> is_seen(neighbours.size());
  is_seen[source] = true;
  for(std::size_t next = 0; next < reached.size(); ++next)
    for(std::size_t v : neighbours[reached[next]])
      if(!is_seen[v]) {
        is_seen[v] = true;
        if(exact.are_within_radius(source, v))
          reached.push_back(v);
      }
  return reached;
}

} // namespace delaunay

inline Pairs delaunay_pairs(const Point_scene& scene)
{
  const Distinct_points distinct(scene.points);
  const Exact_points exact(distinct.points(), scene.radius);
  const delaunay::Neighbours neighbours = delaunay::neighbours(distinct.points());
  Pairs pairs;
  for(std::size_t u = 0; u < exact.size(); ++u)
    for(std::size_t v : delaunay::ball_around(u, neighbours, exact))
      if(u <= v)
        distinct.append_pairs(u, v, pairs);
  return sorted(std::move(pairs));
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DELAUNAY_ORACLE_H
