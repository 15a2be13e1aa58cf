// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What else there is for objects with radii, open objects and solids: separating axes in doubles,
// Boolean sets and Polygon_mesh_processing of CGAL, GEOS and FCL.

#include "predicate_columns.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#ifdef THICK_BENCHMARK_HAS_GEOS
#include <geos_c.h>
#endif
#ifdef THICK_BENCHMARK_HAS_FCL
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#endif

#include <algorithm>
#include <array>
#include <memory>

namespace lab {
namespace {

bool knows_open(const Kind& kind) { return kind.meaning == Meaning::OPEN; }
bool knows_open_triangles(const Kind& kind) { return knows_open(kind) && kind.dimension == 2; }
bool knows_solids(const Kind& kind) { return kind.meaning == Meaning::SOLID; }

// ---- separating axes, in doubles ----------------------------------------------------------------

using Vector = test_support::Hull_vector<double>;
using Vectors = test_support::Hull_vectors<double>;

Vectors vertices_of(const Object_set& set, std::size_t i)
{
  Vectors vertices(static_cast<std::size_t>(set.kind.vertices));
  const double* x = set.object(i);
  for(Vector& vertex : vertices)
    for(std::size_t axis = 0; axis < static_cast<std::size_t>(set.kind.dimension); ++axis)
      vertex[axis] = *x++;
  return vertices;
}

bool is_separating(const Vector& axis, const Vectors& a, const Vectors& b)
{
  const auto ends = [&](const Vectors& vertices) {
    std::array<double, 2> ends = {dot(axis, vertices[0]), dot(axis, vertices[0])};
    for(const Vector& vertex : vertices)
      ends = {std::min(ends[0], dot(axis, vertex)), std::max(ends[1], dot(axis, vertex))};
    return ends;
  };
  const auto of_a = ends(a), of_b = ends(b);
  return !test_support::is_null(axis) && (of_a[1] <= of_b[0] || of_b[1] <= of_a[0]);
}

Vectors edges_of(const Vectors& vertices)
{
  Vectors edges;
  for(std::size_t k = 0; k < vertices.size(); ++k)
    for(std::size_t l = 0; l < k; ++l)
      edges.push_back(difference(vertices[k], vertices[l]));
  return edges;
}

// Normals of edges in the plane; of two edges, of one object or both, in space.
bool do_overlap_by_axes(const Vectors& a, const Vectors& b, int dimension)
{
  Vectors edges = edges_of(a);
  for(const Vector& edge : edges_of(b))
    edges.push_back(edge);
  for(std::size_t k = 0; k < edges.size(); ++k) {
    if(dimension == 2 && is_separating(cross(edges[k], Vector{0, 0, 1}), a, b))
      return false;
    for(std::size_t l = 0; dimension == 3 && l < k; ++l)
      if(is_separating(cross(edges[k], edges[l]), a, b))
        return false;
  }
  return true;
}

Answers ask_axes(const Object_questions& questions, double milliseconds)
{
  std::vector<Vectors> objects;
  for(std::size_t i = 0; i < questions.objects.size(); ++i)
    objects.push_back(vertices_of(questions.objects, i));
  return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
    return do_overlap_by_axes(objects[i], objects[j], questions.objects.kind.dimension);
  });
}

// ---- CGAL ---------------------------------------------------------------------------------------

Answers ask_boolean_sets(const Object_questions& questions, double milliseconds)
{
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  std::vector<CGAL::Polygon_2<Epeck>> polygons;
  for(const auto& t : objects_of<Epeck>(Triangles_2(), questions.objects)) {
    const Epeck::Point_2 vertices[] = {t[0], t[1], t[2]};
    polygons.emplace_back(vertices, vertices + 3);
    if(polygons.back().is_clockwise_oriented())
      polygons.back().reverse_orientation();
  }
  return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
    return CGAL::do_intersect(polygons[i], polygons[j]);
  });
}

Answers ask_pmp(const Object_questions& questions, double milliseconds)
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<CGAL::Surface_mesh<Epick::Point_3>> meshes(questions.objects.size());
  const auto tetrahedra = objects_of<Epick>(Tetrahedra_3(), questions.objects);
  for(std::size_t i = 0; i < meshes.size(); ++i) {
    const auto& t = tetrahedra[i];
    CGAL::make_tetrahedron(t[0], t[1], t[2], t[3], meshes[i]);
  }
  const auto with_insides = CGAL::parameters::do_overlap_test_of_bounded_sides(true);
  return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
    return CGAL::Polygon_mesh_processing::do_intersect(meshes[i], meshes[j], with_insides,
                                                       with_insides);
  });
}

