// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PART_REPORTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PART_REPORTER_H

// Reports the pairs of a part on disk by the ids of their points.

#include <CGAL/Thick_intersection_d/internal/external/Searched_points.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_reporter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// What a search of a part calls back: callback(i, j) with ids i < j.
template <int Dimension, class Callback>
struct Part_report
{
  const Searched_points<Dimension>& points;
  Callback& callback;
};

// Gets the numbers of points. Drops the pairs of two points that were given: they are found
// elsewhere.
template <int Dimension, class Callback>
class Pair_reporter<const Part_report<Dimension, Callback>>
{
  using Points = Searched_points<Dimension>;

public:
  explicit Pair_reporter(const Part_report<Dimension, Callback>& report)
    : points_(report.points), report_(report.callback)
  {}

  bool operator()(std::size_t i, std::size_t j)
  {
    if(!points_.is_owned(i) && !points_.is_owned(j))
      return true;
    const auto [low, high] = std::minmax({points_.id(i), points_.id(j)});
    return report_(low, high);
  }

  // Most pairs have two ids. A loop of them alone stores nothing and looks up nothing, as that of
  // Near_sweep. This makes short callbacks fast. It ends at the first other pair.
  bool report_pairs(const Found_pair* pairs, Place count)
  {
    for(Place c = 0; c < count; ++c) {
      if(!Points::is_id(pairs[c].i & pairs[c].j))
        return report_each(pairs + c, count - c);
      if(!report_(Points::short_id(pairs[c].i), Points::short_id(pairs[c].j)))
        return false;
    }
    return true;
  }

  void stop() { report_.stop(); }
  bool is_stopped() const { return report_.is_stopped(); }

private:
  BOOST_NOINLINE bool report_each(const Found_pair* pairs, Place count)
  {
    return std::all_of(pairs, pairs + count,
                       [this](const Found_pair& pair) { return (*this)(pair.i, pair.j); });
  }

  const Points& points_;
  Pair_reporter<Callback> report_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PART_REPORTER_H
