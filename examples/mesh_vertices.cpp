// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Vertices of a mesh that are close to each other, before and after some of them are removed. The
// callback gets positions in the range of vertices. As long as nothing was removed, they are the
// numbers of the vertices. After that, a vector of vertices tells which vertex is where.
//
//   mesh_vertices [FILE OF A MESH]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h> // under the GPL, unlike the package
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <algorithm>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/spot.obj", mesh)) {
    std::cerr << "There is no mesh in the file.\n";
    return 1;
  }
  const auto bound = CGAL::within_distance(0.01);
  const auto np = CGAL::parameters::point_map(mesh.points());

  std::vector<Vertex> close; // in each pair of close vertices, the one with the lower number
  CGAL::fixed_radius_near_neighbors(
    mesh.vertices(), bound, [&](std::size_t i, std::size_t) { close.emplace_back(i); }, np);
  std::cout << close.size() << " close pairs of " << mesh.number_of_vertices() << " vertices\n";

  for(std::size_t i = 0; i < close.size(); i += 2)
    if(!mesh.is_removed(close[i]))
      CGAL::Euler::remove_center_vertex(mesh.halfedge(close[i]), mesh); // leaves a larger face
  const std::vector<Vertex> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::size_t count = 0;
  Vertex last(0);
  CGAL::fixed_radius_near_neighbors(
    vertices, bound,
    [&](std::size_t i, std::size_t j) {
      ++count;
      last = (std::max)({last, vertices[i], vertices[j]});
    },
    np);
  std::cout << count << " close pairs of " << vertices.size() << " vertices, up to " << last
            << '\n';
}
