// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_RAY_CROSSINGS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_RAY_CROSSINGS_H

// Does a ray to the right cross an edge? The rays begin at the sources of segments. An edge has its
// end on the ray only if its other end is above the ray: so a closed polygon is crossed as often
// by a ray through a vertex as by a ray just above it.

#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Segment>
using Exact_kernel_of = Kernel_with_exact_predicates<typename Kernel_traits<Segment>::Kernel>;

// Whether a vertex of an edge is above the source of `ray`. Doubles decide nearly always.
template <class Segment>
bool is_above_ray(const Segment& edge, int v, const Segment& ray)
{
  const auto y = vertex_bounds(edge, v, 1);
  const auto height = vertex_bounds(ray, 0, 1);
  if(y.first > height.second)
    return true;
  if(y.second <= height.first)
    return false;
  const auto end = exact_vertex<Exact_kernel_of<Segment>, 2>(edge, static_cast<std::size_t>(v));
  const auto source = exact_vertex<Exact_kernel_of<Segment>, 2>(ray, 0);
  return CGAL::compare(end.cartesian(1), source.cartesian(1)) == LARGER;
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

// Returns whether the edge and then the source of `ray` make a left turn, a right turn or none.
template <class Segment>
Sign orientation_to_source(const Segment& edge, const Segment& ray)
{
  Staged_orientation<2>::Vertices<3> vertices;
  const bool are_doubles = read_vertices(edge, [&](std::size_t k, int axis, double x) {
    vertices[k].x[static_cast<std::size_t>(axis)] = x;
  }) && read_vertices(ray, [&](std::size_t k, int axis, double x) {
    if(k == 0)
      vertices[2].x[static_cast<std::size_t>(axis)] = x;
  });
  if(are_doubles)
    return orientation_of_vertices<Staged_orientation<2>>(vertices);
  using Kernel = Exact_kernel_of<Segment>;
  using Exact_orientation = Kernel_orientation<Kernel, 2>;
  typename Exact_orientation::template Vertices<3> exact_vertices
    = {exact_vertex<Kernel, 2>(edge, 0), exact_vertex<Kernel, 2>(edge, 1),
       exact_vertex<Kernel, 2>(ray, 0)};
  return orientation_of_vertices<Exact_orientation>(exact_vertices);
}

// Whether a ray to the right of the source of `ray` crosses the edge. The source is not on it.
template <class Segment>
bool does_ray_cross(const Segment& ray, const Segment& edge)
{
  const bool ends_above = is_above_ray(edge, 1, ray);
  return is_above_ray(edge, 0, ray) != ends_above
         && orientation_to_source(edge, ray) == (ends_above ? LEFT_TURN : RIGHT_TURN);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_RAY_CROSSINGS_H
