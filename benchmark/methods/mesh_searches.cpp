// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "object_methods.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/thick_intersection_d.h>
#include <CGAL/thick_mesh_self_intersections.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <memory>
#include <stdexcept>
#include <vector>

namespace thick_benchmark {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

Mesh mesh_of(const Mesh_scene& scene)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for(const auto& p : scene.points)
    vertices.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
  for(const auto& face : scene.faces)
    if(mesh.add_face(vertices[face[0]], vertices[face[1]], vertices[face[2]]) == Mesh::null_face())
      throw std::logic_error(scene.name + " is no mesh");
  return mesh;
}

std::vector<CGAL::Bbox_3> boxes_of(const Mesh& mesh)
{
  std::vector<CGAL::Bbox_3> boxes;
  for(const Mesh::Face_index face : mesh.faces())
    boxes.push_back(CGAL::Polygon_mesh_processing::face_bbox(face, mesh));
  return boxes;
}

// Takes pairs of faces.
auto output_to(Tally& tally)
{
  return boost::make_function_output_iterator([&](const auto& pair) {
    tally(std::size_t(pair.first), std::size_t(pair.second));
  });
}

} // namespace

Mesh_searches mesh_searches(const Mesh_scene& scene)
{
  const auto mesh = std::make_shared<const Mesh>(mesh_of(scene));
  const auto boxes = std::make_shared<const std::vector<CGAL::Bbox_3>>(boxes_of(*mesh));
  Mesh_searches searches;
  searches.ours = [=] {
    Tally tally;
    CGAL::thick_mesh_self_intersections(*mesh, output_to(tally));
    return tally;
  };
  searches.as_in_pmp = [=] {
    Tally tally;
    CGAL::Polygon_mesh_processing::self_intersections(*mesh, output_to(tally));
    return tally;
  };
  searches.boxes_that_meet = [=] {
    Tally tally;
    CGAL::thick_self_intersection_d(*boxes, tally);
    return tally;
  };
  return searches;
}

} // namespace thick_benchmark
