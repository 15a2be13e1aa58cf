// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H

// Chooses the method for the closest pair. In the plane and in space it is a join of points in
// common cells. If these are crowded, the search of near pairs reports those that are as near as
// the closest pair of a sample. If there are too many of them, the randomized cells follow. Hashing
// finds equal points if doubles hold their coordinates. The divide and conquer of [L] takes points
// of other dimensions, and points that doubles are too coarse for.
//
//   [L]  Computational geometry: closest pair and close pair. Slides of a lecture on algorithms,
//        without name or date.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_join.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_divide.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Points_at.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Step_budget.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Offers the pairs that a join visits to a minimum of its own. In the end, offers this minimum to
// the result.
template <class Minimum>
struct Minimum_visitor
{
  bool operator()(std::size_t i, std::size_t j)
  {
    minimum.offer(i, j);
    return true;
  }

  void finish()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    result.offer_pair_of(minimum);
  }

  Minimum& result;
  std::mutex& mutex;
  Minimum minimum;
};

// `report_near(points, bound, callback, progress)` calls callback(i, j) for the pairs of points
// within the bound, from any thread, until it returns false.
template <class ConcurrencyTag, class Elements, class Progress, class Report_near>
class Closest_pair_search
{
  using Point = typename Elements::value_type;
  using Minimum = Pair_minimum<Elements>;
  using Positions = std::vector<Place>;

public:
  // Takes the points of the scene, at least two.
  Closest_pair_search(const Elements& points, const Scene& scene, std::uint64_t seed,
                      Progress& progress, const Report_near& report_near)
    : points_(points), scene_(scene), random_(seed), progress_(progress),
      report_near_(report_near), grid_exponent_(scene.grid_exponent)
  {}

  // Returns the closest pair. If the search is cancelled, returns the closest of the pairs that it
  // has seen so far. (0, 1) is the first of these pairs.
  Position_pair find()
  {
    Minimum minimum(points_, scene_);
    minimum.offer(0, 1);
    const bool is_found
      = for_plane_and_space<Point>(scene_.dimension(), [&](auto dimension) {
          return search<decltype(dimension)::value>(All_positions(points_.size()), 0, minimum);
        }, [] { return false; });
    if(is_found || progress_.is_cancelled())
      return minimum.pair();
    if constexpr(is_held_by_double_v<Coordinate_t<Point>>)
      if(minimum.is_zero()) {
        progress_.restart(points_.size());
        First_equal_pair<Elements> equal_points(points_, scene_.dimension(), random_());
        if(const auto pair = equal_points.find(progress_))
          return *pair;
      }
    divide_and_conquer<ConcurrencyTag>(points_.size(), scene_.dimension(), minimum, progress_);
    return minimum.pair();
  }

private:
  // Offers the closest pairs of some points to `minimum`, in expected linear time. Returns false if
  // points are equal or doubles are too coarse. For the progress, `later` more points come later.
  //
  // The same method finds the closest pair of an eighth of the points. Few pairs of all points are
  // within the distance of this pair: 8^2 pairs, if pairs were independent.
  template <int Dimension, class Some_positions>
  bool search(const Some_positions& positions, std::size_t later, Minimum& minimum)
  {
    if(positions.size() <= small_size)
      return search_cells<Dimension>(positions, later, minimum);
    return search<Dimension>(draw_sample(positions), later + positions.size(), minimum)
           && minimum.has_tight_reach()
           && Hashed_cells<Dimension>::fits(minimum.reach(), scene_.error)
           && (join_all<Dimension>(positions, later, minimum)
               || report_all(positions, later, minimum)
               || search_cells<Dimension>(positions, later, minimum));
  }

  // Joins points in cells. Returns false if the cells are crowded, or those of a sample were.
  template <int Dimension, class Some_positions>
  bool join_all(const Some_positions& positions, std::size_t later, Minimum& minimum)
  {
    if(is_crowded_)
      return false;
    const double distance = minimum.reach();
    progress_.restart(2 * (positions.size() + later));
    const Cell_join<ConcurrencyTag, Dimension, Elements> join(
      points_, distance, join_cell_side(scene_, positions.size(), distance), random_());
    is_crowded_ = !offer_joined(join, positions, max_steps_per_point * positions.size(), minimum);
    return !is_crowded_;
  }

  // Offers the pairs that are as near as the closest pair so far. Returns false if there are too
  // many of them.
  template <class Some_positions>
  bool report_all(const Some_positions& some_positions, std::size_t later, Minimum& minimum)
  {
    const Positions positions = as_vector(some_positions);
    progress_.restart(2 * positions.size() + later);
    if(!scene_.is_grid_known && !grid_exponent_)
      grid_exponent_ = grid_exponent_of(points_, scene_);
    const Arithmetic_tier tier
      = first_exact_tier(minimum.reach(), grid_exponent_, scene_.extended_axis_count());
    if(tier == Arithmetic_tier::FILTERED_EXACT) // a longer bound leaves all ties to the minimum
      return offer_reported(positions, within_distance(minimum.reach() * (1 + 0x1p-40)), minimum,
                            Offer_closer());
    return is_wide(minimum.reach()) ? report_once(positions, tier, minimum)
                                    : report_twice(positions, minimum);
  }

