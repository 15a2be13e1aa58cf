// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_PLAIN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_PLAIN_H

// Meeting pairs of boxes, by plain loops over lanes. Compilers turn the loops into vector
// instructions.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Box_run.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>

#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Meeting_boxes_plain
{
  static bool is_supported() { return true; }

  // Collects the pairs of a box of run a and one of its candidates in run b that meet along all
  // axes. Calls flush() when there are many pairs. It returns false to stop.
  //
  // The lanes are consecutive boxes of b. The last of them may be behind the candidates: such a box
  // begins behind the box of a, so it does not meet it.
  template <int Axes, class Flush>
  static void collect_between(const Box_run<Axes>& a, const Box_run<Axes>& b, Found_pairs& found,
                              const Flush& flush)
  {
    for(Place i = a.first; i < a.last; ++i)
      for(Place j = a.begins[i]; j < a.ends[i]; j += lanes) {
        append(a, i, b, j, found);
        if(found.is_full() && !flush())
          return;
      }
  }

private:
  // Appends the pairs {i, j + lane} that meet. The branch on whether a pair meets cannot be
  // predicted. So every pair is stored, and the counter advances only for those that meet.
  template <int Axes>
  static void append(const Box_run<Axes>& a, Place i, const Box_run<Axes>& b, Place j,
                     Found_pairs& found)
  {
    std::int64_t meets[lanes];
    for(Place lane = 0; lane < lanes; ++lane)
      meets[lane] = 1;
    for(int axis = 0; axis < Axes; ++axis) {
      const double low = a.low[axis][i];
      const double high = a.high[axis][i];
      for(Place lane = 0; lane < lanes; ++lane)
        meets[lane] &= int(b.low[axis][j + lane] <= high) & int(b.high[axis][j + lane] >= low);
    }
    Place count = found.count;
    for(Place lane = 0; lane < lanes; ++lane) {
      found.pairs[count] = {i, j + lane};
      count += static_cast<Place>(meets[lane]);
    }
    if(count == found.count + lanes)
      found.rows[found.row_count++] = {i, j};
    else
      found.count = count;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_MEETING_BOXES_PLAIN_H
