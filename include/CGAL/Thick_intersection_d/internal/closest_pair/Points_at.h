// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_POINTS_AT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_POINTS_AT_H

// The points at some positions, numbered anew.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements>
class Points_at
{
public:
  using value_type = typename Elements::value_type;

  Points_at(const Elements& points, const std::vector<Place>& positions)
    : points_(points), positions_(positions)
  {}

  std::size_t size() const { return positions_.size(); }
  decltype(auto) operator[](std::size_t i) const { return points_[positions_[i]]; }

private:
  const Elements& points_;
  const std::vector<Place>& positions_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_POINTS_AT_H
