// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H

// The fast route for points in the plane and in space: their doubles are ordered into slabs, and
// swept; only pairs that the doubles do not decide are looked up in the user's range.

#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/input/Point_doubles.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The dimension of a type of points, or `fallback` if it does not tell.
template <class Point>
constexpr int dimension_or(int fallback)
{
  using Dimension = typename Ambient_dimension<Point>::type;
  if constexpr(std::is_same_v<Dimension, Dynamic_dimension_tag>)
    return fallback;
  else
    return Dimension::value;
}

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

// Returns the axes of a search: those along which the points differ, at most `Dimension`, and as
// many others as are missing to that number, in ascending order.
template <int Dimension>
std::array<int, Dimension> searched_axes(const Scene_profile& profile)
{
  std::array<int, Dimension> axes;
  int missing = Dimension - profile.extended_axes();
  int count = 0;
  for(int axis = 0; axis < profile.dimension(); ++axis)
    if(profile.range(axis).first < profile.range(axis).second || missing-- > 0)
      axes[count++] = axis;
  return axes;
}

// Searches along `Dimension` axes, which suffice to tell the points apart.
template <class ConcurrencyTag, int Dimension, class Elements>
class Slab_route
{
  using Point = typename Elements::value_type;

  // Along all axes, if the type of the points tells that these are no more.
  static constexpr bool takes_all_axes = dimension_or<Point>(0) == Dimension;
  using All_doubles = Doubles<Elements>;
  using Some_doubles = std::conditional_t<takes_all_axes, const All_doubles&,
                                          const Doubles_along_axes<Dimension, All_doubles>>;

public:
  // Coordinates are not less than their doubles, and not greater by more than `error`.
  Slab_route(const Elements& points, const All_doubles& doubles, double error,
             const Scene_profile& profile, const Is_within_distance<Point>& is_within,
             const Part_sizes& sizes = Part_sizes())
    : points_(points), axes_(searched_axes<Dimension>(profile)),
      doubles_(some_doubles(doubles, axes_)), profile_(profile),
      reach_(padded(is_within.bound().reach(), error)), filter_(is_within.filter()),
      wide_filter_(widen(filter_, is_within.bound(), error)), sizes_(sizes), is_within_(is_within)
  {}

  // Reports the pairs of one set. Returns false iff the search was stopped.
  template <class Report, class Progress>
  bool search(Report& report, Progress& progress) const
  {
    if(is_within_bound_as_a_whole())
      return report_all(points_.size(), 0, report, progress);
    const Slabs<Dimension> slabs = make_slabs(0, points_.size());
    sweep_slabs(slabs, report, [&](auto& sweep, Place first, Place last) {
      Slab_window<Dimension> window(slabs, reach_, first, sizes_);
      Slabs_nearby near;
      for(; window.slab() < last && !report.is_stopped(); window.pop()) {
        const Range range = window[0]->range(axis);
        near.assign(1, window[0]);
        for(std::size_t f = 1; const auto* strips = window.within_reach(f, range.high); ++f)
          near.push_back(strips);
        sweep_in_shares(*window[0], near, sweep, report, progress);
      }
    });
    return !report.is_stopped();
  }

  // Reports the pairs between the first `first_set_size` points and the others, likewise.
  template <class Report, class Progress>
  bool search(std::size_t first_set_size, Report& report, Progress& progress) const
  {
    if(is_within_bound_as_a_whole())
      return report_all(first_set_size, first_set_size, report, progress);
    const Slabs<Dimension> slabs = make_slabs(0, first_set_size);
    const Slabs<Dimension> other_slabs = make_slabs(first_set_size, points_.size());
    sweep_slabs(slabs, report, [&](auto& sweep, Place first, Place last) {
      Slab_window<Dimension> window(slabs, reach_, first, sizes_);
      if(window.slab() >= last)
        return;
      const Place lowest = other_slabs.slab_of(window[0]->range(axis).low - reach_);
      Slab_window<Dimension> others(other_slabs, reach_, lowest, sizes_);
      Slabs_nearby near;
      for(; window.slab() < last && !report.is_stopped(); window.pop()) {
        const Range range = window[0]->range(axis);
        while(others[0] && range.low - others[0]->range(axis).high > reach_)
          others.pop();
        near.clear();
        for(std::size_t f = 0; const auto* strips = others.within_reach(f, range.high); ++f)
          near.push_back(strips);
        sweep_in_shares(*window[0], near, sweep, report, progress);
      }
    });
    advance(progress, other_slabs.size(), report);
    return !report.is_stopped();
  }

private:
  static constexpr int axis = Dimension - 1; // of those searched, that slabs are cut along

  using Slabs_nearby = std::vector<const Strips<Dimension>*>;

  struct Decide
  {
    const Slab_route& route;

    bool operator()(Place i, Place j, Decision_counts& counts) const
    {
      return route.is_within_.decide(route.points_[i], route.points_[j], counts);
    }
  };