// ---- GEOS ---------------------------------------------------------------------------------------

#ifdef THICK_BENCHMARK_HAS_GEOS
Answers ask_geos(const Object_questions& questions, double milliseconds)
{
  const std::unique_ptr<GEOSContextHandle_HS, void (*)(GEOSContextHandle_t)> geos(
    GEOS_init_r(), GEOS_finish_r);
  const auto destroy
    = [&](GEOSGeometry* polygon) { GEOSGeom_destroy_r(geos.get(), polygon); };
  std::vector<std::unique_ptr<GEOSGeometry, decltype(destroy)>> polygons;
  for(std::size_t i = 0; i < questions.objects.size(); ++i) {
    const double* const x = questions.objects.object(i);
    GEOSCoordSequence* const points = GEOSCoordSeq_create_r(geos.get(), 4, 2);
    for(unsigned int k = 0; k < 4; ++k)
      GEOSCoordSeq_setXY_r(geos.get(), points, k, x[2 * (k % 3)], x[2 * (k % 3) + 1]);
    polygons.emplace_back(
      GEOSGeom_createPolygon_r(geos.get(), GEOSGeom_createLinearRing_r(geos.get(), points),
                               nullptr, 0),
      destroy);
  }
  return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
    const char answer
      = GEOSRelatePattern_r(geos.get(), polygons[i].get(), polygons[j].get(), "T********");
    return answer > 1 ? UNDECIDED : answer == 1 ? YES : NO; // 2 is an exception
  });
}
#endif

// ---- FCL ----------------------------------------------------------------------------------------

#ifdef THICK_BENCHMARK_HAS_FCL
using Fcl_objects = std::vector<fcl::CollisionObjectd>;

Answers ask_fcl(const Object_questions& questions, double milliseconds, const Fcl_objects& objects)
{
  return answers_to(questions, milliseconds, [&](std::size_t i, std::size_t j) {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(&objects[i], &objects[j], request, result) != 0;
  });
}

fcl::Vector3d fcl_vector(const Vector& p) { return {p[0], p[1], p[2]}; }

// A capsule of FCL is around the third axis, and is moved.
Answers ask_fcl_capsules(const Object_questions& questions, double milliseconds)
{
  const Object_set& set = questions.objects;
  Fcl_objects objects;
  for(std::size_t i = 0; i < set.size(); ++i) {
    const Vectors ends = vertices_of(set, i);
    const fcl::Vector3d p = fcl_vector(ends[0]), q = fcl_vector(ends[1]);
    fcl::Transform3d place = fcl::Transform3d::Identity();
    place.translate((p + q) / 2);
    place.rotate(fcl::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), q - p));
    objects.emplace_back(std::make_shared<fcl::Capsuled>(set.radius(i), (q - p).norm()), place);
  }
  return ask_fcl(questions, milliseconds, objects);
}

Answers ask_fcl_meshes(const Object_questions& questions, double milliseconds)
{
  using Tree = fcl::BVHModel<fcl::AABB<double>>;
  Fcl_objects objects;
  for(std::size_t i = 0; i < questions.objects.size(); ++i) {
    std::vector<fcl::Vector3d> points;
    for(const Vector& p : vertices_of(questions.objects, i))
      points.push_back(fcl_vector(p));
    const auto tree = std::make_shared<Tree>();
    tree->beginModel(4, 4);
    tree->addSubModel(points, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
    tree->endModel();
    objects.emplace_back(tree);
  }
  return ask_fcl(questions, milliseconds, objects);
}
#endif

} // namespace

Predicate_columns thick_rivals()
{
  return {
    {"separating axes, double", "form", knows_open, ask_axes},
    {"Boolean sets, EPECK", "kernel", knows_open_triangles, ask_boolean_sets},
    {"Polygon_mesh_processing", "kernel", knows_solids, ask_pmp},
#ifdef THICK_BENCHMARK_HAS_GEOS
    {"GEOS, relate", "library", knows_open_triangles, ask_geos},
#endif
#ifdef THICK_BENCHMARK_HAS_FCL
    {"FCL, capsules", "library",
     [](const Kind& kind) { return kind.meaning == Meaning::THICK && kind.dimension == 3; },
     ask_fcl_capsules},
    {"FCL, meshes", "library", knows_solids, ask_fcl_meshes},
#endif
  };
}

} // namespace lab
