// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MESH_FACES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MESH_FACES_H

// The faces of a triangle mesh: of a model of the concepts of the BGL of CGAL, whose functions are
// found in its namespace, or of a pair of points and triples of their indices.

#include <CGAL/boost/graph/properties.h>

#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Calls take(p) for each point, even if no face has it.
template <class Mesh, class Take>
BOOST_FORCEINLINE void for_each_point(const Mesh& mesh, const Take& take)
{
  const auto points = get(boost::vertex_point, mesh);
  const auto range = vertices(mesh);
  for(auto vertex = range.first; vertex != range.second; ++vertex)
    take(get(points, *vertex));
}
template <class Points, class Triples, class Take>
BOOST_FORCEINLINE void for_each_point(const std::pair<Points, Triples>& soup, const Take& take)
{
  for(const auto& point : soup.first)
    take(point);
}

// Prefetches the first hundred points of a feature, as a mesh of CGAL has them one behind another.
template <class Feature>
void prefetch_points(const Feature& feature)
{
  if constexpr(graph_has_property<Feature, boost::vertex_point_t>::value) {
    const auto points = get(boost::vertex_point, feature);
    const auto range = vertices(feature);
    if constexpr(std::is_lvalue_reference_v<decltype(get(points, *range.first))>)
      if(range.first != range.second)
        for(std::size_t line = 0; line < 2400 / cache_line_size; ++line)
          prefetch_to_read(&get(points, *range.first), line);
  }
}

// Calls take(p, q, r) for the points of each face. `feature` is the position of the mesh, for
// errors.
template <class Mesh, class Take>
void for_each_face(const Mesh& mesh, std::size_t feature, const Take& take)
{
  const auto points = get(boost::vertex_point, mesh);
  std::size_t position = 0;
  const auto range = faces(mesh);
  for(auto face = range.first; face != range.second; ++face) {
    const auto first = halfedge(*face, mesh);
    const auto second = next(first, mesh);
    const auto third = next(second, mesh);
    if(next(third, mesh) != first)
      throw_wrong_face(position, feature, " is no triangle.");
    take(get(points, target(first, mesh)), get(points, target(second, mesh)),
         get(points, target(third, mesh)));
    ++position;
  }
}

// Returns the indices of a triple, each less than `count`.
template <class Triple>
std::array<std::size_t, 3> read_triple(const Triple& triple, std::size_t count,
                                       std::size_t face, std::size_t feature)
{
  std::array<std::size_t, 3> indices;
  auto index = std::begin(triple);
  for(std::size_t k = 0; k < 3; ++k, ++index) {
    if(!(index != std::end(triple)))
      throw_wrong_face(face, feature, " is no triangle.");
    indices[k] = static_cast<std::size_t>(*index);
    if(indices[k] >= count)
      throw_wrong_face(face, feature, " has an index beyond the points.");
  }
  if(index != std::end(triple))
    throw_wrong_face(face, feature, " is no triangle.");
  return indices;
}

template <class Points, class Triples, class Take>
void for_each_face(const std::pair<Points, Triples>& soup, std::size_t feature, const Take& take)
{
  const Numbered_elements<const Points> points(soup.first);
  std::size_t position = 0;
  for(const auto& triple : soup.second) {
    const auto [p, q, r] = read_triple(triple, points.size(), position, feature);
    take(points[p], points[q], points[r]);
    ++position;
  }
}

// Throws if a face is no triangle, or has a coordinate that is NaN or infinite.
template <class Mesh>
void check_faces(const Mesh& mesh, std::size_t feature)
{
  std::size_t face = 0;
  for_each_face(mesh, feature, [&](const auto& p, const auto& q, const auto& r) {
    check_face(face++, feature, p, q, r);
  });
}

// Whether a mesh is known to have no borders and no faces but triangles: if there are three
// halfedges for each face, because no face of a valid mesh has less.
template <class Mesh>
bool is_closed_by_count(const Mesh& mesh)
{
  const auto all_faces = faces(mesh);
  const auto all_edges = halfedges(mesh);
  return std::distance(all_edges.first, all_edges.second)
         == 3 * std::distance(all_faces.first, all_faces.second);
}
template <class Points, class Triples>
bool is_closed_by_count(const std::pair<Points, Triples>&)
{
  return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_MESH_FACES_H
