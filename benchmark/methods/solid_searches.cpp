// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "solid_methods.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <memory>
#include <stdexcept>
#include <vector>

namespace thick_benchmark {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Meshes = std::vector<Mesh>;

std::shared_ptr<const Meshes> meshes_of(const Solid_scene& scene)
{
  const auto meshes = std::make_shared<Meshes>();
  for(const Mesh_scene& solid : scene.solids) {
    Mesh& mesh = meshes->emplace_back();
    std::vector<Mesh::Vertex_index> vertices;
    for(const auto& p : solid.points)
      vertices.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
    for(const auto& face : solid.faces)
      if(mesh.add_face(vertices[face[0]], vertices[face[1]], vertices[face[2]])
         == Mesh::null_face())
        throw std::logic_error(scene.name + " has a solid that is no mesh");
  }
  return meshes;
}

} // namespace

Solid_method solids_ours()
{
  return {"thick_feature_self_intersection_d", [](const Solid_scene& scene) {
            return [meshes = meshes_of(scene)] {
              std::size_t pairs = 0;
              CGAL::thick_feature_self_intersection_d(
                *meshes, [&](std::size_t, std::size_t) { ++pairs; });
              return pairs;
            };
          }};
}

Solid_method boxes_of_faces()
{
  return {"boxes of faces alone", [](const Solid_scene& scene) {
            std::vector<CGAL::Bbox_3> boxes;
            const auto meshes = meshes_of(scene);
            for(const Mesh& mesh : *meshes)
              for(const Mesh::Face_index face : mesh.faces())
                boxes.push_back(CGAL::Polygon_mesh_processing::face_bbox(face, mesh));
            return [boxes = std::make_shared<const std::vector<CGAL::Bbox_3>>(std::move(boxes))] {
              std::size_t pairs = 0;
              CGAL::thick_self_intersection_d(*boxes,
                                              [&](std::size_t, std::size_t) { ++pairs; });
              return pairs;
            };
          }};
}

Solid_method solids_by_pmp()
{
  return {"PMP::intersecting_meshes", [](const Solid_scene& scene) {
            return [meshes = meshes_of(scene)] {
              std::size_t pairs = 0;
              CGAL::Polygon_mesh_processing::intersecting_meshes(
                *meshes, boost::make_function_output_iterator([&](const auto&) { ++pairs; }),
                CGAL::parameters::do_overlap_test_of_bounded_sides(true));
              return pairs;
            };
          }};
}

} // namespace thick_benchmark
