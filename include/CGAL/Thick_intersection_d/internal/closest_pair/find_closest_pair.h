// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIND_CLOSEST_PAIR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIND_CLOSEST_PAIR_H

// The searches behind closest_pair() and find_close_pair().

#include <CGAL/Distance_bound.h>
#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Close_pair_search.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_search.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/input/Point_doubles.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene_sample.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Plain_is_within.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The closest pair of few points, and a close one: each with each, without a scene and without
// memory but the stack.
template <class Elements>
class Few_closest_pair
{
  using Point = typename Elements::value_type;
  static constexpr int dimension = dimension_or<Point>(0);
  static constexpr std::size_t max_size = dimension == 2 ? max_few_points / 2 : max_few_points;

public:
  // Cells are faster for more points in the plane. No pair is left to the search of many points,
  // which knows what to say.
  static bool takes(const Elements& points)
  {
    return points.size() >= 2 && points.size() <= max_size;
  }

  // Takes few points.
  explicit Few_closest_pair(const Elements& points) : points_(points)
  {
    check_denormals();
    are_finite_ = read_coordinates(points, 0, points.size(), x_, 0);
  }

  bool are_finite() const { return are_finite_; }

  // Returns the closest pair of finite points.
  //
  // Invariant: the pair has the least computed square so far. All other pairs so far are farther,
  // unless `has_tie`.
  Position_pair find() const
  {
    constexpr double slack = 0x1p-46; // more than squares of one distance differ by
    Position_pair pair(0, 1);
    double square = std::numeric_limits<double>::infinity();
    double near = square; // as far as a tie
    bool has_tie = true;
    for(std::size_t i = 0; i < points_.size(); ++i)
      for(std::size_t j = i + 1; j < points_.size(); ++j)
        if(const double s = computed_square(x_, i, j); s <= near) {
          has_tie = s >= square * (1 - slack);
          if(s < square) {
            square = s;
            near = s * (1 + slack);
            pair = {i, j};
          }
        }
    const bool is_safe = square >= min_safe_square && square <= max_safe_square;
    return has_tie || !is_safe ? find_among_ties(square) : pair;
  }

  // Returns the first pair within a bound, or (0, 0) if there is none.
  template <class Is_within>
  Position_pair find_within(Is_within& is_within) const
  {
    const Distance_filter filter = is_within.filter();
    for(std::size_t i = 0; i < points_.size(); ++i)
      for(std::size_t j = i + 1; j < points_.size(); ++j) {
        const double s = computed_square(x_, i, j);
        if(s <= filter.outside
           && (s <= filter.inside || is_within.decide_undecided(points_[i], points_[j])))
          return {i, j};
      }
    return {0, 0};
  }

private:
  // Returns the closest pair, of which `square` is the least computed square.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Position_pair find_among_ties(double square) const
  {
    const double most = make_distance_filter(
      square, square * (1 + 2 * relative_error(dimension)), dimension).outside;
    Pair_minimum<Elements> minimum(points_, dimension);
    for(std::size_t i = 0; i < points_.size(); ++i)
      for(std::size_t j = i + 1; j < points_.size(); ++j)
        if(computed_square(x_, i, j) <= most)
          minimum.offer(i, j);
    return minimum.pair();
  }

  const Elements& points_;
  Few_coordinates<Point, max_size> x_;
  bool are_finite_;
};

// Whether doubles may decide ties on the grid of the scene, or integers ties of a lattice. To read
// the grid of other scenes takes a seventh of the search for nothing.
inline bool may_need_grid(const Scene_sample& sample)
{
  return sample.may_have_coarse_grid() || sample.is_repetitive();
}

// Returns the scene of the points. Throws if there are too many points, if points differ in
// dimension, or if a coordinate is not finite. Finds the grid of the scene if it may be of use.
template <class Elements>
Scene scan_checked_points(const Elements& points, const Threads& threads)
{
  check_size(points.size(), max_place / 2); // crowds take slabs, as near_points_search.h does
  return scan_points(points, "point", may_need_grid(Scene_sample(points)), threads);
}

template <class Elements, class NamedParameters>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
Position_pair find_closest_pair_of_many(const Elements& points, const NamedParameters& np,
                                        const Threads& threads)
{
  const Scene scene = scan_checked_points(points, threads);
  if(points.size() < 2)
    throw std::invalid_argument("There is no closest pair of fewer than two points.");
  const std::uint64_t seed = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::random_seed), seed_of_process());
  auto progress = make_progress(np, points.size());
  Closest_pair_search<Elements, decltype(progress)> search(points, scene, seed, progress, threads);
  const Position_pair pair = search.find();
  progress.finish();
  return pair;
}

template <class Elements, class NamedParameters>
Position_pair find_closest_pair(const Elements& points, const NamedParameters& np,
                                const Threads& threads)
{
  if constexpr(has_few_doubles<typename Elements::value_type>())
    if(Few_closest_pair<Elements>::takes(points))
      if(const Few_closest_pair<Elements> few(points); few.are_finite()) {
        const Position_pair pair = few.find();
        make_progress(np, points.size()).finish();
        return pair;
      }
  return find_closest_pair_of_many(points, np, threads);
}

template <class Elements, class NT, class NamedParameters>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
std::optional<Position_pair> find_pair_of_many_within(const Elements& points,
                                                      const Distance_bound<NT>& bound,
                                                      const NamedParameters& np,
                                                      const Threads& threads)
{
  using Number = Coordinate_t<typename Elements::value_type>;
  const Squared_bound<Exact_number_t<Number>> squared_bound(bound);
  const Scene scene = scan_checked_points(points, threads);
  auto progress = make_progress(np, points.size());
  const Close_pair_search<Elements, decltype(progress)> search(points, squared_bound, scene,
                                                               progress, threads);
  const std::optional<Position_pair> pair = search.find();
  progress.finish();
  return pair;
}

template <class Elements, class NT, class NamedParameters>
std::optional<Position_pair> find_pair_within(const Elements& points,
                                              const Distance_bound<NT>& bound,
                                              const NamedParameters& np,
                                              const Threads& threads)
{
  using Point = typename Elements::value_type;
  if constexpr(has_few_doubles<Point>() && is_held_by_double_v<NT>)
    if(Few_closest_pair<Elements>::takes(points) && bound.value() >= NT(0))
      if(const Few_closest_pair<Elements> few(points); few.are_finite()) {
        Plain_is_within<Point, NT> is_within(bound);
        const Position_pair pair = few.find_within(is_within);
        make_progress(np, points.size()).finish();
        return pair.first != pair.second ? std::optional<Position_pair>(pair) : std::nullopt;
      }
  return find_pair_of_many_within(points, bound, np, threads);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIND_CLOSEST_PAIR_H
