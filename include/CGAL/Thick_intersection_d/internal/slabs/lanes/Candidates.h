// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_CANDIDATES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_CANDIDATES_H

// Pairs that lanes have found, on the way to those who decide and report them.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>

#include <array>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The point at place i of one run and that at place j of the same or another.
struct Candidate
{
  Place i;
  Place j;
};

struct Candidates
{
  static constexpr Place capacity = 1024;

  Place count = 0;
  bool is_any_undecided = false; // by the filter
  std::array<Candidate, capacity + lanes> pairs; // so many may come before the next look
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_CANDIDATES_H
