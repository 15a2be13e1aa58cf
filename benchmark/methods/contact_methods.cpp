// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "contact_methods.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/thick_intersection_d.h>

#include <memory>
#include <random>
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

// All pairs of triangles and of objects that are asked for.
template <class Object>
std::size_t count_by_tree(const Triangles& triangles, const std::vector<Object>& objects)
{
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.begin(),
                                                                   triangles.end());
  std::size_t count = 0;
  for(const Object& object : objects)
    count += tree.number_of_intersected_primitives(object);
  return count;
}

template <class Object>
std::size_t count_by_ours(const Triangles& triangles, const std::vector<Object>& objects)
{
  std::size_t count = 0;
  CGAL::thick_intersection_d(objects, triangles, [&](std::size_t, std::size_t) { ++count; });
  return count;
}

std::size_t count_by_rigid(Rigid& meshes) { return meshes.get_all_intersections(0).size(); }

// Segments between random points of the unit cube, and triangles at random places in it.
struct Rays
{
  std::vector<Kernel::Segment_3> rays;
  Triangles triangles;
};

Rays random_rays(std::size_t ray_count, std::size_t triangle_count)
{
  constexpr double size = 0.003;
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto point = [&](const Kernel::Point_3& from, double side) {
    const double x = uniform(engine), y = uniform(engine);
    return from + side * Kernel::Vector_3(x, y, uniform(engine));
  };
  Rays scene;
  for(std::size_t i = 0; i < ray_count; ++i) {
    const Kernel::Point_3 source = point(CGAL::ORIGIN, 1);
    scene.rays.emplace_back(source, point(CGAL::ORIGIN, 1));
  }
  for(std::size_t i = 0; i < triangle_count; ++i) {
    const Kernel::Point_3 corner = point(CGAL::ORIGIN, 1), second = point(corner, size);
    scene.triangles.emplace_back(corner, second, point(corner, size));
  }
  return scene;
}

} // namespace

std::vector<Counted> ways_to_any_contact(const Two_meshes& scene)
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

std::vector<Counted> ways_to_all_contacts(const Two_meshes& scene)
{
  const auto meshes = meshes_of(scene);
  const auto on_triangles = [=](const auto& count) {
    return [=] { return count(triangles_of(meshes->a), triangles_of(meshes->b)); };
  };
  return {{"thick_intersection_d", on_triangles(count_by_ours<Kernel::Triangle_3>)},
          {"AABB_tree", on_triangles(count_by_tree<Kernel::Triangle_3>)}};
}

std::vector<Counted> ways_of_rays(std::size_t ray_count, std::size_t triangle_count)
{
  const auto scene = std::make_shared<const Rays>(random_rays(ray_count, triangle_count));
  return {{"thick_intersection_d", [=] { return count_by_ours(scene->triangles, scene->rays); }},
          {"AABB_tree", [=] { return count_by_tree(scene->triangles, scene->rays); }}};
}

} // namespace thick_benchmark
