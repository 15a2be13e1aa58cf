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

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Close_pair_buckets.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_divide.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_search.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Join_task.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/join_search.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/searches_of_scene.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Element_points.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Takes pairs until one of them is within the distance.
template <class Elements>
class Close_pair_taker final : public Result_taker
{
public:
  Close_pair_taker(const Elements& points,
                   const Is_within_distance<typename Elements::value_type>& is_within)
    : points_(points), is_within_(is_within)
  {}

  // The first close pair that was taken.
  const std::optional<Position_pair>& pair() const { return pair_; }

  bool take(const Found_pair* pairs, std::size_t count) override
  {
    for(const Found_pair* const end = pairs + count; pairs != end; ++pairs)
      if(is_within_(points_[pairs->i], points_[pairs->j])) {
        const std::lock_guard<std::mutex> lock(mutex_);
        pair_ = Position_pair(std::minmax(pairs->i, pairs->j));
        return false;
      }
    return true;
  }

private:
  const Elements& points_;
  const Is_within_distance<typename Elements::value_type>& is_within_;
  std::mutex mutex_;
  std::optional<Position_pair> pair_;
};

template <class Elements, class Progress>
class Close_pair_search
{
  using Point = typename Elements::value_type;
  using Exact = Exact_number_t<Coordinate_t<Point>>;
  using Found = std::optional<Position_pair>;

public:
  // Takes the points of the scene.
  Close_pair_search(const Elements& points, const Squared_bound<Exact>& bound, const Scene& scene,
                    Progress& progress, const Threads& threads)
    : points_(points), scene_(scene), threads_(threads),
      is_zero_within_(bound.holds_for(Exact(0))), is_zero_(bound.is_zero()),
      is_within_(is_within_of_scene<Point>(bound, scene)), progress_(progress)
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
  template <int Dimension>
  Found find_by_joins() const
  {
    if(!do_cells_fit(is_within_.reach(), scene_.error))
      return find_otherwise();
    const std::size_t few = points_.size() / first_look_divisor;
    progress_.restart(2 * (few + points_.size()));
    Element_points<Dimension, Elements, Progress> points(points_, progress_);
    const auto task = join_task_of_scene<Dimension>(scene_, join_seed, threads_);
    Close_pair_taker<Elements> taker(points_, is_within_);
    Joined joined = Joined::ALL;
    for(const std::size_t size : {few, points_.size()})
      if(!taker.pair())
        joined = join_first_points<Dimension>(points, task, size, is_within_.reach(), taker);
    if(!taker.pair() && joined == Joined::GIVEN_UP) {
      progress_.restart(points_.size());
      search_near_pairs_of_scene(points_, scene_, is_within_, taker, progress_, threads_);
    }
    return taker.pair();
  }

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
    return Close_pair_buckets<Elements>(points_, size, scene_, is_within_, threads_)
      .find(progress_);
  }

  Found test_closest_pair() const
  {
    if(points_.size() < 2)
      return std::nullopt;
    Pair_minimum<Elements> minimum(points_, scene_);
    minimum.offer(0, 1);
    divide_and_conquer(points_.size(), scene_.dimension(), threads_, minimum, progress_);
    const Position_pair& pair = minimum.pair();
    return is_within_(points_[pair.first], points_[pair.second]) ? Found(pair) : std::nullopt;
  }

  // In sequence, the pair depends on the input alone. So the seed is fixed.
  static constexpr std::uint64_t join_seed = 0;

  const Elements& points_;
  const Scene& scene_;
  const Threads threads_;
  const bool is_zero_within_;
  const bool is_zero_; // whether only equal points are close
  const Is_within_distance<Point> is_within_;
  Progress& progress_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_SEARCH_H
