// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Vertices of a mesh that are close to each other, before and after some of them are removed. By
// with_elements(), the search hands over the vertices themselves. Their positions in the range are
// their numbers only as long as nothing is removed.
//
//   mesh_vertices [FILE OF A MESH]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h> // under the GPL, unlike the package
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Vertex_pairs = std::vector<std::pair<Vertex, Vertex>>;

Vertex_pairs find_close_vertices(const Mesh& mesh)
{
  Vertex_pairs pairs;
  CGAL::fixed_radius_near_neighbors(
    mesh.vertices(), CGAL::within_distance(0.01), CGAL::with_elements(std::back_inserter(pairs)),
    CGAL::parameters::point_map(mesh.points()));
  std::cout << pairs.size() << " close pairs of " << mesh.number_of_vertices() << " vertices\n";
  return pairs;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/spot.obj", mesh)) {
    std::cerr << "There is no mesh in the file.\n";
    return 1;
  }
  const Vertex_pairs close = find_close_vertices(mesh);
  for(std::size_t i = 0; i < close.size() / 2; ++i)
    if(const Vertex v = close[i].first; !mesh.is_removed(v))
      CGAL::Euler::remove_center_vertex(mesh.halfedge(v), mesh); // leaves a larger face

  const Vertex_pairs left = find_close_vertices(mesh);
  const bool are_there = std::none_of(left.begin(), left.end(), [&](const auto& pair) {
    return mesh.is_removed(pair.first) || mesh.is_removed(pair.second);
  });
  std::cout << (are_there ? "all of them are there\n" : "some of them are removed\n");
}
