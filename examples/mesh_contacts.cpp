// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Faces of one mesh that meet faces of another. A property map makes the triangles when the search
// asks for them, so the meshes are not copied.
//
//   mesh_contacts [FILE OF A TRIANGLE MESH]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h> // under the GPL, unlike the package
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/thick_intersection_d.h>

#include <iostream>
#include <set>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A face, and the mesh that it is of.
using Face = std::pair<const Mesh*, Mesh::Face_index>;

struct Triangle_map
{
  using key_type = Face;
  using value_type = Kernel::Triangle_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  friend value_type get(Triangle_map, const Face& face)
  {
    const Mesh& mesh = *face.first;
    const auto edge = mesh.halfedge(face.second);
    return {mesh.point(mesh.source(edge)), mesh.point(mesh.target(edge)),
            mesh.point(mesh.target(mesh.next(edge)))};
  }
};

// The faces that have a triangle: do_intersect() does not take three points on a line.
std::vector<Face> faces_of(const Mesh& mesh)
{
  std::vector<Face> faces;
  for(const Mesh::Face_index face : mesh.faces())
    if(!get(Triangle_map(), Face(&mesh, face)).is_degenerate())
      faces.emplace_back(&mesh, face);
  return faces;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/spot.obj", mesh)
     || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "There is no triangle mesh in the file.\n";
    return 1;
  }
  Mesh other = mesh;
  for(Kernel::Point_3& p : other.points())
    p = p + Kernel::Vector_3(0.5, 0, 0);

  const std::vector<Face> faces = faces_of(mesh), other_faces = faces_of(other);
  std::set<Mesh::Face_index> touched;
  CGAL::thick_intersection_d(
    faces, other_faces,
    CGAL::with_elements([&](const Face& face, const Face&) { touched.insert(face.second); }),
    CGAL::parameters::point_map(Triangle_map()));
  std::cout << touched.size() << " of " << faces.size() << " faces meet the other mesh\n";
}
