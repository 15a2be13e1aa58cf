// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H

// The fast route. It moves the elements into slabs. Then it makes one slab after another ready, and
// sweeps it with the slabs within reach. It looks up only those candidates in the user's range that
// doubles and integers do not decide.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_column.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs_nearby.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Test` is a source for Slabs and a test for Near_sweep. It also has a type Point, like
// Slab_point, whose runs are its own, a constant has_numbers, and the functions size(), reach(),
// number(position), are_all_pairs() and publish(counts), as Near_points does.
template <class ConcurrencyTag, class Test>
class Slab_route
{
  using Point = typename Test::Point;
  using Slabs_nearby = internal::Slabs_nearby<Point>;
  using All_slabs = Slabs_of<ConcurrencyTag, Test>;

public:
  Slab_route(const Test& test, const Slab_tuning& tuning = Slab_tuning())
    : test_(test), reach_(test.reach()), tuning_(tuning)
  {}

  // Reports the pairs. Returns false iff the search was stopped.
  template <class Sets, class Report, class Progress>
  bool search(const Sets& sets, Report& report, Progress& progress) const
  {
    Point_sets point_sets;
    if constexpr(Sets::are_two)
      point_sets.first_size = static_cast<Place>(sets.first_size);
    if(test_.are_all_pairs())
      return report_all(point_sets, report, progress);
    sweep_all_slabs(
      All_slabs(ConcurrencyTag(), test_, test_.size(), reach_, point_sets, tuning_), report,
      progress);
    return !report.is_stopped();
  }

  // Reports each element with all elements behind it; each element of the first of two sets with
  // all elements of the second.
  template <class Report, class Progress>
  BOOST_NOINLINE bool report_all(const Point_sets& sets, Report& report, Progress& progress) const
  {
    const std::size_t first = sets.are_two() ? sets.first_size : 0;
    const std::size_t end = sets.are_two() ? sets.first_size : test_.size();
    for_each_block<ConcurrencyTag>(end, [&](std::size_t i, std::size_t last) {
      Decision_counts counts;
      for(; i != last && !report.is_stopped(); ++i) {
        const std::size_t start = (std::max)(i + 1, first);
        std::size_t j = start;
        while(j < test_.size() && report(test_.number(i), test_.number(j)))
          ++j;
        counts.add(Arithmetic_tier::DOUBLE, j - start);
        advance(progress, 1, report);
      }
      test_.publish(counts);
    });
    advance(progress, test_.size() - end, report);
    return !report.is_stopped();
  }

  // Sweeps a slab with the slabs nearby, in blocks if there are very many candidates. The search
  // can stop after each block.
  template <class Report, class Progress>
  void sweep_slab(const Strips<Point>& slab, const Slabs_nearby& nearby, Slab_sweep<Point>& sweep,
                  typename Slab_sweep<Point>::Sweep_of_runs& blocks, Report& report,
                  Progress& progress) const
  {
    const Place count = sweep_block_count(slab, nearby);
    for(Place block = 0; block != count && !report.is_stopped(); ++block)
      sweep_block(slab, nearby, block, count, sweep, blocks, report, progress);
  }

private:
  static constexpr int axis = Point::slab_axis;

  // Sweeps all slabs, in blocks that threads may sweep at the same time.
  template <class Report, class Progress>
  void sweep_all_slabs(const All_slabs& slabs, Report& report, Progress& progress) const
  {
    const std::size_t count = block_count<ConcurrencyTag>();
    for_each_block<ConcurrencyTag>(count, [&](std::size_t block, std::size_t end) {
      for(; block != end; ++block) {
        const std::pair<Place, Place> range = slabs.block(block, count);
        for_each_column(slabs, range.first, range.second, reach_, false,
                        [&](const auto& column, Place first, Place last) {
                          sweep_slabs(column, first, last, report, progress);
                        });
      }
    });
  }

  // Sweeps each of the slabs [first, last) with itself and with the slabs within reach behind it.
  template <class Source, class Report, class Progress>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void sweep_slabs(const Source& slabs, Place first, Place last, Report& report,
                                      Progress& progress) const
  {
    Slab_window<Point, Leave_slab, Source> window(slabs, reach_, first, tuning_);
    Near_sweep<Test, Report> near_sweep(test_, report);
    Slab_sweep<Point> sweep(reach_, near_sweep);
    Slabs_nearby nearby;
    for(; window.slab() < last && !report.is_stopped(); window.pop()) {
      window.find_within_reach(window.front()->interval(axis).high, nearby);
      if constexpr(is_parallel_v<ConcurrencyTag>)
        if(const Place count = sweep_block_count(*window.front(), nearby); count > 1) {
          sweep_in_blocks(*window.front(), nearby, count, report, progress);
          continue;
        }
      sweep_slab(*window.front(), nearby, sweep, near_sweep, report, progress);
    }
    test_.publish(near_sweep.counts());
  }

  // As sweep_slab(), in blocks that threads may sweep at the same time.
  template <class Report, class Progress>
  BOOST_NOINLINE void sweep_in_blocks(const Strips<Point>& slab, const Slabs_nearby& nearby,
                                      Place count, Report& report, Progress& progress) const
  {
    for_each_block<ConcurrencyTag>(count, [&](std::size_t block, std::size_t last) {
      Near_sweep<Test, Report> near_sweep(test_, report);
      Slab_sweep<Point> sweep_of_block(reach_, near_sweep);
      for(; block != last && !report.is_stopped(); ++block)
        sweep_block(slab, nearby, block, count, sweep_of_block, near_sweep, report, progress);
      test_.publish(near_sweep.counts());
    });
  }

  // Returns in how many blocks to sweep a slab with the slabs nearby. Each block looks at all
  // points of the slabs, for their borders. So it has more candidates than points.
  Place sweep_block_count(const Strips<Point>& slab, const Slabs_nearby& nearby) const
  {
    double candidates = 0;
    double size = 0;
    for(const Strips<Point>* other : nearby) {
      candidates += std::sqrt(slab.candidates() * other->candidates());
      size += slab.size() + other->size();
    }
    const double count = candidates / (std::max)(tuning_.candidates_per_block, size);
    return static_cast<Place>((std::min)(count, max_block_count)) + 1;
  }

  template <class Report, class Progress>
  static void sweep_block(const Strips<Point>& slab, const Slabs_nearby& nearby, std::size_t block,
                          std::size_t count, Slab_sweep<Point>& sweep,
                          typename Slab_sweep<Point>::Sweep_of_runs& blocks, Report& report,
                          Progress& progress)
  {
    blocks.take_block(static_cast<Place>(block), static_cast<Place>(count));
    sweep.between(slab, nearby);
    const std::size_t size = is_parallel_v<ConcurrencyTag> ? slab.own_size() : slab.size();
    advance(progress, size * (block + 1) / count - size * block / count, report);
  }

  template <class Progress, class Report>
  static void advance(Progress& progress, std::size_t finished, Report& report)
  {
    if(!report.is_stopped() && !progress.advance(finished))
      report.stop();
  }

  const Test& test_;
  const double reach_;
  const Slab_tuning tuning_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H
