// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_DOES_RAY_CROSS_FACE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_DOES_RAY_CROSS_FACE_H

// Does a ray upwards from a vertex cross a triangle, and may it meet a box?

#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <array>
#include <cstddef>

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

// Whether that ray may meet a box.
template <class Source>
BOOST_FORCEINLINE bool may_ray_meet(const Source& source, const Space_box& box)
{
  for(int axis = 0; axis < 3; ++axis) {
    const auto x = vertex_bounds(source, 0, axis);
    const Interval& interval = box[static_cast<std::size_t>(axis)];
    if(x.first > interval.high || (axis < 2 && x.second < interval.low))
      return false;
  }
  return true;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_DOES_RAY_CROSS_FACE_H
