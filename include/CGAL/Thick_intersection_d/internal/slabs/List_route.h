// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_ROUTE_H

// The slab route for lists of neighbors. Lists grow while their slab is in the window, and are
// complete when it leaves. So no pair is stored, and each list is moved as a whole.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_column.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_lists.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_route.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <CGAL/assertions.h> // CGAL_unreachable

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Test` is as for Slab_route.
template <class ConcurrencyTag, class Test>
class List_route
{
  using Point = typename Test::Point;
  using Slabs_nearby = typename Slab_window<Point>::Slabs_nearby;
  using All_slabs = Slabs_of<ConcurrencyTag, Test>;

public:
  List_route(const Test& test, const Slab_tuning& tuning = Slab_tuning())
    : test_(test), reach_(test.reach()), tuning_(tuning), route_(test, tuning)
  {}

  // Hands the lists of neighbors to collector.local_lists() of each thread. Reports the pairs
  // instead if all pairs are within the bound, or if threads have to share a slab. Returns false
  // iff the search was stopped; then some pairs are missing, on one side or on both.
  template <class Sets, class Collector, class Report, class Progress>
  bool search(const Sets& sets, Collector& collector, Report& report, Progress& progress) const
  {
    static_assert(!Sets::are_two, "The neighbors of a point are in its own set.");
    if(test_.are_all_pairs())
      return route_.report_all(Point_sets(), report, progress);
    if(sweep_all_slabs(collector, report, progress))
      return !report.is_stopped();
    if constexpr(is_parallel_v<ConcurrencyTag>)
      return route_.search(sets, report, progress);
    else
      CGAL_unreachable(); // no slab is too large for one thread
  }

private:
  static constexpr int axis = Point::slab_axis;

  // Whether each slab fits in a cache, or has no more points than two of the blocks that threads
  // take have on average.
  bool are_small(const All_slabs& slabs, std::size_t blocks) const
  {
    const std::size_t max_size = (std::max)(static_cast<std::size_t>(tuning_.max_slab_size),
                                            2 * static_cast<std::size_t>(slabs.size()) / blocks);
    for(Place slab = 0; slab < slabs.count() * slabs.columns().count(); ++slab)
      if(slabs.size(slab) > max_size)
        return false;
    return true;
  }

  // Returns false, and sweeps nothing, if threads have to share a slab.
  template <class Collector, class Report, class Progress>
  bool sweep_all_slabs(Collector& collector, Report& report, Progress& progress) const
  {
    const All_slabs slabs(ConcurrencyTag(), test_, test_.size(), reach_, Point_sets(), tuning_);
    const std::size_t count = block_count<ConcurrencyTag>();
    if(!are_small(slabs, count))
      return false;
    for_each_block<ConcurrencyTag>(count, [&](std::size_t block, std::size_t end) {
      try {
        for(; block != end; ++block) {
          const std::pair<Place, Place> range = slabs.block(block, count);
          for_each_column(slabs, range.first, range.second, reach_, true,
                          [&](const auto& column, Place first, Place last) {
                            sweep_slabs(column, first, last, collector.local_lists(), report,
                                        progress);
                          });
        }
      }
      catch(...) {
        report.stop();
        throw;
      }
    });
    return true;
  }

  // Makes the lists of the points in the slabs [first, last). The slab before them belongs to
  // another block, whose thread makes its lists. So it is swept with these slabs once more, but not
  // with itself. Slabs are two reaches high, so further slabs are beyond reach.
  template <class Source, class Bins, class Report, class Progress>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void sweep_slabs(const Source& slabs, Place first, Place last, Bins& bins, Report& report,
                   Progress& progress) const
  {
    Slab_lists<Report> lists(report, slabs.count());
    Near_sweep<Test, Slab_lists<Report>> near_sweep(test_, lists);
    Slab_sweep<Point> sweep(reach_, near_sweep);
    const auto number = [&](Strips<Point>& slab) { lists.number(slab); };
    Slab_window<Point, decltype(number), Source> window(slabs, reach_, first == 0 ? 0 : first - 1,
                                                        tuning_, number);
    Slabs_nearby nearby;
    for(; window.slab() < last && !report.is_stopped(); window.pop()) {
      window.find_within_reach(window.front()->interval(axis).high, nearby);
      if(window.slab() < first) {
        nearby.drop_before(first);
        sweep.between(*window.front(), nearby);
        lists.drop();
      }
      else {
        route_.sweep_slab(*window.front(), nearby, sweep, near_sweep, report, progress);
        if constexpr(is_parallel_v<ConcurrencyTag>)
          lists.finish_without_border(*window.front(), bins);
        else
          lists.finish(bins);
      }
    }
    test_.publish(near_sweep.counts());
  }

  const Test& test_;
  const double reach_;
  const Slab_tuning tuning_;
  const Slab_route<ConcurrencyTag, Test> route_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_ROUTE_H
