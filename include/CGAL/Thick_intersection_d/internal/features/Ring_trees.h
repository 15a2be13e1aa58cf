// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_RING_TREES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_RING_TREES_H

// Is a point inside rings? It is if a ray from it crosses them an odd number of times.
//
// Each tree halves the segments of some rings, in their order, and has the boxes of the parts. The
// segments of a part are a chain. A chain that is right of the point is crossed an odd number of
// times iff one of its ends is above the ray, and the other one is not. If it is above, below or
// left, no ray crosses it. So only the chains whose boxes have the point are divided. These are
// O(log n) for a shape whose parts are next to their neighbors, and as many as the ray has
// crossings at most, up to a factor O(log n).

#include <CGAL/Bbox_2.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Does a ray to the right cross an edge? The rays begin at the sources of segments, or at points.
// An edge has its end on the ray only if its other end is above the ray: so a closed polygon is
// crossed as often by a ray through a vertex as by a ray just above it.

// Returns a vertex of an object as a point of an exact kernel of it and of others like `Other`.
template <class Other, class Object>
auto exact_end(const Object& object, int v)
{
  using Kernel = typename Common_exact_kernel<Object, Other>::type;
  return exact_vertex<Kernel, corner_count_v<Object>>(object, static_cast<std::size_t>(v));
}

template <class Segment, class Object>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
Sign compare_exactly(const Segment& edge, int v, const Object& point, int axis)
{
  return CGAL::compare(exact_end<Object>(edge, v).cartesian(axis),
                       exact_end<Segment>(point, 0).cartesian(axis));
}

// Compares the coordinates of a vertex of an edge and of the first vertex of an object. Doubles
// decide nearly always.
template <class Segment, class Object>
BOOST_FORCEINLINE
Sign compare_with_point(const Segment& edge, int v, const Object& point, int axis)
{
  const auto x = vertex_bounds(edge, v, axis);
  const auto y = vertex_bounds(point, 0, axis);
  constexpr bool are_doubles = has_double_vertices_v<Segment> && has_double_vertices_v<Object>;
  if(x.first > y.second)
    return LARGER;
  if(x.second < y.first)
    return SMALLER;
  if(are_doubles || (x.first == x.second && y.first == y.second))
    return EQUAL;
  return compare_exactly(edge, v, point, axis);
}

// Whether a vertex of an edge is above the source of `ray`.
template <class Segment, class Ray>
bool is_above_ray(const Segment& edge, int v, const Ray& ray)
{
  return compare_with_point(edge, v, ray, 1) == LARGER;
}

