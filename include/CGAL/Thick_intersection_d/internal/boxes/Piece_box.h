// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_PIECE_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_PIECE_BOX_H

// Boxes of doubles, as the box route moves them.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A closed box that encloses an object of the user.
template <int Axes>
struct Piece_box
{
  static constexpr int axes = Axes;

  std::array<double, Axes> low;
  std::array<double, Axes> high;
  Place position;

  // Bit i is set if the box is a copy along axis i: it begins in an earlier piece of a cut along
  // this axis. Two boxes that are copies along the same axis have met in an earlier piece.
  Place sides;
};

// Consecutive boxes of one set.
template <class Box>
struct Span
{
  Box* first;
  Box* last;

  Place size() const { return static_cast<Place>(last - first); }
};

// The boxes of one set, or of each of two sets, in a part of space.
template <class Box, std::size_t Sets>
struct Piece : std::array<Span<Box>, Sets>
{
  Place size() const
  {
    Place size = 0;
    for(const Span<Box>& span : *this)
      size += span.size();
    return size;
  }

  // Whether there may be a pair.
  bool has_pairs() const
  {
    if constexpr(Sets == 1)
      return (*this)[0].size() > 1;
    else
      return (*this)[0].size() > 0 && (*this)[1].size() > 0;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_PIECE_BOX_H
