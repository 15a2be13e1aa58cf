// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Self-intersections of a mesh, as CGAL::Polygon_mesh_processing::self_intersections() finds them.
// Rounded coordinates, as in compressed files, bring some into a mesh that has none.
//
//   mesh_self_intersections [FILE OF A TRIANGLE MESH]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h> // under the GPL, unlike the package
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/thick_mesh_self_intersections.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

void print_self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Face, Face>> pairs;
  CGAL::thick_mesh_self_intersections(mesh, std::back_inserter(pairs));
  std::size_t degenerate = 0; // such a face is a pair with itself
  for(const auto& [f, g] : pairs)
    degenerate += f == g;
  std::cout << mesh.number_of_faces() << " faces, " << degenerate << " degenerate, "
            << pairs.size() - degenerate << " pairs intersect\n";
}

double rounded(double x)
{
  return std::round(x * 128) / 128;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/spot.obj", mesh)
     || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "There is no triangle mesh in the file.\n";
    return 1;
  }
  print_self_intersections(mesh);
  for(Kernel::Point_3& p : mesh.points())
    p = Kernel::Point_3(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  print_self_intersections(mesh);
}
