// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H

// Chooses the method for the closest pair. In the plane and in space it is a join of points in
// common cells. If these are crowded, the search of near pairs finds those that are as near as the
// closest pair of a sample. Hashing finds equal points if doubles hold their coordinates. The
// divide and conquer of [L] takes points of other dimensions, and points that doubles are too
// coarse for.
//
//   [L]  Computational geometry: closest pair and close pair. Slides of a lecture on algorithms,
//        without name or date.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_divide.h>
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
#include <CGAL/Thick_intersection_d/internal/machine/Per_thread.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Element_points.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether joins take all points of a type that differ: those whose coordinates are doubles, in the
// plane or in space.
template <class Point>
inline constexpr bool are_joined_v
  = is_held_by_double_v<Coordinate_t<Point>>
    && (dimension_or<Point>(0) == 2 || dimension_or<Point>(0) == 3);

// Offers pairs that are found to a minimum. Each thread has a minimum of its own.
template <class Minimum>
class Pair_offers final : public Closest_taker
{
public:
  // Takes pairs until there are more than `max_count`. They are as close as the minimum if
  // `are_ties`.
  Pair_offers(Minimum& minimum, const Threads& threads, std::size_t max_count,
              bool are_ties = false)
    : minimum_(minimum), minima_(minimum, threads), max_count_(max_count), are_ties_(are_ties)
  {}

  BOOST_NOINLINE bool take(const Found_pair* pairs, std::size_t count) override
  {
    Minimum& own = minima_.local();
    if(are_ties_)
      for(std::size_t k = 0; k < count; ++k)
        own.offer_tie(pairs[k].i, pairs[k].j);
    else
      for(std::size_t k = 0; k < count; ++k)
        own.offer(pairs[k].i, pairs[k].j);
    return count_.fetch_add(count, std::memory_order_relaxed) + count <= max_count_;
  }

  double reach() override
  {
    collect();
    return minimum_.has_tight_reach() ? minimum_.reach() : 0;
  }

  // Offers the pairs of all threads to the minimum, and the closest of them to all threads.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void collect()
  {
    minima_.for_each([&](const Minimum& own) { minimum_.offer_pair_of(own); });
    minima_.for_each([&](Minimum& own) { own.offer_pair_of(minimum_); });
  }

  std::size_t count() const { return count_.load(std::memory_order_relaxed); }

private:
  Minimum& minimum_;
  Per_thread<Minimum> minima_;
  std::size_t max_count_;
  bool are_ties_;
  std::atomic<std::size_t> count_ = 0;
};

template <class Elements, class Progress>
class Closest_pair_search
{
  using Point = typename Elements::value_type;
  using Exact = Exact_number_t<Coordinate_t<Point>>;
  using Minimum = Pair_minimum<Elements>;
  using Offers = Pair_offers<Minimum>;

public:
  // Takes the points of the scene, at least two.
  Closest_pair_search(const Elements& points, const Scene& scene, std::uint64_t seed,
                      Progress& progress, const Threads& threads)
    : points_(points), scene_(scene), seed_(seed), progress_(progress), threads_(threads),
      minimum_(points, scene)
  {}

  // Returns the closest pair. If the search is cancelled, returns the closest of the pairs that it
  // has seen so far. (0, 1) is the first of these pairs.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Position_pair find()
  {
    minimum_.offer(0, 1);
    const bool is_found
      = for_plane_and_space<Point>(scene_.dimension(), [&](auto dimension) {
          return search_in_plane_or_space<decltype(dimension)::value>();
        }, [] { return false; });
    if(!is_found && !progress_.is_cancelled())
      search_by_coordinates();
    return minimum_.pair();
  }

private:
  // Offers the closest pairs. Returns false if points are equal or doubles are too coarse.
  template <int Dimension>
  bool search_in_plane_or_space()
  {
    if(join_in_cells<Dimension>() != Joined::GIVEN_UP)
      return true;
    return !progress_.is_cancelled() && minimum_.has_tight_reach()
           && do_cells_fit(minimum_.reach(), scene_.error) && (report_as_near() || report_nearer());
  }

  template <int Dimension>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Joined join_in_cells()
  {
    progress_.restart(2 * points_.size() + 2 * points_.size() / 7); // a 7th are in all samples
    Element_points<Dimension, Elements, Progress> points(points_, progress_);
    const auto task = join_task_of_scene<Dimension>(scene_, seed_, threads_);
    Offers offers(minimum_, threads_, unlimited);
    const Joined joined = join_samples<Dimension>(points, task, offers);
    offers.collect();
    return joined;
  }

