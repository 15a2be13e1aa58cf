// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_PAIRS_SEARCH_H

// The search behind thick_mesh_self_intersections(): the faces of the mesh take the box route.

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/meshes/Mesh_face.h>
#include <CGAL/Thick_intersection_d/internal/meshes/mesh_triangles.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Faces of a triangle mesh, as the box route reads them. Two faces intersect if they have more in
// common than the vertex or edge that they share.
template <class Mesh, class Point_map>
class Mesh_triangles : public Objects_in_boxes<3>
{
public:
  using Face = Mesh_face<Mesh>;
  using Faces = std::vector<Face>;

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

  auto intervals(std::size_t position) const
  {
    Bbox_3 box;
    for(const auto& vertex : faces_[position].vertices)
      box = box + vertex_box(vertex);
    return intervals_of(box);
  }

  void prefetch(std::size_t position) const { prefetch_to_read(&faces_[position]); }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    const Face& a = faces_[i];
    const Face& b = faces_[j];
    const Common_vertices common = common_vertices(a, b);
    const auto v = [&](std::size_t k) { return a.vertices[(common.place_in_first + k) % 3]; };
    const auto w = [&](std::size_t k) { return b.vertices[(common.place_in_second + k) % 3]; };
    if(common.count == 0)
      return do_intersect<6>({v(0), v(1), v(2), w(0), w(1), w(2)});
    if(common.count == 1)
      return do_intersect<5>({v(0), v(1), v(2), w(1), w(2)});
    const auto edge = find_common_edge(a, b, mesh_);
    return !edge || do_intersect_beyond_edge(*edge);
  }

private:
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  using Kernel
    = typename Kernel_traits<typename boost::property_traits<Point_map>::value_type>::Kernel;
  static constexpr bool are_doubles = is_held_by_double_v<typename Kernel::FT>;
  using Orientation
    = std::conditional_t<are_doubles, Staged_orientation<3>,
                         Kernel_orientation<Kernel_with_exact_predicates<Kernel>, 3>>;

  void read(const Vertex& vertex, typename Orientation::Vertex& result) const
  {
    const auto& p = get(point_map_, vertex);
    if constexpr(are_doubles)
      result.x = {static_cast<double>(p.x()), static_cast<double>(p.y()),
                  static_cast<double>(p.z())};
    else
      result = with_exact_predicates(p);
  }

  template <std::size_t Count>
  auto points_of(const std::array<Vertex, Count>& vertices) const
  {
    typename Orientation::template Vertices<Count> result;
    for(std::size_t k = 0; k < Count; ++k)
      read(vertices[k], result[k]);
    return result;
  }

  template <std::size_t Count>
  bool do_intersect(const std::array<Vertex, Count>& vertices) const
  {
    auto points = points_of(vertices);
    return do_faces_intersect<Orientation, Count>(points);
  }

  Bbox_3 vertex_box(const Vertex& vertex) const
  {
    return bounding_box_of_point<Bbox_3>(get(point_map_, vertex));
  }

  // The box of a lazy point is the same from now on, if the map has the point.
  void check_box(const Vertex& vertex, std::size_t position) const
  {
    settle(get(point_map_, vertex));
    if(!is_finite_box(vertex_box(vertex)))
      throw std::invalid_argument("A vertex of face " + std::to_string(position)
                                  + " has a coordinate that is NaN, infinite or beyond doubles.");
  }

  bool is_degenerate(const Face& face) const
  {
    auto points = points_of(face.vertices);
    return is_degenerate_face<Orientation>(points);
  }

  bool do_intersect_beyond_edge(const Halfedge& edge) const
  {
    const Halfedge after = next(edge, mesh_);
    const Halfedge after_opposite = next(opposite(edge, mesh_), mesh_);
    return do_intersect<4>({source(edge, mesh_), target(edge, mesh_), target(after, mesh_),
                                     target(after_opposite, mesh_)});
  }

  const Mesh& mesh_;
  const Point_map point_map_;
  Faces faces_;
};

// Checks that nothing is given that a search of a mesh does not read.
template <class Point, class NamedParameters>
constexpr bool check_mesh_parameters()
{
  constexpr bool has_no_other
    = parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value;
  static_assert(has_no_other, "point_map is for ranges: pass the map from the vertices of a mesh "
                              "as vertex_point_map.");
  return has_no_other && check_no_traits<Point, NamedParameters>();
}

// Writes the pairs of faces that intersect. Degenerate faces come first, each as a pair with
// itself. Returns the iterator behind the last pair.
template <class FaceRange, class Mesh, class Iterator, class NamedParameters>
Iterator write_mesh_pairs(const FaceRange& face_range, const Mesh& mesh, Iterator out,
                          const NamedParameters& np, const Threads& threads)
{
  using Point_map = typename GetVertexPointMap<Mesh, NamedParameters>::const_type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  if constexpr(!check_mesh_parameters<Point, NamedParameters>())
    return out;
  else {
    check_denormals();
    Mesh_triangles<Mesh, Point_map> triangles(
      mesh, parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                         get_const_property_map(boost::vertex_point, mesh)));
    triangles.read(face_range);
    std::size_t left = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::maximum_number),
      (std::numeric_limits<std::size_t>::max)());
    std::mutex mutex;
    const auto write = [&](const auto& a, const auto& b) {
      const std::lock_guard<std::mutex> lock(mutex);
      if(left == 0)
        return false;
      *out++ = std::make_pair(a, b);
      return --left != 0;
    };
    triangles.remove_degenerate([&](const auto& face) { return write(face, face); });
    if(left != 0) {
      const auto write_faces = [&](std::size_t i, std::size_t j) {
        return write(triangles[i].face, triangles[j].face);
      };
      auto progress = make_progress(np, triangles.size());
      report_meeting_boxes(triangles, One_set(), write_faces, progress, threads);
    }
    return out;
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_PAIRS_SEARCH_H
