// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H

// The bounding box of an object.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A Bbox has no bbox(). It is its own box.
inline const Bbox_2& bounding_box(const Bbox_2& box) { return box; }
inline const Bbox_3& bounding_box(const Bbox_3& box) { return box; }

template <class Object>
auto bounding_box(const Object& object)
{
  return object.bbox();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