  // Offers the pairs that are as near as the closest pair so far. Returns false if there are too
  // many of them.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool report_as_near()
  {
    const double reach = minimum_.reach();
    if(!(reach <= max_reach))
      return false;
    progress_.restart(2 * points_.size());
    if(scene_.error != 0 || is_wide(reach)) // a longer bound leaves ties to the minimum
      return offer_reported(within_distance(Exact(reach * (1 + 0x1p-40))), false)
             != Reported::TOO_MANY;
    // Closer pairs are few, and if there are any, they make all others no matter. Otherwise nothing
    // is left but pairs that are as close.
    const Distance_bound<Exact> bound = within_squared_distance(minimum_.exact_square());
    const Position_pair pair = minimum_.pair();
    const Reported closer = offer_reported(bound.open(), false);
    if(closer == Reported::TOO_MANY || minimum_.pair() != pair || progress_.is_cancelled())
      return closer != Reported::TOO_MANY;
    return offer_reported(bound, true) != Reported::TOO_MANY;
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

  // Offers the closest pairs if too many pairs are as near as the closest pair so far. Finds out
  // how near there are few, by bisection. If no pair is within 2^e, then few are within 2^(e+1),
  // because a ball of that radius holds O(1) points. Returns false if points are equal.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool report_nearer()
  {
    int low = std::ilogb(std::numeric_limits<double>::denorm_min()) - 1;
    int high = (std::min)(std::ilogb(minimum_.reach()), max_exponent) + 1;
    // Invariant: there is no pair within 2^low, and there are too many pairs within 2^high, unless
    // no double is as large.
    while(high - low > 1 && !minimum_.is_zero()) {
      const int middle = low + (high - low) / 2;
      progress_.restart(points_.size());
      const Reported nearer = offer_reported(within_distance(Exact(std::ldexp(1., middle))), false);
      if(nearer == Reported::FEW || progress_.is_cancelled())
        return true;
      (nearer == Reported::NONE ? low : high) = middle;
    }
    if(minimum_.is_zero())
      return false;
    CGAL_assertion(low == max_exponent);
    offer_all(); // a few points, all of them that far apart
    return true;
  }

  void offer_all()
  {
    for(std::size_t i = 0; i < points_.size() && progress_.advance(1); ++i)
      for(std::size_t j = i + 1; j < points_.size(); ++j)
        minimum_.offer(i, j);
  }

  // How many pairs were reported.
  enum class Reported { NONE, FEW, TOO_MANY };

  // Offers the pairs within the bound, up to a number of pairs.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Reported offer_reported(const Distance_bound<Exact>& bound, bool are_ties)
  {
    const std::size_t most = max_near_pairs_per_point * points_.size();
    Offers offers(minimum_, threads_, most, are_ties);
    search_near_pairs_of_scene(
      points_, scene_, is_within_of_scene<Point>(Squared_bound<Exact>(bound), scene_), offers,
      progress_, threads_);
    offers.collect();
    if(offers.count() > most)
      return Reported::TOO_MANY;
    return offers.count() != 0 ? Reported::FEW : Reported::NONE;
  }

  // Offers the closest pairs by what needs no distance beforehand.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void search_by_coordinates()
  {
    if constexpr(is_held_by_double_v<Coordinate_t<Point>>)
      if(minimum_.is_zero()) {
        progress_.restart(points_.size());
        First_equal_pair<Elements> equal_points(points_, scene_.dimension(), random_word(seed_));
        if(const auto pair = equal_points.find(progress_))
          minimum_.offer(pair->first, pair->second);
        return;
      }
    if constexpr(!are_joined_v<Point>)
      divide_and_conquer(points_.size(), scene_.dimension(), threads_, minimum_, progress_);
  }

  static constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
  static constexpr int max_exponent = std::numeric_limits<double>::max_exponent - 1;
  static constexpr double max_reach = 0x1p1023; // beyond it, longer bounds may overflow

  const Elements& points_;
  const Scene& scene_;
  std::uint64_t seed_; // of what is drawn next
  Progress& progress_;
  const Threads threads_;
  Minimum minimum_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
