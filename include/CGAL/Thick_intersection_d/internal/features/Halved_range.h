// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_HALVED_RANGE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_HALVED_RANGE_H

// A tree that halves consecutive pieces of boundaries. Its nodes are numbered from the root on, so
// that it needs no pointers.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The pieces [first, last), and the node with their box. The node of the first half follows.
struct Halved_range
{
  static constexpr Place leaf_size = 16;

  Place node;
  Place first;
  Place last;

  bool is_leaf() const { return last - first <= leaf_size; }

  Halved_range first_half() const { return {node + 1, first, middle()}; }
  Halved_range second_half() const { return {node + 2 * leaves_of_first_half(), middle(), last}; }

  Place middle() const { return first + leaf_size * leaves_of_first_half(); }

private:
  // The first half has a power of two of leaves, so its tree has one node less than twice as many.
  Place leaves_of_first_half() const
  {
    const Place leaves = (last - first + leaf_size - 1) / leaf_size;
    Place half = 1;
    while(2 * half < leaves)
      half *= 2;
    return half;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_HALVED_RANGE_H
