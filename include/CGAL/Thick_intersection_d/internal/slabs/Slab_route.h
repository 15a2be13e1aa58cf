// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H

// The fast route. It moves the points into slabs. Then it makes one slab after another ready, and
// sweeps it with the slabs within reach. It looks up only those candidates in the user's range that
// doubles and integers do not decide.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Point_reader.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_column.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/slabs/report_all_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/sweep_blocks.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the question that lanes ask about numbers in slabs.
template <class Number, int Dimension>
Near_question<Number> question_of(const Near_task<Dimension>& task)
{
  if constexpr(std::is_same_v<Number, double>)
    return {task.near.reach, task.near.filter.inside, task.near.filter.outside};
  else
    return task.scale.question();
}

template <class Point>
class Slab_route
{
  static constexpr int dimension = Point::dimension;
  using Number = typename Point::Number;
  using Slabs_nearby = internal::Slabs_nearby<Point>;

public:
  // The scale of the task must be usable if the numbers are integers.
  Slab_route(Near_points<dimension>& points, const Near_task<dimension>& task,
             const Slab_tuning& tuning = Slab_tuning())
    : points_(points), task_(task), question_(question_of<Number>(task)), tuning_(tuning)
  {}

  // Gives the pairs to the taker. Returns false iff the search was stopped.
  bool search(Result_taker& taker)
  {
    if(are_all_pairs(task_))
      report_all_pairs(points_, task_, taker, stop_);
    else
      sweep_all_slabs(slabs(), taker);
    return !stop_.is_set();
  }

  const Near_question<Number>& question() const { return question_; }
  double reach() const { return static_cast<double>(question_.reach); }
  Stop_flag& stop() { return stop_; }

  // Moves the points into slabs.
  Slabs<Point> slabs() const
  {
    return Slabs<Point>(Point_reader<dimension, Number>(points_, task_), reach(), task_.sets,
                        task_.threads, tuning_);
  }

  // Sweeps a slab with the slabs nearby, in blocks if there are very many candidates. The search
  // can stop after each block.
  void sweep_slab(const Strips<Point>& slab, const Slabs_nearby& nearby, Slab_sweep<Point>& sweep,
                  Near_sweep<Point>& blocks)
  {
    const Place count = sweep_block_count(slab, nearby);
    for(Place block = 0; block != count && !stop_.is_set(); ++block)
      sweep_block(slab, nearby, block, count, sweep, blocks);
  }

  void publish(const Decision_counts& counts) const
  {
    if(task_.counts != nullptr)
      task_.counts->add(counts);
  }

private:
  static constexpr int axis = Point::slab_axis;

  // What sweeps slabs that follow each other, from one on.
  struct Sweeper
  {
    CGAL_THICK_INTERSECTION_D_RARELY_CALLED
    Sweeper(Slab_route& route, const Slab_column<Point>& slabs, Place first, Pair_taker& taker)
      : window(slabs, route.reach(), first, route.tuning_),
        near_sweep(route.question_, route.points_, route.task_, taker, route.stop_),
        slab_sweep(route.reach(), near_sweep)
    {}

    CGAL_THICK_INTERSECTION_D_RARELY_CALLED ~Sweeper() {}

    Slab_window<Point> window;
    Near_sweep<Point> near_sweep;
    Slab_sweep<Point> slab_sweep;
  };

  // Sweeps all slabs, in blocks that threads may sweep at the same time.
  void sweep_all_slabs(const Slabs<Point>& slabs, Pair_taker& taker)
  {
    sweep_blocks<Sweeper>(
      slabs, task_.threads, stop_,
      [&](Place column, Place first) {
        const Slab_column<Point> column_of_slabs(slabs, column, reach(), false);
        return std::make_unique<Sweeper>(*this, column_of_slabs, first, taker);
      },
      [&](Sweeper& sweeper, Place last) { sweep_slabs(sweeper, last, taker); });
  }

  // Sweeps each of the slabs before `last` with itself and with the slabs within reach behind it.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void sweep_slabs(Sweeper& sweeper, Place last, Pair_taker& taker)
  {
    Slab_window<Point>& window = sweeper.window;
    Slabs_nearby nearby;
    for(; window.slab() < last && !stop_.is_set(); window.pop()) {
      window.find_within_reach(window.front()->interval(axis).high, nearby);
      if constexpr(Point::may_be_shared)
        if(const Place count = sweep_block_count(*window.front(), nearby);
           count > 1 && task_.threads.are_many()) {
          sweep_in_blocks(*window.front(), nearby, count, taker);
          continue;
        }
      sweep_slab(*window.front(), nearby, sweeper.slab_sweep, sweeper.near_sweep);
    }
    publish(sweeper.near_sweep.take_counts());
  }

  // As sweep_slab(), in blocks that threads may sweep at the same time.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void sweep_in_blocks(const Strips<Point>& slab, const Slabs_nearby& nearby,
                                          Place count, Pair_taker& taker)
  {
    stop_.run_blocks(task_.threads, count, [&](std::size_t block, std::size_t last) {
      Near_sweep<Point> near_sweep(question_, points_, task_, taker, stop_);
      Slab_sweep<Point> sweep_of_block(reach(), near_sweep);
      for(; block != last && !stop_.is_set(); ++block)
        sweep_block(slab, nearby, block, count, sweep_of_block, near_sweep);
      publish(near_sweep.take_counts());
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

  void sweep_block(const Strips<Point>& slab, const Slabs_nearby& nearby, std::size_t block,
                   std::size_t count, Slab_sweep<Point>& sweep, Near_sweep<Point>& blocks)
  {
    blocks.take_block(static_cast<Place>(block), static_cast<Place>(count));
    sweep.between(slab, nearby);
    const std::size_t size = slab.own_size();
    const std::size_t finished = size * (block + 1) / count - size * block / count;
    if(!stop_.is_set() && !points_.advance(finished))
      stop_.set();
  }

  Near_points<dimension>& points_;
  const Near_task<dimension>& task_;
  const Near_question<Number> question_;
  const Slab_tuning tuning_;
  Stop_flag stop_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H