  template <class Report>
  using Sweep = Slab_sweep<Dimension, Decide, Report>;

  template <class Report>
  Sweep<Report> make_sweep(Report& report) const
  {
    return Sweep<Report>(reach_, wide_filter_, is_within_.close_call(), {*this}, report);
  }

  static Some_doubles some_doubles(const All_doubles& doubles,
                                   const std::array<int, Dimension>& axes)
  {
    if constexpr(takes_all_axes)
      return doubles;
    else
      return Some_doubles(doubles, axes);
  }

  // Whether no two points of the scene are farther apart than the bound, for sure.
  bool is_within_bound_as_a_whole() const
  {
    double s = 0;
    for(const int i : axes_) {
      const double extent = profile_.range(i).second - profile_.range(i).first;
      s += extent * extent;
    }
    return s <= filter_.inside;
  }

  // Reports each point before `end` with all points that are behind it and not before `first`.
  template <class Report, class Progress>
  bool report_all(std::size_t end, std::size_t first, Report& report, Progress& progress) const
  {
    for_each_block<ConcurrencyTag>(end, [&](std::size_t i, std::size_t last) {
      Decision_counts counts;
      for(; i != last && !report.is_stopped(); ++i) {
        const std::size_t start = (std::max)(i + 1, first);
        std::size_t j = start;
        while(j < points_.size() && report(i, j))
          ++j;
        counts.add(Arithmetic_tier::DOUBLE, j - start);
        advance(progress, 1, report);
      }
      publish(counts);
    });
    advance(progress, points_.size() - end, report);
    return !report.is_stopped();
  }

  void publish(const Decision_counts& counts) const
  {
    if(is_within_.shared_counts() != nullptr)
      is_within_.shared_counts()->add(counts);
  }

  template <class Progress, class Report>
  static void advance(Progress& progress, std::size_t finished, Report& report)
  {
    if(!report.is_stopped() && !progress.advance(finished))
      report.stop();
  }

  // Calls task(sweep, first, last) for blocks of slabs.
  template <class Report, class Task>
  void sweep_slabs(const Slabs<Dimension>& slabs, Report& report, const Task& task) const
  {
    const std::size_t count = block_count<ConcurrencyTag>();
    for_each_block<ConcurrencyTag>(count, [&](std::size_t block, std::size_t end) {
      for(; block != end; ++block) {
        Sweep<Report> sweep = make_sweep(report);
        const auto [first, last] = slabs.block(block, count);
        if(first != last)
          task(sweep, first, last);
        publish(sweep.counts());
      }
    });
  }

  // Sweeps a slab with those nearby: where very many points crowd, in shares, which may be swept at
  // the same time, and after each of which the search can be stopped.
  template <class Report, class Progress>
  void sweep_in_shares(const Strips<Dimension>& slab, const Slabs_nearby& nearby,
                       Sweep<Report>& sweep, Report& report, Progress& progress) const
  {
    const Place count = share_count(slab, nearby);
    if(count == 1) {
      sweep.between(slab, nearby);
      advance(progress, slab.size(), report);
      return;
    }
    for_each_block<ConcurrencyTag>(count, [&](std::size_t s, std::size_t last) {
      Sweep<Report> sweep_of_share = make_sweep(report);
      for(; s != last && !report.is_stopped(); ++s) {
        sweep_of_share.take_share(static_cast<Place>(s), count);
        sweep_of_share.between(slab, nearby);
        advance(progress, slab.size() * (s + 1) / count - slab.size() * s / count, report);
      }
      publish(sweep_of_share.counts());
    });
  }

  // So many that each takes milliseconds.
  Place share_count(const Strips<Dimension>& slab, const Slabs_nearby& nearby) const
  {
    constexpr double greatest_count = 1024;
    double crowd = 0;
    for(const Strips<Dimension>* other : nearby)
      crowd += std::sqrt(slab.crowd() * other->crowd());
    return static_cast<Place>((std::min)(crowd / sizes_.crowd, greatest_count)) + 1;
  }

  // Returns the slabs of the points at the positions [first, last).
  Slabs<Dimension> make_slabs(std::size_t first, std::size_t last) const
  {
    const Range range = {profile_.range(axes_[axis]).first, profile_.range(axes_[axis]).second};
    return Slabs<Dimension>(ConcurrencyTag(), doubles_, first, last, range, reach_, sizes_);
  }

  // Doubles that are off by up to `error` upwards differ by that much more.
  static double padded(double reach, double error)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return error == 0 ? reach : std::nextafter(reach + error, infinity);
  }

  const Elements& points_;
  const std::array<int, Dimension> axes_;
  Some_doubles doubles_;
  const Scene_profile& profile_;
  const double reach_;
  const Distance_filter filter_;
  const Distance_filter wide_filter_;
  const Part_sizes sizes_;
  const Is_within_distance<Point>& is_within_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_ROUTE_H
