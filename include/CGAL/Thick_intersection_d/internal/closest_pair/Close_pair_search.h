// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_SEARCH_H

// Chooses the method for a close pair. If the bound is zero, and doubles hold the coordinates, it
// is hashing. Beyond dimension 5 it is the divide and conquer of [L]. Otherwise the buckets of [L]
// look at a few points first. In the plane and in space, a join of points in common cells follows.
// If the join is given up, the search of near pairs looks for one. The buckets take all points in
// other dimensions, and if doubles are too coarse for the join. Closest_pair_search.h says what [L]
// is.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_join.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Close_pair_buckets.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_divide.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Tests the pairs that a join visits, until a pair is close.
template <class Elements>
struct Close_pair_visitor
{
  bool operator()(std::size_t i, std::size_t j)
  {
    if(is_within(points[i], points[j]))
      pair = Position_pair(std::minmax(i, j));
    return !pair;
  }

  void finish()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if(pair)
      result = pair;
  }

  const Elements& points;
  const Is_within_distance<typename Elements::value_type>& is_within;
  std::optional<Position_pair>& result;
  std::mutex& mutex;
  std::optional<Position_pair> pair = std::nullopt;
};

// `report_near(callback, progress)` calls callback(i, j) for the close pairs, until it returns
// false.
template <class ConcurrencyTag, class Elements, class Progress, class Report_near>
class Close_pair_search
{
  using Point = typename Elements::value_type;
  using Exact = Exact_number_t<Coordinate_t<Point>>;
  using Found = std::optional<Position_pair>;

public:
  // Takes the points of the scene.
  Close_pair_search(const Elements& points, const Squared_bound<Exact>& bound, const Scene& scene,
                    Progress& progress, const Report_near& report_near)
    : points_(points), all_(points.size()), scene_(scene),
      is_zero_within_(bound.holds_for(Exact(0))), is_zero_(bound.is_zero()),
      is_within_(bound, scene,
                 (std::min)(first_exact_tier(bound.reach(), scene.grid_exponent,
                                             scene.extended_axis_count()),
                            Arithmetic_tier::INT128)),
      buckets_(points, scene, is_within_), progress_(progress), report_near_(report_near)
  {}

  Close_pair_search(const Close_pair_search&) = delete; // the buckets refer to another member

  // Returns a close pair, if there is one and if it was found before the search was cancelled.
  Found find() const
  {
    if(!is_zero_within_) // no distance is less than zero
      return std::nullopt;
    if constexpr(is_held_by_double_v<Coordinate_t<Point>>)
      if(is_zero_) {
        progress_.restart(all_.size());
        First_equal_pair<Elements> equal_points(points_, scene_.dimension(), seed_of_process());
        const Found pair = equal_points.find(progress_);
        if(!equal_points.is_given_up())
          return pair;
      }
    if(scene_.dimension() > max_bucket_dimension)
      return test_closest_pair();
    if(const Found pair = find_in_buckets(All_positions(all_.size() / first_look_divisor),
                                          2 * all_.size()))
      return pair;
    return for_plane_and_space<Point>(scene_.dimension(), [&](auto dimension) {
      return find_by_join<decltype(dimension)::value>();
    }, [&] { return find_in_buckets(all_, 0); });
  }

private:
  Found test_closest_pair() const
  {
    if(points_.size() < 2)
      return std::nullopt;
    Pair_minimum<Elements> minimum(points_, scene_);
    minimum.offer(0, 1);
    divide_and_conquer<ConcurrencyTag>(points_.size(), scene_.dimension(), minimum, progress_);
    const Position_pair& pair = minimum.pair();
    return is_within_(points_[pair.first], points_[pair.second]) ? Found(pair) : std::nullopt;
  }

  // For the progress, `later` more objects are left for other methods.
  Found find_in_buckets(const All_positions& positions, std::size_t later) const
  {
    const std::size_t rounds = static_cast<std::size_t>(scene_.dimension()) + 1;
    progress_.restart(rounds * positions.size() + later);
    return buckets_.find(positions, progress_);
  }

  template <int Dimension>
  Found find_by_join() const
  {
    const double reach = is_within_.reach();
    if(!Hashed_cells<Dimension>::fits(reach, scene_.error))
      return find_in_buckets(all_, 0);
    progress_.restart(2 * all_.size());
    const Cell_join<ConcurrencyTag, Dimension, Elements> join_cells(
      points_, reach, join_cell_side(scene_, all_.size(), reach), join_seed);
    Found result;
    std::mutex mutex;
    const bool is_complete
      = join_cells(all_, max_steps_per_point * all_.size(), [&] {
          return Close_pair_visitor<Elements>{points_, is_within_, result, mutex};
        }, progress_);
    return result || is_complete ? result : find_reported();
  }

  Found find_reported() const
  {
    Found result;
    std::mutex mutex;
    const auto take = [&](std::size_t i, std::size_t j) {
      const std::lock_guard<std::mutex> lock(mutex);
      result = Position_pair(std::minmax(i, j));
      return false;
    };
    progress_.restart(all_.size());
    report_near_(take, progress_);
    return result;
  }

  // In sequence, the pair depends on the input alone. So the seed is fixed.
  static constexpr std::uint64_t join_seed = 0;

  const Elements& points_;
  const All_positions all_;
  const Scene& scene_;
  const bool is_zero_within_;
  const bool is_zero_; // whether only equal points are close
  const Is_within_distance<Point> is_within_;
  const Close_pair_buckets<ConcurrencyTag, Elements> buckets_;
  Progress& progress_;
  const Report_near& report_near_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_SEARCH_H
