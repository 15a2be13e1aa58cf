// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "contact_methods.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <CGAL/thick_intersection_d.h>

#include <memory>
#include <vector>

namespace thick_benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Rigid = CGAL::Rigid_triangle_mesh_collision_detection<Mesh>;

struct Meshes
{
  Mesh a, b;
};

Mesh mesh_of(const Mesh_scene& scene)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for(const auto& p : scene.points)
    vertices.push_back(mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2])));
  for(const auto& face : scene.faces)
    mesh.add_face(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
  return mesh;
}

std::shared_ptr<const Meshes> meshes_of(const Two_meshes& scene)
{
  return std::make_shared<const Meshes>(Meshes{mesh_of(scene.a), mesh_of(scene.b)});
}

Triangles triangles_of(const Mesh& mesh)
{
  Triangles triangles;
  triangles.reserve(mesh.number_of_faces());
  for(const auto face : mesh.faces()) {
    const auto h = mesh.halfedge(face);
    triangles.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                           mesh.point(mesh.target(mesh.next(h))));
  }
  return triangles;
}

std::size_t count_by_tree(const Triangles& a, const Triangles& b)
{
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(a.begin(), a.end());
  std::size_t count = 0;
  for(const Kernel::Triangle_3& triangle : b)
    count += tree.number_of_intersected_primitives(triangle);
  return count;
}

std::size_t count_by_boxes(const Triangles& a, const Triangles& b)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, const Kernel::Triangle_3*>;
  const auto boxes_of = [](const Triangles& triangles) {
    std::vector<Box> boxes;
    for(const Kernel::Triangle_3& triangle : triangles)
      boxes.emplace_back(triangle.bbox(), &triangle);
    return boxes;
  };
  std::vector<Box> boxes_a = boxes_of(a), boxes_b = boxes_of(b);
  std::size_t count = 0;
  const auto report = [&](const Box& s, const Box& t) {
    count += CGAL::do_intersect(*s.info(), *t.info());
  };
  CGAL::box_intersection_d(boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(), report,
                           std::ptrdiff_t(1000));
  return count;
}

std::size_t count_by_rigid(Rigid& meshes) { return meshes.get_all_intersections(0).size(); }

} // namespace

std::vector<Contact_method> ways_to_any_contact(const Two_meshes& scene)
{
  const auto meshes = meshes_of(scene);
  const auto built = std::make_shared<Rigid>();
  built->add_mesh(meshes->a);
  built->add_mesh(meshes->b);
  return {{"thick_intersection_d, first pair",
           [=] {
             std::size_t count = 0;
             CGAL::thick_intersection_d(triangles_of(meshes->a), triangles_of(meshes->b),
                                        [&](std::size_t, std::size_t) {
                                          count = 1;
                                          return false;
                                        });
             return count;
           }},
          {"PMP::do_intersect",
           [=] {
             namespace PMP = CGAL::Polygon_mesh_processing;
             return std::size_t(PMP::do_intersect(meshes->a, meshes->b));
           }},
          {"Rigid_..., built and asked",
           [=] {
             Rigid rigid;
             rigid.add_mesh(meshes->a);
             rigid.add_mesh(meshes->b);
             return count_by_rigid(rigid);
           }},
          {"Rigid_..., asked", [=] { return count_by_rigid(*built); }}};
}

std::vector<Contact_method> ways_to_all_contacts(const Two_meshes& scene)
{
  const auto meshes = meshes_of(scene);
  const auto on_triangles = [=](const auto& count) {
    return [=] { return count(triangles_of(meshes->a), triangles_of(meshes->b)); };
  };
  return {{"thick_intersection_d", on_triangles([](const Triangles& a, const Triangles& b) {
             std::size_t count = 0;
             CGAL::thick_intersection_d(a, b, [&](std::size_t, std::size_t) { ++count; });
             return count;
           })},
          {"AABB_tree", on_triangles(count_by_tree)},
          {"box_intersection_d, cutoff 1000", on_triangles(count_by_boxes)}};
}

} // namespace thick_benchmark
