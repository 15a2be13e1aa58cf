// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ISO_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ISO_BOXES_H

// Does a closed iso-box intersect another one, or a segment, triangle or tetrahedron? All may be
// degenerate.
//
// `Orientation` decides about points, as Staged_orientation does.
//
// Two convex polytopes are apart iff a plane of a facet of their Minkowski difference is between
// them. The difference has facets of three kinds: those of the box, those of the other object, and
// those of an edge of each. The edges of a box are along the axes, so the planes of the third kind
// are lines in the projections along the axes. In the plane, they are the lines of the edges. If
// an object is degenerate, so may be the difference, and then it has no facets. But a box that is
// longer by a little along all axes is not degenerate, and as close by as we like. It has facets in
// the same directions, and each plane that is between it and the other object is beyond the box as
// well.

#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/spatial_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/tetrahedra.h>

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The boxes have two opposite corners, the lower one first.
template <class Orientation>
bool do_iso_boxes_intersect(const Simplex<Orientation, 2>& a, const Simplex<Orientation, 2>& b)
{
  for(int axis = 0; axis < Orientation::dimension; ++axis)
    if(Orientation::compare(a[1], b[0], axis) == NEGATIVE
       || Orientation::compare(b[1], a[0], axis) == NEGATIVE)
      return false;
  return true;
}

// All corners of a box: bit `axis` of their place is set at the upper end along that axis.
template <class Orientation>
using Box_corners = Simplex<Orientation, std::size_t(1) << Orientation::dimension>;

// Whether all points of an object are strictly on one side of the box along an axis.
template <class Orientation, std::size_t Count>
bool is_beside_box(const Simplex<Orientation, Count>& object, const Box_corners<Orientation>& box,
                   int axis)
{
  bool are_below = true, are_above = true;
  for(const auto& p : object) {
    are_below = are_below && Orientation::compare(p, box.front(), axis) == NEGATIVE;
    are_above = are_above && Orientation::compare(p, box.back(), axis) == POSITIVE;
  }
  return are_below || are_above;
}

// Whether the line from p to q in the projection along the axes i and j has the box strictly on one
// side, and all of the object on the other side.
template <class Orientation, std::size_t Count>
bool is_line_between(Orientation& orientation, const Simplex<Orientation, Count>& object,
                     const Box_corners<Orientation>& box, const typename Orientation::Point& p,
                     const typename Orientation::Point& q, int i, int j)
{
  // The corner farthest to the left of the line, and that farthest to the right.
  const std::size_t up = Orientation::compare(p, q, i) == NEGATIVE ? std::size_t(1) << j : 0;
  const std::size_t back = Orientation::compare(p, q, j) == POSITIVE ? std::size_t(1) << i : 0;
  const std::size_t all = (std::size_t(1) << i) | (std::size_t(1) << j);
  const std::size_t left = up | back;
  Sign side = orientation.orientation(p, q, box[all ^ left], i, j);
  if(side != POSITIVE) {
    side = orientation.orientation(p, q, box[left], i, j);
    if(side != NEGATIVE)
      return false;
  }
  for(const auto& x : object)
    if(orientation.orientation(p, q, x, i, j) == side)
      return false;
  return true;
}

template <class Orientation, std::size_t Count>
bool is_any_line_between(Orientation& orientation, const Simplex<Orientation, Count>& object,
                         const Box_corners<Orientation>& box, int i, int j)
{
  for(std::size_t k = 0; k < Count; ++k)
    for(std::size_t l = k + 1; l < Count; ++l)
      if(is_line_between(orientation, object, box, object[k], object[l], i, j))
        return true;
  return false;
}

// Whether the plane of a face has the box strictly on one side. `inner` is what is on the other
// side of the face, or zero if the object is no more than the face.
template <class Orientation>
bool is_plane_between(Orientation& orientation, const Simplex<Orientation, 3>& face,
                      const Box_corners<Orientation>& box, Sign inner)
{
  const auto plane = orientation.plane(face[0], face[1], face[2]);
  const Sign side = orientation.side(plane, box[0]);
  if(side == ZERO || side == inner)
    return false;
  for(const auto& corner : box)
    if(orientation.side(plane, corner) != side)
      return false;
  return true;
}

template <class Orientation, std::size_t Count>
bool is_any_plane_between(Orientation& orientation, const Simplex<Orientation, Count>& object,
                          const Box_corners<Orientation>& box)
{
  if constexpr(Count == 3)
    return is_plane_between(orientation, object, box, ZERO);
  else if constexpr(Count == 4) {
    const Sign sign = orientation_of(orientation, object);
    for(std::size_t k = 0; k < 4; ++k)
      if(is_plane_between(orientation, face_of<Orientation>(object, k), box, sign))
        return true;
  }
  return false;
}

// Whether a segment, triangle or tetrahedron meets a box.
template <class Orientation, std::size_t Count>
bool does_meet_iso_box(Orientation& orientation, const Simplex<Orientation, Count>& object,
                       const Box_corners<Orientation>& box)
{
  for(int axis = 0; axis < Orientation::dimension; ++axis)
    if(is_beside_box<Orientation>(object, box, axis))
      return false;
  if constexpr(Orientation::dimension == 2)
    return !is_any_line_between(orientation, object, box, 0, 1);
  else {
    for(int axis = 0; axis < 3; ++axis)
      if(is_any_line_between(orientation, object, box, (axis + 1) % 3, (axis + 2) % 3))
        return false;
    return !is_any_plane_between(orientation, object, box);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ISO_BOXES_H
