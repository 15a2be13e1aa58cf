// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_JOIN_TASK_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_JOIN_TASK_H

// What a join of points in common cells is told, and what it tells: doubles and positions.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
struct Join_task
{
  std::array<Interval, Dimension> box; // of the points
  double error = 0;       // the most by which a coordinate is above the double that is read of it
  std::uint64_t seed = 0; // of what is drawn, and of hashes
  Threads threads;
};

// Whether a join gave all pairs that it looks for. It gives up if it would take too long.
enum class Joined { ALL, STOPPED, GIVEN_UP };

// Takes pairs that may be the closest one.
class Closest_taker : public Result_taker
{
public:
  // Returns a bound on the distance of the closest pair so far, which is at most twice this
  // distance. Returns 0 if there is no such bound: if points are equal, or doubles are too coarse.
  virtual double reach() = 0;

protected:
  ~Closest_taker() = default;
};

// Whether cells about as large as `reach` are useful, if coordinates are up to `error` above their
// doubles: whether each point is in few cells.
inline bool do_cells_fit(double reach, double error)
{
  return reach > 0 && error <= reach / 2;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_JOIN_TASK_H
