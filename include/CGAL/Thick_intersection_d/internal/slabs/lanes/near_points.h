// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_H

// Near pairs of points, by the best instructions that the processor has. Each instruction set has a
// file of its own. List a new instruction set here.

#include <CGAL/Thick_intersection_d/internal/slabs/lanes/First_supported.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/near_points_avx512.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/near_points_plain.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

using Near_points_lanes = First_supported<Near_points_avx512, Near_points_plain>;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_H