  // Whether slabs may have to be cut again and again. In other scenes a search of near pairs takes
  // less time than to look at the points of each pair.
  bool is_wide(double reach) const
  {
    double length = 0;
    for(const Interval& interval : scene_.box)
      length = (std::max)(length, interval.length());
    return length > max_narrow_reaches * reach;
  }

  // Closer pairs are few, and if there are any, they make all others no matter. Otherwise nothing
  // is left but pairs that are as close.
  bool report_twice(const Positions& positions, Minimum& minimum)
  {
    const auto bound = within_squared_distance(minimum.exact_square());
    const Position_pair pair = minimum.pair();
    const bool are_few = offer_reported(positions, bound.open(), minimum, Offer_closer());
    if(!are_few || minimum.pair() != pair || progress_.is_cancelled())
      return are_few;
    return offer_reported(positions, bound, minimum,
                          [](Offers& own, std::size_t i, std::size_t j) {
                            own.tied.offer_tie(i, j);
                          });
  }

  // Asks about each pair whether it is closer.
  bool report_once(const Positions& positions, Arithmetic_tier tier, Minimum& minimum)
  {
    const auto bound = within_squared_distance(minimum.exact_square());
    Scene scene = scene_;
    scene.grid_exponent = grid_exponent_;
    const Is_within_distance<Point> is_closer(
      Squared_bound<Exact_number_t<Coordinate_t<Point>>>(bound.open()), scene, tier);
    return offer_reported(positions, bound, minimum,
                          [&](Offers& own, std::size_t i, std::size_t j) {
                            if(is_closer(points_[i], points_[j]))
                              own.closer.offer(i, j);
                            else
                              own.tied.offer_tie(i, j);
                          });
  }

  // What a thread offers its pairs to, and counts them by.
  struct Offers
  {
    Minimum closer;
    Minimum tied;
    Step_counter counter;
  };

  struct Offer_closer
  {
    void operator()(Offers& own, std::size_t i, std::size_t j) const { own.closer.offer(i, j); }
  };

  // Calls offer(own, i, j) for the pairs within the bound, up to a number of pairs, with `own` of
  // each thread. Then offers what it has to the minimum.
  template <class Bound, class Offer>
  bool offer_reported(const Positions& positions, const Bound& bound, Minimum& minimum,
                      const Offer& offer)
  {
    Step_budget budget(max_near_pairs_per_point * positions.size());
    Per_thread<ConcurrencyTag, Offers> offers(Offers{minimum, minimum, Step_counter(budget)});
    report_near_(Points_at<Elements>(points_, positions), bound,
                 [&](std::size_t i, std::size_t j) {
                   Offers& own = offers.local();
                   offer(own, positions[i], positions[j]);
                   return own.counter.step();
                 }, progress_);
    offers.for_each([&](const Offers& own) {
      minimum.offer_pair_of(own.tied);
      minimum.offer_pair_of(own.closer);
    });
    return !budget.is_exceeded();
  }

  // Returns false if the join was given up.
  template <class Join, class Some_positions>
  bool offer_joined(const Join& join, const Some_positions& positions, std::size_t max_steps,
                    Minimum& minimum) const
  {
    std::mutex mutex;
    return join(positions, max_steps, [&, start = minimum] {
      return Minimum_visitor<Minimum>{minimum, mutex, start};
    }, progress_);
  }

  template <int Dimension, class Some_positions>
  bool search_cells(const Some_positions& positions, std::size_t later, Minimum& minimum)
  {
    progress_.restart(positions.size() + later);
    return Closest_pair_cells<Dimension, Elements>(points_, as_vector(positions), scene_, random_())
      .search(minimum, progress_);
  }

  template <class Some_positions>
  static Positions as_vector(const Some_positions& positions)
  {
    Positions all(positions.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      all[i] = positions[i];
    return all;
  }

  template <class Some_positions>
  Positions draw_sample(const Some_positions& positions)
  {
    Positions sample;
    for(std::size_t i = random_() % max_sample_step; i < positions.size();
        i += 1 + random_() % max_sample_step)
      sample.push_back(positions[i]);
    return sample;
  }

  const Elements& points_;
  const Scene& scene_;
  std::mt19937_64 random_;
  Progress& progress_;
  const Report_near& report_near_;
  std::optional<int> grid_exponent_; // read when points are crowded, unless the scene has it
  bool is_crowded_ = false; // whether a join was given up
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