template <class Orientation>
Sign orientation_of_vertices(typename Orientation::template Vertices<3>& vertices)
{
  using Point = typename Orientation::Point;
  return Orientation(vertices).orientation(Point(vertices[0]), Point(vertices[1]),
                                           Point(vertices[2]), 0, 1);
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template Sign orientation_of_vertices<Staged_orientation<2>>(
  Staged_orientation<2>::Vertices<3>&);
#endif

// Reads a vertex of an object. Returns false if its coordinates are no doubles.
template <class Object>
bool read_vertex(const Object& object, int v, Staged_orientation<2>::Vertex& vertex)
{
  for(int axis = 0; axis < 2; ++axis) {
    const auto x = vertex_bounds(object, v, axis);
    if(!has_double_vertices_v<Object> && x.first != x.second)
      return false;
    vertex.x[static_cast<std::size_t>(axis)] = x.first;
  }
  return true;
}

// Edges that touch have vertices in common. Turns of equal points are none, and no filter says so.
inline bool are_two_equal(const Staged_orientation<2>::Vertices<3>& vertices)
{
  const auto& [a, b, c] = vertices;
  return a.x == c.x || b.x == c.x || a.x == b.x;
}

// Returns whether vertex i of an edge, vertex j of another one and vertex k of an object make a
// left turn, a right turn or none.
template <class Segment, class Object>
Sign orientation_of_ends(const Segment& a, int i, const Segment& b, int j, const Object& c, int k)
{
  Staged_orientation<2>::Vertices<3> vertices;
  if(read_vertex(a, i, vertices[0]) && read_vertex(b, j, vertices[1])
     && read_vertex(c, k, vertices[2]))
    return are_two_equal(vertices) ? ZERO
                                   : orientation_of_vertices<Staged_orientation<2>>(vertices);
  using Exact_orientation
    = Kernel_orientation<typename Common_exact_kernel<Segment, Object>::type, 2>;
  typename Exact_orientation::template Vertices<3> exact_vertices
    = {exact_end<Object>(a, i), exact_end<Object>(b, j), exact_end<Segment>(c, k)};
  return orientation_of_vertices<Exact_orientation>(exact_vertices);
}

// Whether a ray to the right of the source of `ray` crosses the edge. If the source is on the edge,
// it does not.
template <class Segment, class Ray>
bool does_ray_cross(const Ray& ray, const Segment& edge)
{
  const bool ends_above = is_above_ray(edge, 1, ray);
  return is_above_ray(edge, 0, ray) != ends_above
         && orientation_of_ends(edge, 0, edge, 1, ray, 0) == (ends_above ? LEFT_TURN : RIGHT_TURN);
}

template <class Segment>
class Ring_trees
{
public:
  // Refers to the segments. Each ring begins and ends at one vertex.
  explicit Ring_trees(const std::vector<Segment>& segments) : segments_(segments) {}

  // The segments from this one on are of another ring.
  void begin_ring(Place segment) { rings_.push_back(segment); }

  // Makes a tree of the segments [first, last) of whole rings.
  Halved_range add_tree(Place first, Place last)
  {
    const Halved_range tree = {static_cast<Place>(boxes_.size()), first, last};
    boxes_.emplace_back();
    if(tree.is_leaf())
      for(Place segment = first; segment != last; ++segment)
        boxes_[tree.node] += bounding_box(segments_[segment]);
    else {
      const Halved_range first_half = add_tree(first, tree.middle());
      const Halved_range second_half = add_tree(tree.middle(), last);
      boxes_[tree.node] = box(first_half) + box(second_half);
    }
    return tree;
  }

  const Bbox_2& box(const Halved_range& tree) const { return boxes_[tree.node]; }

  // Returns whether the source of `ray` is inside the rings of a tree. It is not on them.
  bool is_inside(const Segment& ray, const Halved_range& tree) const
  {
    const auto does_cross = [&](Place segment) { return does_ray_cross(ray, segments_[segment]); };
    return is_crossed_odd(ray, tree, does_cross, [] { return false; });
  }

  // Returns whether a ray crosses an odd number of the segments of a tree, or of a part of it.
  // `does_cross` is called for those at the first vertex of `ray`, in their order, and for others,
  // and tells whether a ray from there crosses the segment. Ends early if `is_done` says so after a
  // segment, and then returns nothing of use.
  template <class Ray, class Function, class Done>
  bool is_crossed_odd(const Ray& ray, const Halved_range& chain, const Function& does_cross,
                      const Done& is_done) const
  {
    const Bbox_2& box = boxes_[chain.node];
    const auto x = vertex_bounds(ray, 0, 0);
    const auto y = vertex_bounds(ray, 0, 1);
    if(x.first > box.xmax() || y.first > box.ymax() || y.second < box.ymin())
      return false;
    if(x.second < box.xmin())
      return are_ends_apart(ray, chain);
    if(!chain.is_leaf()) {
      const bool is_odd = is_crossed_odd(ray, chain.first_half(), does_cross, is_done);
      return !is_done()
             && is_odd != is_crossed_odd(ray, chain.second_half(), does_cross, is_done);
    }
    bool is_odd = false;
    for(Place segment = chain.first; segment != chain.last && !is_done(); ++segment)
      is_odd ^= does_cross(segment);
    return is_odd;
  }

  // Whether `is_wanted` says so of a segment of a tree. Those whose boxes meet another one are
  // asked about, and some others.
  template <class Function>
  bool is_any_in_box(const Bbox_2& box, const Halved_range& chain,
                     const Function& is_wanted) const
  {
    if(!do_overlap(box, boxes_[chain.node]))
      return false;
    if(!chain.is_leaf())
      return is_any_in_box(box, chain.first_half(), is_wanted)
             || is_any_in_box(box, chain.second_half(), is_wanted);
    for(Place segment = chain.first; segment != chain.last; ++segment)
      if(is_wanted(segment))
        return true;
    return false;
  }

private:
  // Whether an odd number of the ends of chains are above the ray. If the segments are of several
  // rings, they are the last chain of a ring, whole rings, and the first chain of another ring.
  template <class Ray>
  bool are_ends_apart(const Ray& ray, const Halved_range& chain) const
  {
    const auto is_above
      = [&](Place segment, int v) { return is_above_ray(segments_[segment], v, ray); };
    const bool is_odd = is_above(chain.first, 0) != is_above(chain.last - 1, 1);
    const Place first_ring = ring_of(chain.first), last_ring = ring_of(chain.last - 1);
    return first_ring == last_ring
             ? is_odd
             : is_odd != (is_above(first_ring, 0) != is_above(last_ring, 0));
  }

  // The first segment of the ring of a segment.
  Place ring_of(Place segment) const
  {
    return *(std::upper_bound(rings_.begin(), rings_.end(), segment) - 1);
  }

  const std::vector<Segment>& segments_;
  std::vector<Place> rings_;
  std::vector<Bbox_2> boxes_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_RING_TREES_H
