// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_SEARCH_H

// Chooses the method for a close pair. If the bound is zero, and doubles hold the coordinates, it
// is hashing. Beyond dimension 5 it is the divide and conquer of [L]. In the plane and in space it
// is a join of points in common cells. If the join is given up, the search of near pairs looks for
// a close pair. The buckets of [L] take points of other dimensions, and points that doubles are too
// coarse for. A few points are searched first. Closest_pair_search.h says what [L] is.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_join.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Close_pair_buckets.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_divide.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Some_positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the tier for near ties of the scene. Integers decide those that they can.
inline Arithmetic_tier near_tie_tier(double reach, const Scene& scene)
{
  return (std::min)(first_exact_tier(reach, scene.grid_exponent, scene.extended_axis_count()),
                    Arithmetic_tier::INT128);
}

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
    : points_(points), scene_(scene),
      is_zero_within_(bound.holds_for(Exact(0))), is_zero_(bound.is_zero()),
      is_within_(bound, scene, near_tie_tier(bound.reach(), scene)),
      progress_(progress), report_near_(report_near)
  {}

  // Returns a close pair, if there is one and if it was found before the search was cancelled.
  Found find() const
  {
    if(!is_zero_within_) // no distance is less than zero
      return std::nullopt;
    if constexpr(is_held_by_double_v<Coordinate_t<Point>>)
      if(is_zero_) {
        progress_.restart(points_.size());
        return First_equal_pair<Elements>(points_, scene_.dimension(), seed_of_process())
          .find(progress_);
      }
    return for_plane_and_space<Point>(scene_.dimension(), [&](auto dimension) {
      return find_by_joins<decltype(dimension)::value>();
    }, [&] { return find_otherwise(); });
  }

private:
  // Finds a close pair by what takes any number type and any dimension.
  Found find_otherwise() const
  {
    if constexpr(!are_joined_v<Point>) {
      if(scene_.dimension() > max_bucket_dimension)
        return test_closest_pair();
      const std::size_t few = points_.size() / first_look_divisor;
      const std::size_t rounds = static_cast<std::size_t>(scene_.dimension()) + 1;
      progress_.restart(rounds * (few + points_.size()));
      const Found pair = find_in_buckets(few);
      return pair ? pair : find_in_buckets(points_.size());
    }
    return std::nullopt;
  }

  Found find_in_buckets(std::size_t size) const
  {
    return Close_pair_buckets<ConcurrencyTag, Elements>(points_, size, scene_, is_within_)
      .find(progress_);
  }

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

  template <int Dimension>
  Found find_by_joins() const
  {
    if(!Hashed_cells<Dimension>::fits(is_within_.reach(), scene_.error))
      return find_otherwise();
    const std::size_t few = points_.size() / first_look_divisor;
    progress_.restart(2 * (few + points_.size()));
    bool is_complete = false;
    for(const std::size_t size : {few, points_.size()}) {
      Found result;
      is_complete = join<Dimension>(size, result);
      if(result)
        return result;
    }
    return is_complete ? std::nullopt : find_reported();
  }

  // Joins the first `size` points until a close pair is found. Returns false if the join was given
  // up.
  template <int Dimension>
  bool join(std::size_t size, Found& result) const
  {
    const double reach = (std::min)(is_within_.reach(), (std::numeric_limits<double>::max)());
    const Cell_join<ConcurrencyTag, Dimension, Elements> join_cells(
      points_, reach, join_cell_side(scene_, size, reach), join_seed);
    std::mutex mutex;
    const auto test = [&](std::size_t i, std::size_t j) {
      if(!is_within_(points_[i], points_[j]))
        return true;
      const std::lock_guard<std::mutex> lock(mutex);
      result = Position_pair(std::minmax(i, j));
      return false;
    };
    return join_cells(Some_positions(size), max_join_steps(size), [&] { return test; }, progress_);
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
    progress_.restart(points_.size());
    report_near_(take, progress_);
    return result;
  }

  // In sequence, the pair depends on the input alone. So the seed is fixed.
  static constexpr std::uint64_t join_seed = 0;

  const Elements& points_;
  const Scene& scene_;
  const bool is_zero_within_;
  const bool is_zero_; // whether only equal points are close
  const Is_within_distance<Point> is_within_;
  Progress& progress_;
  const Report_near& report_near_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_SEARCH_H
