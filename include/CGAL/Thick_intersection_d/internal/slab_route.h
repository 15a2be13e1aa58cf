// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_ROUTE_H

// The fast route for points in the plane and in space: their doubles are ordered into slabs, and
// swept; only pairs that the doubles do not decide are looked up in the user's range.

#include <CGAL/Thick_intersection_d/internal/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/Slab_order.h>
#include <CGAL/Thick_intersection_d/internal/Slab_sweep.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the filter for doubles that are off by up to `error` along each axis, so that distances
// are off by less than twice that in up to three dimensions.
template <class Exact>
Distance_filter widen(const Distance_filter& filter, const Squared_bound<Exact>& bound,
                      double error)
{
  if(error == 0 || bound.is_unbounded())
    return filter;
  const double slack = 4 * relative_error(3);
  const double least = std::sqrt(bound.squared().first) * (1 - slack) - 2 * error;
  const double greatest = (bound.reach() + 2 * error) * (1 + slack);
  Distance_filter wide;
  if(filter.inside > 0 && least * least > std::ldexp(1., -960) && least > 0)
    wide.inside = (std::min)(filter.inside, least * least);
  wide.outside = (std::max)(filter.outside, greatest * greatest);
  return wide;
}

template <class ConcurrencyTag, int Dimension, class Elements, class Exact>
class Slab_route
{
  using Point = typename Elements::value_type;
  using Points = Slab_points<Dimension>;

public:
  Slab_route(const Elements& points, const Squared_bound<Exact>& bound,
             const Distance_filter& filter)
    : points_(points), bound_(bound), filter_(filter),
      is_within_(bound, filter, Dimension)
  {}

  // Reports the pairs of one set. Returns false iff the search was stopped.
  template <class Report, class Progress>
  bool search(Report& report, Progress& progress) const
  {
    Points points(points_, 0, points_.size());
    const double reach = padded_reach(points.error());
    const Parts slabs = Slab_order<ConcurrencyTag, Dimension>(points, reach)();
    return sweep_slabs(points, points, slabs, report, progress, [&](auto& sweep, std::size_t s) {
      return sweep.part_with_followers(slabs[s], slabs.data() + s + 1,
                                       slabs.data() + slabs.size());
    });
  }

  // Reports the pairs between the first `first_set_size` points and the others, likewise.
  template <class Report, class Progress>
  bool search(std::size_t first_set_size, Report& report, Progress& progress) const
  {
    Points a(points_, 0, first_set_size);
    Points b(points_, first_set_size, points_.size());
    const double reach = padded_reach((std::max)(a.error(), b.error()));
    const Parts slabs = Slab_order<ConcurrencyTag, Dimension>(a, reach)();
    const Parts others = Slab_order<ConcurrencyTag, Dimension>(b, reach)();
    return sweep_slabs(a, b, slabs, report, progress,
                       [&](auto& sweep, std::size_t s) {
                         return sweep.part_with_others(slabs[s], others);
                       })
           && progress.advance(b.size());
  }

private:
  // Calls sweep_slab(sweep, s) for each slab s.
  template <class Report, class Progress, class Sweep_slab>
  bool sweep_slabs(const Points& a, const Points& b, const Parts& slabs, Report& report,
                   Progress& progress, const Sweep_slab& sweep_slab) const
  {
    const auto decide
      = [&](Place i, Place j) { return is_within_(points_[i], points_[j]); };
    const double error = (std::max)(a.error(), b.error());
    const Distance_filter filter = widen(filter_, bound_, error);
    for_each_block<ConcurrencyTag>(slabs.size(), [&](std::size_t first, std::size_t last) {
      Slab_sweep<Dimension, decltype(decide), Report> sweep(a, b, padded_reach(error), filter,
                                                            decide, report);
      for(std::size_t s = first; s != last && !report.is_stopped(); ++s)
        if(sweep_slab(sweep, s) && !progress.advance(slabs[s].end - slabs[s].begin))
          report.stop();
    });
    return !report.is_stopped();
  }

  // Doubles that are off by up to `error` upwards differ by that much more.
  double padded_reach(double error) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return error == 0 ? bound_.reach() : std::nextafter(bound_.reach() + error, infinity);
  }

  const Elements& points_;
  const Squared_bound<Exact>& bound_;
  const Distance_filter filter_;
  const Is_within_distance<Point> is_within_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_ROUTE_H
