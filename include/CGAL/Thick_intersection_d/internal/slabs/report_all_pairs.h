// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_REPORT_ALL_PAIRS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_REPORT_ALL_PAIRS_H

// Reports the pairs of a scene whose box is no longer than the bound: all of them.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether all pairs of points are certainly within the bound.
template <int Dimension>
bool are_all_pairs(const Near_task<Dimension>& task)
{
  double s = 0;
  for(const Interval& interval : task.box) {
    const double length = interval.high * task.near.scale - interval.low * task.near.scale;
    s += length * length;
  }
  return s <= task.near.filter.inside;
}

// Gives the pairs of the point at position i with the points from the position `first` on. Returns
// false iff the search was stopped.
template <int Dimension>
bool give_pairs_of(Place i, Place first, const Near_points<Dimension>& points, Result_taker& taker)
{
  const Place last = static_cast<Place>(points.size);
  if(!points.are_numbered)
    return taker.take_row(i, first, last);
  constexpr Place most = 256;
  Place number = 0;
  points.read_numbers(i, 1, &number);
  std::array<Place, most> others;
  std::array<Found_pair, most> pairs;
  for(Place count = 0; first < last; first += count) {
    count = (std::min)(last - first, most);
    points.read_numbers(first, count, others.data());
    for(Place p = 0; p < count; ++p)
      pairs[p] = {(std::min)(number, others[p]), (std::max)(number, others[p])};
    if(!taker.take(pairs.data(), count))
      return false;
  }
  return true;
}

// Reports each point with all points behind it; each point of the first of two sets with all points
// of the second.
template <int Dimension>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
void report_all_pairs(Near_points<Dimension>& points, const Near_task<Dimension>& task,
                      Result_taker& taker, Stop_flag& stop)
{
  const std::size_t second = task.sets.are_two() ? task.sets.first_size : 0;
  const std::size_t end = task.sets.are_two() ? task.sets.first_size : points.size;
  const auto advance = [&](std::size_t finished) {
    if(!stop.is_set() && !points.advance(finished))
      stop.set();
  };
  stop.run_blocks(task.threads, end, [&](std::size_t position, std::size_t last) {
    Decision_counts counts;
    for(; position != last && !stop.is_set(); ++position) {
      const std::size_t first = (std::max)(position + 1, second);
      counts.add(Arithmetic_tier::DOUBLE, points.size - first);
      if(!give_pairs_of(static_cast<Place>(position), static_cast<Place>(first), points, taker))
        stop.set();
      advance(1);
    }
    if(task.counts != nullptr)
      task.counts->add(counts);
  });
  advance(points.size - end);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_REPORT_ALL_PAIRS_H
