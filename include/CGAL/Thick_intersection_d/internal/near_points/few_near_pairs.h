// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_FEW_NEAR_PAIRS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_FEW_NEAR_PAIRS_H

// The search of near pairs of few points: each with each, without a scene and without memory but
// the stack.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/Point_doubles.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Callback_taker.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Element_points.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Plain_is_within.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/slabs/near_search.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether points, by their types, are searched each with each if they are few. Lists of one range
// are made of slabs in any case.
template <class Elements, class Sets, class NT, class Callback>
inline constexpr bool takes_few_points
  = has_few_doubles<typename Elements::value_type>() && is_held_by_double_v<NT>
    && !have_numbers<Elements> && !takes_lists_v<Sets, Callback>;

// Few points as runs in the order of the user, on the stack.
template <class Point>
class Few_runs
{
public:
  using Run = internal::Run<dimension_or<Point>(0), double>;

  // Returns a run of the points [first, last). All runs together have `max_few_points` at most.
  template <class Elements>
  Run make(const Elements& points, std::size_t first, std::size_t last)
  {
    are_finite_ &= read_coordinates(points, first, last, x_, end_);
    Run run = {{}, positions_.data() + end_, static_cast<Place>(last - first)};
    for(std::size_t axis = 0; axis < x_.size(); ++axis)
      run.x[axis] = x_[axis].data() + end_;
    for(; first < last; ++first)
      positions_[end_++] = static_cast<Place>(first);
    for(Place lane = 0; lane < lanes; ++lane, ++end_)
      for(auto& column : x_)
        column[end_] = end_of_run<double>(lane);
    return run;
  }

  // Whether the coordinates of all runs are finite.
  bool are_finite() const { return are_finite_; }

private:
  static constexpr std::size_t capacity = max_few_points + 2 * lanes;

  Few_coordinates<Point, capacity> x_;
  std::array<Place, capacity> positions_;
  std::size_t end_ = 0;
  bool are_finite_ = true;
};

// Reports the pairs that lanes find among few points.
template <class Elements, class Is_within, class Report>
class Few_sweep
{
  static constexpr int dimension = dimension_or<typename Elements::value_type>(0);
  using Run = internal::Run<dimension, double>;

public:
  Few_sweep(const Elements& points, Is_within& is_within, Report& report)
    : points_(points), is_within_(is_within), report_(report)
  {}

  // Reports the pairs of a run if `b` is null, or else those of a point of either run. Returns
  // false iff the report said stop.
  bool run(const Run& a, const Run* b)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Distance_filter filter = is_within_.filter();
    const auto flush = [&] { return report_found(a, b == nullptr ? a : *b); };
    collect_few_pairs<dimension>(a, b, {infinity, filter.inside, filter.outside}, found_,
                                 Flush(flush));
    return goes_on_ && flush();
  }

private:
  bool report_found(const Run& a, const Run& b)
  {
    const Place count = std::exchange(found_.count, 0);
    const Place undecided_count = std::exchange(found_.undecided_count, 0);
    for(Place c = 0; goes_on_ && c < count; ++c)
      goes_on_ = report_(found_.pairs[c].i, found_.pairs[c].j);
    for(Place c = 0; goes_on_ && c < undecided_count; ++c) {
      const Place i = a.positions[found_.undecided[c].i], j = b.positions[found_.undecided[c].j];
      if(is_within_.decide_undecided(points_[i], points_[j]))
        goes_on_ = report_(i, j);
    }
    return goes_on_;
  }

  const Elements& points_;
  Is_within& is_within_;
  Report& report_;
  Near_pairs found_;
  bool goes_on_ = true;
};

// The pairs of at most `max_few_points` points: those of one set, or of a point of one set and a
// point of another.
template <class Elements, class Sets, class NT>
class Few_near_pairs
{
  using Point = typename Elements::value_type;
  using Is_within = Plain_is_within<Point, NT>;

public:
  // The bound must be neither negative nor NaN.
  Few_near_pairs(const Elements& points, const Sets& sets, const Distance_bound<NT>& bound)
    : points_(points), first_size_(points.size()), is_within_(bound)
  {
    if constexpr(Sets::are_two)
      first_size_ = sets.first_size;
  }

  // Reports the pairs. Returns false iff the report said stop. Returns nothing, and reports none,
  // if a coordinate is not finite.
  template <class Report>
  std::optional<bool> report_to(Report& report)
  {
    return points_.size() <= lanes ? report_in_turn(report) : report_in_lanes(report);
  }

private:
  // To fill lanes takes longer than to look at the pairs of so few points.
  template <class Report>
  std::optional<bool> report_in_turn(Report& report)
  {
    Few_coordinates<Point, lanes> x;
    if(!read_coordinates(points_, 0, points_.size(), x, 0))
      return std::nullopt;
    const Distance_filter filter = is_within_.filter();
    for(std::size_t i = 0; i < first_size_; ++i)
      for(std::size_t j = Sets::are_two ? first_size_ : i + 1; j < points_.size(); ++j) {
        const double s = computed_square(x, i, j);
        if(s > filter.outside)
          continue;
        if((s <= filter.inside || is_within_.decide_undecided(points_[i], points_[j]))
           && !report(i, j))
          return false;
      }
    return true;
  }

  template <class Report>
  BOOST_NOINLINE std::optional<bool> report_in_lanes(Report& report)
  {
    Few_runs<Point> runs;
    const auto a = runs.make(points_, 0, first_size_);
    auto b = a;
    if constexpr(Sets::are_two)
      b = runs.make(points_, first_size_, points_.size());
    if(!runs.are_finite())
      return std::nullopt;
    return Few_sweep<Elements, Is_within, Report>(points_, is_within_, report)
      .run(a, Sets::are_two ? &b : nullptr);
  }

  const Elements& points_;
  std::size_t first_size_;
  Is_within is_within_;
};

// Reports the pairs of at most `max_few_points` points. Returns false iff the search was stopped.
// Returns nothing, and reports none, if the bound or a point is not valid.
template <class Elements, class Sets, class NT, class Callback, class NamedParameters>
std::optional<bool> report_few_near_pairs(const Elements& points, const Sets& sets,
                                          const Distance_bound<NT>& bound, Callback& callback,
                                          const NamedParameters& np)
{
  if(!(bound.value() >= NT(0)))
    return std::nullopt;
  check_denormals();
  Few_near_pairs<Elements, Sets, NT> pairs(points, sets, bound);
  auto progress = make_progress(np, points.size());
  const auto report = [&](std::size_t i, std::size_t j) {
    return goes_on_after(callback, i, j - sets.first_of_second());
  };
  std::optional<bool> is_complete = pairs.report_to(report);
  if(is_complete && *is_complete)
    is_complete = progress.advance(points.size());
  return is_complete;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_FEW_NEAR_PAIRS_H
