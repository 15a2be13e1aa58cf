// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Self-intersections of a mesh: pairs of faces that intersect and have no vertex in common. Rounded
// coordinates, as in compressed files, bring some into a mesh that has none.
//
//   mesh_self_intersections [FILE OF A TRIANGLE MESH]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h> // under the GPL, unlike the package
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/thick_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;
using Vertices = std::array<Mesh::Vertex_index, 3>;

Vertices vertices_of(const Mesh& mesh, Face face)
{
  const auto edge = mesh.halfedge(face);
  return {mesh.source(edge), mesh.target(edge), mesh.target(mesh.next(edge))};
}

// A property map: the triangles are made when the search asks for them.
struct Triangle_map
{
  using key_type = Face;
  using value_type = Kernel::Triangle_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Mesh& mesh;

  friend value_type get(const Triangle_map& map, Face face)
  {
    const Vertices v = vertices_of(map.mesh, face);
    return {map.mesh.point(v[0]), map.mesh.point(v[1]), map.mesh.point(v[2])};
  }
};

bool have_common_vertex(const Vertices& a, const Vertices& b)
{
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

void print_self_intersections(const Mesh& mesh)
{
  const Triangle_map triangle_of = {mesh};
  std::vector<Face> faces;
  for(const Face face : mesh.faces())
    if(!get(triangle_of, face).is_degenerate()) // do_intersect() does not take these
      faces.push_back(face);
  std::size_t count = 0;
  const auto report = [&](std::size_t i, std::size_t j) {
    count += !have_common_vertex(vertices_of(mesh, faces[i]), vertices_of(mesh, faces[j]));
  };
  CGAL::thick_self_intersection_d(faces, report, CGAL::parameters::point_map(triangle_of));
  std::cout << faces.size() << " faces, " << count << " pairs intersect\n";
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
