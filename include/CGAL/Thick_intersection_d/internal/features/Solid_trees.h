// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H

// Do pieces of two features meet, and is a point inside closed faces? It is if the ray upwards from
// it crosses them an odd number of times.
//
// Each tree halves the pieces of a feature along axes, and has the boxes of the parts. Pieces meet,
// and a ray crosses faces, only in parts whose boxes do.

#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
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

// An `Object` is a segment or a triangle, or a variant of both, with a radius or without.
template <class Object>
class Solid_trees
{
public:
  // Takes memory for so many pieces.
  void reserve(std::size_t count) { pieces_.reserve(count); }

  Place size() const { return static_cast<Place>(pieces_.size()); }
  const Object& piece(std::size_t position) const { return pieces_[position].piece; }

  void add_piece(const Object& piece, const Space_box& box) { pieces_.push_back({box, piece}); }

  // Makes a tree of the pieces from this one on, and puts them into its order.
  Halved_range add_tree(Place first)
  {
    const Halved_range tree = {static_cast<Place>(nodes_.size()), first, size()};
    if(tree.last - tree.first >= sorted_size)
      sort(tree);
    add_nodes(tree);
    return tree;
  }

  // Takes the pieces from this one on away.
  void remove_pieces(Place first) { pieces_.erase(pieces_.begin() + first, pieces_.end()); }

  // Prefetches the pieces that is_any_pair() is likely to read first.
  void prefetch(const Halved_range& tree) const
  {
    prefetch_to_read(&nodes_[tree.node]);
    const Place last = (std::min)(tree.last, tree.first + Halved_range::leaf_size);
    for(Place piece = tree.first; piece != last; ++piece) {
      prefetch_to_read(&pieces_[piece]);
      prefetch_to_read(&pieces_[piece], 1);
    }
  }

  // Whether test(i, j) holds for a piece of each of two trees, among those whose boxes meet.
  template <class Test>
  bool is_any_pair(const Halved_range& a, const Halved_range& b, const Test& test) const
  {
    if(!do_boxes_meet(nodes_[a.node], nodes_[b.node]))
      return false;
    if(a.is_leaf() && b.is_leaf())
      return is_any_pair_of_leaves(a, b, test);
    if(b.is_leaf() || (!a.is_leaf() && a.last - a.first >= b.last - b.first))
      return is_any_pair(a.first_half(), b, test) || is_any_pair(a.second_half(), b, test);
    return is_any_pair(a, b.first_half(), test) || is_any_pair(a, b.second_half(), test);
  }

  // Whether test(i) holds for a piece of a tree, among those whose boxes meet a box.
  template <class Test>
  bool is_any_in_box(const Halved_range& tree, const Space_box& box, const Test& test) const
  {
    if(!do_boxes_meet(nodes_[tree.node], box))
      return false;
    if(!tree.is_leaf())
      return is_any_in_box(tree.first_half(), box, test)
             || is_any_in_box(tree.second_half(), box, test);
    for(Place piece = tree.first; piece != tree.last; ++piece)
      if(do_boxes_meet(pieces_[piece].box, box) && test(piece))
        return true;
    return false;
  }

  // Whether the first vertex of a piece is inside a tree of closed faces. It is not on them.
  template <class Source>
  bool is_inside(const Source& source, const Halved_range& faces) const
  {
    const Space_box& box = nodes_[faces.node];
    for(int axis = 0; axis < 3; ++axis) {
      const auto x = vertex_bounds(source, 0, axis);
      const Interval& interval = box[static_cast<std::size_t>(axis)];
      if(x.first > interval.high || (axis < 2 && x.second < interval.low))
        return false;
    }
    if(!faces.is_leaf())
      return is_inside(source, faces.first_half()) != is_inside(source, faces.second_half());
    return std::count_if(pieces_.begin() + faces.first, pieces_.begin() + faces.last,
                         [&](const Boxed_piece& face) {
                           return does_ray_cross_face(source, face.piece);
                         })
             % 2 != 0;
  }

private:
  // Fewer pieces are left as they come. To sort them takes longer than what a sorted tree saves, as
  // most meshes have neighbors near each other.
  static constexpr Place sorted_size = 256;

  struct Boxed_piece
  {
    Space_box box;
    Object piece;
  };

  // Where a piece is, for sorting.
  struct Centered_piece
  {
    std::array<double, 3> center;
    Place piece;
  };

  void sort(const Halved_range& tree)
  {
    std::vector<Centered_piece> centers;
    centers.reserve(tree.last - tree.first);
    for(Place piece = tree.first; piece != tree.last; ++piece) {
      const Space_box& box = pieces_[piece].box;
      const auto center = [&](std::size_t axis) { return box[axis].low / 2 + box[axis].high / 2; };
      centers.push_back({{center(0), center(1), center(2)}, piece});
    }
    sort_by_halves(centers.data(), {0, 0, tree.last - tree.first});
    std::vector<Boxed_piece> sorted;
    sorted.reserve(centers.size());
    for(const Centered_piece& center : centers)
      sorted.push_back(std::move(pieces_[center.piece]));
    std::move(sorted.begin(), sorted.end(), pieces_.begin() + tree.first);
  }

  // Halves the range along the axis along which the centers are farthest apart, and so on.
  static void sort_by_halves(Centered_piece* centers, const Halved_range& range)
  {
    if(range.is_leaf())
      return;
    Space_box box;
    for(Place i = range.first; i != range.last; ++i)
      for(std::size_t axis = 0; axis < 3; ++axis)
        box[axis].add(centers[i].center[axis]);
    const auto longest = std::max_element(box.begin(), box.end(), [](const auto& a, const auto& b) {
      return a.half_length() < b.half_length();
    });
    const std::size_t axis = static_cast<std::size_t>(longest - box.begin());
    std::nth_element(centers + range.first, centers + range.middle(), centers + range.last,
                     [=](const Centered_piece& a, const Centered_piece& b) {
                       return a.center[axis] < b.center[axis];
                     });
    sort_by_halves(centers, range.first_half());
    sort_by_halves(centers, range.second_half());
  }

  void add_nodes(const Halved_range& range)
  {
    nodes_.emplace_back();
    Space_box box;
    if(range.is_leaf())
      for(Place piece = range.first; piece != range.last; ++piece)
        box.add_box(pieces_[piece].box);
    else
      for(const Halved_range& half : {range.first_half(), range.second_half()}) {
        add_nodes(half);
        box.add_box(nodes_[half.node]);
      }
    nodes_[range.node] = box;
  }

  // Pieces that follow each other are alike: if two do not meet, their neighbors may not either. So
  // each step takes another piece of both, in opposite orders, as meshes may have one pattern.
  template <class Test>
  bool is_any_pair_of_leaves(const Halved_range& a, const Halved_range& b, const Test& test) const
  {
    std::array<Place, Halved_range::leaf_size> near; // of the first tree
    std::size_t count = 0;
    for(Place i = a.first; i != a.last; ++i)
      if(do_boxes_meet(pieces_[i].box, nodes_[b.node]))
        near[count++] = i;
    for(Place first = b.first; first != b.last; ++first) {
      Place j = first;
      for(std::size_t k = 0; k != count; ++k) {
        if(do_boxes_meet(pieces_[near[k]].box, pieces_[j].box) && test(near[k], j))
          return true;
        j = j == b.first ? b.last - 1 : j - 1;
      }
    }
    return false;
  }

  std::vector<Boxed_piece> pieces_;
  std::vector<Space_box> nodes_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H
