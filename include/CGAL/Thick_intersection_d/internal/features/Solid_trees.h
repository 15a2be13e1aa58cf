// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H

// Is a point inside closed faces? It is if the ray upwards from it crosses them an odd number of
// times.
//
// Each tree halves the faces of a solid along axes, and has the boxes of the parts. A ray meets
// only faces in boxes that it meets.

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether a ray upwards from the last vertex crosses the triangle of the first three. The ray is
// moved along axis 0 by less than any number, and along axis 1 by still less. So it passes no edge,
// and no triangle that is vertical, and it crosses closed faces equally often wherever it goes. The
// vertex is not on the triangle, so it is above or below its plane if the ray crosses the triangle.
template <class Orientation>
bool does_ray_cross_face(typename Orientation::template Vertices<4>& vertices)
{
  using Point = typename Orientation::Point;
  Orientation orientation(vertices);
  const std::array<Point, 3> triangle
    = {Point(vertices[0]), Point(vertices[1]), Point(vertices[2])};
  const Point source(vertices[3]);
  const auto is_behind = [&](std::size_t k) {
    return Orientation::compare(triangle[k], source, 1) == LARGER;
  };
  const std::array<bool, 3> are_behind = {is_behind(0), is_behind(1), is_behind(2)};
  bool is_in_projection = false, turns_left = false;
  for(std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if(are_behind[k] == are_behind[next])
      continue;
    // Is the edge beyond the source along axis 0?
    if(orientation.orientation(triangle[k], triangle[next], source, 0, 1)
       == (are_behind[next] ? LEFT_TURN : RIGHT_TURN)) {
      is_in_projection = !is_in_projection;
      turns_left = are_behind[next];
    }
  }
  return is_in_projection
         && orientation.side(orientation.plane(triangle[0], triangle[1], triangle[2]), source)
              == (turns_left ? NEGATIVE : POSITIVE);
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template bool does_ray_cross_face<Staged_orientation<3>>(
  Staged_orientation<3>::Vertices<4>&);
#endif

// Whether the ray upwards from the first vertex of `source` crosses a face, which are kernel
// objects.
template <class Source, class Face>
bool does_ray_cross_face(const Source& source, const Face& face)
{
  Staged_orientation<3>::Vertices<4> vertices;
  const bool are_doubles = read_vertices(face, [&](std::size_t k, int axis, double x) {
    vertices[k].x[static_cast<std::size_t>(axis)] = x;
  }) && read_vertices(source, [&](std::size_t k, int axis, double x) {
    if(k == 0)
      vertices[3].x[static_cast<std::size_t>(axis)] = x;
  });
  if(are_doubles)
    return does_ray_cross_face<Staged_orientation<3>>(vertices);
  using Kernel = typename Common_exact_kernel<Source, Face>::type;
  using Exact_orientation = Kernel_orientation<Kernel, 3>;
  constexpr std::size_t source_size = corner_count_v<Source>;
  typename Exact_orientation::template Vertices<4> exact_vertices
    = {exact_vertex<Kernel, 3>(face, 0), exact_vertex<Kernel, 3>(face, 1),
       exact_vertex<Kernel, 3>(face, 2), exact_vertex<Kernel, source_size>(source, 0)};
  return does_ray_cross_face<Exact_orientation>(exact_vertices);
}

// `Object` is the type of faces, or a variant of it and others.
template <class Object>
class Solid_trees
{
public:
  // Refers to the pieces, some of which are faces.
  explicit Solid_trees(const std::vector<Object>& pieces) : pieces_(pieces) {}

  // Makes a tree of the faces [first, last). Returns its root.
  Place add_tree(Place first, Place last)
  {
    std::vector<Boxed_face> faces;
    faces.reserve(last - first);
    for(Place piece = first; piece != last; ++piece)
      faces.push_back({bounding_box(pieces_[piece]), piece});
    const Place root = add_nodes(faces, 0, last - first);
    order_.resize(last);
    std::transform(faces.begin(), faces.end(), order_.begin() + first,
                   [](const Boxed_face& face) { return face.piece; });
    return root;
  }

  // The box of a tree.
  const Bbox_3& box(Place root) const { return boxes_[root]; }

  // Returns whether the first vertex of a piece is inside the tree of the faces [first, last). It
  // is not on them.
  bool is_inside(const Object& piece, Place root, Place first, Place last) const
  {
    return with_kind(piece, [&](const auto& source) {
      return is_crossed_odd(source, {root, first, last});
    });
  }

private:
  struct Boxed_face
  {
    Bbox_3 box;
    Place piece;

    double center(int axis) const { return (box.min)(axis) / 2 + (box.max)(axis) / 2; }
  };

  Place add_nodes(std::vector<Boxed_face>& faces, Place first, Place last)
  {
    const std::size_t root = boxes_.size();
    const Halved_range range = {static_cast<Place>(root), first, last};
    boxes_.emplace_back();
    if(range.is_leaf())
      for(Place i = first; i != last; ++i)
        boxes_[root] += faces[i].box;
    else {
      const int axis = longest_axis(faces, first, last);
      std::nth_element(faces.begin() + first, faces.begin() + range.middle(), faces.begin() + last,
                       [=](const Boxed_face& a, const Boxed_face& b) {
                         return a.center(axis) < b.center(axis);
                       });
      add_nodes(faces, first, range.middle());
      const Place second = add_nodes(faces, range.middle(), last);
      boxes_[root] = boxes_[root + 1] + boxes_[second];
    }
    return range.node;
  }

  // The axis along which the centers of the boxes are farthest apart.
  static int longest_axis(const std::vector<Boxed_face>& faces, Place first, Place last)
  {
    std::array<double, 3> lengths;
    for(int axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::minmax_element(
        faces.begin() + first, faces.begin() + last,
        [=](const Boxed_face& a, const Boxed_face& b) { return a.center(axis) < b.center(axis); });
      lengths[static_cast<std::size_t>(axis)] = most->center(axis) - least->center(axis);
    }
    return static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  }

  template <class Source>
  bool is_crossed_odd(const Source& source, const Halved_range& faces) const
  {
    const Bbox_3& box = boxes_[faces.node];
    for(int axis = 0; axis < 3; ++axis) {
      const auto x = vertex_bounds(source, 0, axis);
      if(x.first > (box.max)(axis) || (axis < 2 && x.second < (box.min)(axis)))
        return false;
    }
    if(!faces.is_leaf())
      return is_crossed_odd(source, faces.first_half())
             != is_crossed_odd(source, faces.second_half());
    return std::count_if(order_.begin() + faces.first, order_.begin() + faces.last,
                         [&](Place face) {
                           return does_ray_cross_face(source, as_face(pieces_[face]));
                         })
             % 2 != 0;
  }

  const std::vector<Object>& pieces_;
  std::vector<Place> order_; // of the faces of each tree
  std::vector<Bbox_3> boxes_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H
