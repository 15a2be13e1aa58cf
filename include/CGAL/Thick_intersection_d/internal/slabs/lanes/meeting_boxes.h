// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_H

// Meeting pairs of boxes, by the best instructions that the processor has. Each instruction set has
// a file of its own. List a new instruction set here.

#include <CGAL/Thick_intersection_d/internal/slabs/lanes/First_supported.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/meeting_boxes_avx512.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/meeting_boxes_plain.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

using Meeting_boxes_lanes = First_supported<Meeting_boxes_avx512, Meeting_boxes_plain>;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_H
