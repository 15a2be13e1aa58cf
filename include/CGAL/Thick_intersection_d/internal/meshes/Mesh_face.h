// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_FACE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_FACE_H

// A face of a triangle mesh, and what two faces have in common. A mesh is a model of the concepts
// of the BGL of CGAL; its functions are found in its namespace.

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Mesh>
struct Mesh_face
{
  typename boost::graph_traits<Mesh>::face_descriptor face;
  std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3> vertices;
};

// Throws if the face is no triangle.
template <class Mesh>
Mesh_face<Mesh> read_mesh_face(typename boost::graph_traits<Mesh>::face_descriptor face,
                               const Mesh& mesh, std::size_t position)
{
  const auto first = halfedge(face, mesh);
  const auto second = next(first, mesh);
  const auto third = next(second, mesh);
  if(next(third, mesh) != first)
    throw std::invalid_argument("Face " + std::to_string(position) + " is no triangle.");
  return {face, {target(first, mesh), target(second, mesh), target(third, mesh)}};
}

// The vertices that two faces have in common: how many, and where the last of them is in each.
struct Common_vertices
{
  int count = 0;
  std::size_t place_in_first = 0;
  std::size_t place_in_second = 0;
};

// No branch depends on what is common, because most pairs that a search asks about are neighbors of
// different kinds.
template <class Mesh>
Common_vertices common_vertices(const Mesh_face<Mesh>& a, const Mesh_face<Mesh>& b)
{
  Common_vertices common;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j) {
      const bool is_common = a.vertices[i] == b.vertices[j];
      common.count += is_common;
      common.place_in_first = is_common ? i : common.place_in_first;
      common.place_in_second = is_common ? j : common.place_in_second;
    }
  return common;
}

// Returns the halfedge of `a` whose opposite belongs to `b`, if there is one. Two faces with two
// common vertices have none if two edges join these vertices.
template <class Mesh>
auto find_common_edge(const Mesh_face<Mesh>& a, const Mesh_face<Mesh>& b, const Mesh& mesh)
{
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  Halfedge edge = halfedge(a.face, mesh);
  for(int i = 0; i < 3; ++i) {
    if(face(opposite(edge, mesh), mesh) == b.face)
      return std::optional<Halfedge>(edge);
    edge = next(edge, mesh);
  }
  return std::optional<Halfedge>();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_FACE_H
