// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_PLAIN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_PLAIN_H

// Near pairs of points, by plain loops over lanes. Compilers turn the loops into vector
// instructions.
//
// The branch on whether a pair is near cannot be predicted. So every pair is stored, and the
// counter advances only for near ones.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_question.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>

#include <algorithm>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Near_points_plain
{
  static bool is_supported() { return true; }

  // Collects the pairs of a run that are within reach along axis 0 and not certainly beyond the
  // bound. Calls flush() when there are many pairs. It returns false to stop.
  //
  // The lanes are consecutive points i. Each lane takes the point that is some places behind its
  // own, the same number for all lanes. The number grows until no lane is within reach.
  template <int Dimension, class Flush>
  static void collect_within(const Run<Dimension>& run, Near_question near,
                             Found_pairs& found, const Flush& flush)
  {
    for(Place i = 0; i < run.size; i += lanes) {
      for(Place j = i + 1;; ++j) {
        double s[lanes];
        int is_any_in_reach = 0;
        for(Place lane = 0; lane < lanes; ++lane) {
          const double gap = run.x[0][j + lane] - run.x[0][i + lane];
          s[lane] = gap * gap;
          is_any_in_reach |= gap <= near.reach;
        }
        if(!is_any_in_reach)
          break;
        for(int axis = 1; axis < Dimension; ++axis)
          for(Place lane = 0; lane < lanes; ++lane) {
            const double gap = run.x[axis][j + lane] - run.x[axis][i + lane];
            s[lane] += gap * gap;
          }
        append<true>(i, j, s, near.filter, found);
        if(found.count >= Found_pairs::capacity && !flush())
          return;
      }
    }
  }

  // Collects such pairs of a point of run a and a point of run b. The lanes are consecutive points
  // of a. All lanes take the same point of b.
  template <int Dimension, class Flush>
  static void collect_between(const Run<Dimension>& a, const Run<Dimension>& b,
                              Near_question near, Found_pairs& found,
                              const Flush& flush)
  {
    Place first = 0; // points of b before it are too low for all later points of a
    for(Place i = 0; i < a.size; i += lanes) {
      const double low = a.x[0][i] - near.reach; // no coordinate within reach is below
      while(b.x[0][first] < low)
        ++first;
      const double high = a.x[0][(std::min)(i + lanes, a.size) - 1] + near.reach;
      for(Place j = first; b.x[0][j] <= high; ++j) {
        double s[lanes] = {};
        for(int axis = 0; axis < Dimension; ++axis) {
          const double y = b.x[axis][j];
          for(Place lane = 0; lane < lanes; ++lane) {
            const double gap = a.x[axis][i + lane] - y;
            s[lane] += gap * gap;
          }
        }
        append<false>(i, j, s, near.filter, found);
        if(found.count >= Found_pairs::capacity && !flush())
          return;
      }
    }
  }

private:
  // Appends the pairs {i + lane, j + lane} or {i + lane, j} whose squared distance is not certainly
  // beyond the bound.
  template <bool moves_j>
  static void append(Place i, Place j, const double (&squared_distances)[lanes],
                     const Distance_filter& filter, Found_pairs& found)
  {
    int is_any_undecided = 0;
    Place count = found.count;
    for(Place lane = 0; lane < lanes; ++lane) {
      const double s = squared_distances[lane];
      found.pairs[count] = {i + lane, moves_j ? j + lane : j};
      count += s <= filter.outside;
      is_any_undecided |= (s > filter.inside) & (s <= filter.outside);
    }
    found.count = count;
    found.is_any_undecided |= is_any_undecided != 0;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_PLAIN_H
