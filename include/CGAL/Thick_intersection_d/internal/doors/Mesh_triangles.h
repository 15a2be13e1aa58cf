// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_MESH_TRIANGLES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_MESH_TRIANGLES_H

// Faces of a triangle mesh, as the box route reads them. Two faces intersect if they have more in
// common than the vertex or edge that they share.

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions_3.h>

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Mesh_face.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_triangles_intersect.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Mesh, class Point_map>
class Mesh_triangles
{
public:
  using Face = Mesh_face<Mesh>;
  using Faces = std::vector<Face>;
  static constexpr int static_dimension = 3;

  Mesh_triangles(const Mesh& mesh, const Point_map& point_map) : mesh_(mesh), point_map_(point_map)
  {}

  // Reads the faces. Throws if one of them is no triangle, or has a box that is not finite.
  template <class Face_range>
  void read(const Face_range& faces)
  {
    for(const auto& face : faces) {
      faces_.push_back(read_mesh_face<Mesh>(face, mesh_, faces_.size()));
      for(const auto& vertex : faces_.back().vertices)
        check_box(vertex, faces_.size() - 1);
    }
  }

  // Calls take(face) for the faces whose vertices are on a line, and forgets them. Stops when it
  // returns false.
  template <class Function>
  void remove_degenerate(const Function& take)
  {
    auto end = faces_.begin();
    for(const Face& face : faces_)
      if(!is_degenerate(face))
        *end++ = face;
      else if(!take(face.face))
        break;
    faces_.erase(end, faces_.end());
  }

  const Face& operator[](std::size_t position) const { return faces_[position]; }
  std::size_t size() const { return faces_.size(); }
  int dimension() const { return 3; }
  bool are_exact() const { return false; }

  auto intervals(std::size_t position) const
  {
    Bbox_3 box;
    for(const auto& vertex : faces_[position].vertices)
      box = box + vertex_box(vertex);
    return [box](int axis) { return Interval{(box.min)(axis), (box.max)(axis)}; };
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    const Face& a = faces_[i];
    const Face& b = faces_[j];
    const Common_vertices common = common_vertices(a, b);
    if(common.count == 0)
      return do_triangles_intersect(points(a), points(b));
    if(common.count == 1)
      return do_intersect_beyond_vertex(a, common.place_in_first, b, common.place_in_second);
    const auto edge = find_common_edge(a, b, mesh_);
    return !edge || do_intersect_beyond_edge(*edge);
  }

private:
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;

  auto point(const Vertex& vertex) const
  {
    return with_exact_predicates(get(point_map_, vertex));
  }

  auto points(const Face& face) const
  {
    const auto& v = face.vertices;
    return std::array<decltype(point(v[0])), 3>{point(v[0]), point(v[1]), point(v[2])};
  }

  Bbox_3 vertex_box(const Vertex& vertex) const
  {
    return bounding_box_of_point<Bbox_3>(get(point_map_, vertex));
  }

  // A lazy point may have an infinite box until it is computed.
  void check_box(const Vertex& vertex, std::size_t position) const
  {
    if(is_finite_box(vertex_box(vertex)))
      return;
    settle(get(point_map_, vertex));
    if(!is_finite_box(vertex_box(vertex)))
      throw std::invalid_argument("A vertex of face " + std::to_string(position)
                                  + " has a coordinate that is NaN, infinite or beyond doubles.");
  }

  bool is_degenerate(const Face& face) const
  {
    const auto p = points(face);
    return collinear(p[0], p[1], p[2]);
  }

  bool do_intersect_beyond_edge(const Halfedge& edge) const
  {
    const Halfedge after = next(edge, mesh_);
    const Halfedge after_opposite = next(opposite(edge, mesh_), mesh_);
    return do_triangles_at_edge_intersect(
      point(source(edge, mesh_)), point(target(edge, mesh_)), point(target(after, mesh_)),
      point(target(after_opposite, mesh_)));
  }

  bool do_intersect_beyond_vertex(const Face& a, std::size_t i, const Face& b, std::size_t j) const
  {
    return do_triangles_at_vertex_intersect(
      point(a.vertices[i]), point(a.vertices[(i + 1) % 3]), point(a.vertices[(i + 2) % 3]),
      point(b.vertices[(j + 1) % 3]), point(b.vertices[(j + 2) % 3]));
  }

  const Mesh& mesh_;
  const Point_map point_map_;
  Faces faces_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_MESH_TRIANGLES_H
