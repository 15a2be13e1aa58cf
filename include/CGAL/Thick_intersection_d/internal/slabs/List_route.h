// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_ROUTE_H

// The slab route for lists of neighbors. Lists grow while their slab is in the window, and are
// complete when it leaves. So no pair is stored, and each list is moved as a whole.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/slabs/List_bins.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_column.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_lists.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_route.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/report_all_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/sweep_blocks.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class List_route
{
  static constexpr int dimension = Point::dimension;

public:
  // As for Slab_route.
  List_route(Near_points<dimension>& points, const Near_task<dimension>& task,
             const Slab_tuning& tuning = Slab_tuning())
    : points_(points), task_(task), tuning_(tuning), route_(points, task, tuning)
  {}

  // Gives the lists of neighbors to the bins of each thread. Gives the pairs instead if all pairs
  // are within the bound, or if threads have to share a slab. Returns false iff the search was
  // stopped; then some pairs are missing, on one side or on both.
  bool search(List_taker& taker)
  {
    if(are_all_pairs(task_) || !sweep_all_slabs(taker))
      return route_.search(taker);
    return !route_.stop().is_set();
  }

private:
  static constexpr int axis = Point::slab_axis;

  // Whether each slab fits in a cache, or has no more points than two of the blocks that threads
  // take have on average.
  bool are_small(const Slabs<Point>& slabs, std::size_t blocks) const
  {
    const std::size_t max_size = (std::max)(static_cast<std::size_t>(tuning_.max_slab_size),
                                            2 * static_cast<std::size_t>(slabs.size()) / blocks);
    for(Place slab = 0; slab < slabs.slab_count(); ++slab)
      if(slabs.size(slab) > max_size)
        return false;
    return true;
  }

  // Returns false, and sweeps nothing, if threads have to share a slab.
  bool sweep_all_slabs(List_taker& taker)
  {
    const Slabs<Point> slabs = route_.slabs();
    const std::size_t count = task_.threads.block_count();
    if(!are_small(slabs, count))
      return false;
    sweep_blocks<Sweeper>(
      slabs, task_.threads, route_.stop(),
      [&](Place column, Place first) {
        const Slab_column<Point> column_of_slabs(slabs, column, route_.reach(), true);
        return std::make_unique<Sweeper>(*this, column_of_slabs, first);
      },
      [&](Sweeper& sweeper, Place last) { sweep_slabs(sweeper, last, taker.local_lists()); });
    return true;
  }

  // What makes the lists of slabs that follow each other, from the slab `first` on. The slab before
  // it belongs to another block, whose thread makes its lists. So it is swept with these slabs once
  // more, but not with itself. Slabs are two reaches high, so further slabs are beyond reach.
  struct Sweeper
  {
    CGAL_THICK_INTERSECTION_D_RARELY_CALLED
    Sweeper(List_route& route, const Slab_column<Point>& slabs, Place first)
      : first(first), lists(slabs.count()),
        near_sweep(route.route_.question(), route.points_, route.task_, lists, route.route_.stop(),
                   lists.positions()),
        slab_sweep(route.route_.reach(), near_sweep),
        window(slabs, route.route_.reach(), first == 0 ? 0 : first - 1, route.tuning_, &lists)
    {}

    CGAL_THICK_INTERSECTION_D_RARELY_CALLED ~Sweeper() {}

    const Place first;
    Slab_lists lists;
    Near_sweep<Point> near_sweep;
    Slab_sweep<Point> slab_sweep;
    Slab_window<Point> window;
  };

  // Makes the lists of the points in the slabs before `last`.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void sweep_slabs(Sweeper& sweeper, Place last, List_bins& bins)
  {
    Slab_window<Point>& window = sweeper.window;
    Slabs_nearby<Point> nearby;
    for(; window.slab() < last && !route_.stop().is_set(); window.pop()) {
      window.find_within_reach(window.front()->interval(axis).high, nearby);
      if(window.slab() < sweeper.first) {
        nearby.drop_before(sweeper.first);
        sweeper.slab_sweep.between(*window.front(), nearby);
        sweeper.lists.drop();
      }
      else {
        route_.sweep_slab(*window.front(), nearby, sweeper.slab_sweep, sweeper.near_sweep);
        sweeper.lists.finish(*window.front(), bins);
      }
    }
    route_.publish(sweeper.near_sweep.take_counts());
  }

  Near_points<dimension>& points_;
  const Near_task<dimension>& task_;
  const Slab_tuning tuning_;
  Slab_route<Point> route_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_ROUTE_H
