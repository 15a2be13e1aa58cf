// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CHECK_IN_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CHECK_IN_BOX_H

// Whether points are in a domain that is an iso-box.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Periods.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws if a point of the scene is not in [min, max) along all axes of an iso-box.
template <class Elements, class Iso_box>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
void check_in_box(const Elements& points, const Scene& scene, const Iso_box& box)
{
  using Exact = Common_exact_t<Coordinate_t<typename Elements::value_type>,
                               std::decay_t<decltype(box.min_coord(0))>>;
  for(int axis = 0; axis < scene.dimension(); ++axis) {
    const Exact low = to_exact<Exact>(box.min_coord(axis));
    const Exact high = to_exact<Exact>(box.max_coord(axis));
    const Interval& interval = scene.box[static_cast<std::size_t>(axis)];
    if(interval.low >= bounds(low).second && interval.high < bounds(high).first)
      continue;
    for(std::size_t position = 0; position < points.size(); ++position) {
      const Exact x = to_exact<Exact>(coordinate(points[position], axis));
      if(x < low || x >= high)
        throw std::invalid_argument("Point " + std::to_string(position)
                                    + " is not in the domain along axis " + std::to_string(axis)
                                    + ". A Periodic_lattice_d of the domain takes it.");
    }
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CHECK_IN_BOX_H
