// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H

// Chooses the method for the closest pair. In the plane and in space it is a join of points in
// common cells. If these are crowded, the search of near pairs reports those that are as near as
// the closest pair of a sample. Hashing finds equal points if doubles hold their coordinates. The
// divide and conquer of [L] takes points of other dimensions, and points that doubles are too
// coarse for.
//
//   [L]  Computational geometry: closest pair and close pair. Slides of a lecture on algorithms,
//        without name or date.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_join.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Closest_pair_divide.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Some_positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Step_budget.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `report_near(points, bound, callback, progress)` calls callback(i, j) for the pairs of points
// within the bound, from any thread, until it returns false.
template <class ConcurrencyTag, class Elements, class Progress, class Report_near>
class Closest_pair_search
{
  using Point = typename Elements::value_type;
  using Exact = Exact_number_t<Coordinate_t<Point>>;
  using Minimum = Pair_minimum<Elements>;

public:
  // Takes the points of the scene, at least two.
  Closest_pair_search(const Elements& points, const Scene& scene, std::uint64_t seed,
                      Progress& progress, const Report_near& report_near)
    : points_(points), scene_(scene), seed_(seed), progress_(progress),
      report_near_(report_near), minimum_(points, scene)
  {}

  // Returns the closest pair. If the search is cancelled, returns the closest of the pairs that it
  // has seen so far. (0, 1) is the first of these pairs.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Position_pair find()
  {
    minimum_.offer(0, 1);
    const bool is_found
      = for_plane_and_space<Point>(scene_.dimension(), [&](auto dimension) {
          return search_all<decltype(dimension)::value>();
        }, [] { return false; });
    if(!is_found && !progress_.is_cancelled())
      search_by_coordinates();
    return minimum_.pair();
  }

private:
  // Offers the closest pairs. Returns false if points are equal or doubles are too coarse.
  template <int Dimension>
  bool search_all()
  {
    progress_.restart(2 * points_.size() + 2 * points_.size() / 7); // a 7th are in all samples
    return search<Dimension>(Some_positions(points_.size()))
           || (!progress_.is_cancelled() && can_join<Dimension>() && report_all());
  }

  // Offers the closest pairs of a sample, in expected linear time. Returns false as search_all()
  // does, or if the points are crowded.
  //
  // The same method finds the closest pair of an eighth of the points. Few pairs of all points are
  // within the distance of this pair: 8^2 pairs, if pairs were independent. If by chance there are
  // too many, another eighth of the sample is drawn, because the pair is too far apart to have all
  // nearer pairs of the scene reported.
  template <int Dimension>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool search(const Some_positions& sample)
  {
    if(sample.size() <= small_size) {
      offer_all(sample);
      return true;
    }
    const int draw_count = sample.size() == points_.size() ? 1 : 2;
    for(int draw = 0; draw < draw_count && !progress_.is_cancelled(); ++draw) {
      if(!search<Dimension>(Some_positions(ConcurrencyTag(), sample, seed_))
         || !can_join<Dimension>())
        return false;
      if(join<Dimension>(sample))
        return true;
    }
    return false;
  }

  // Whether cells can be about as large as the distance of the closest pair so far.
  template <int Dimension>
  bool can_join() const
  {
    return minimum_.has_tight_reach()
           && Hashed_cells<Dimension>::fits(minimum_.reach(), scene_.error);
  }

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void offer_all(const Some_positions& sample)
  {
    for(std::size_t i = 0; i < sample.size() && progress_.advance(1); ++i)
      for(std::size_t j = i + 1; j < sample.size(); ++j)
        minimum_.offer(sample[i], sample[j]);
  }

  // Joins the points of a sample in cells. Returns false if the cells are crowded.
  template <int Dimension>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool join(const Some_positions& sample)
  {
    const double distance = (std::min)(minimum_.reach(), (std::numeric_limits<double>::max)());
    const Cell_join<ConcurrencyTag, Dimension, Elements> join_cells(
      points_, distance, join_cell_side(scene_, sample.size(), distance), random_word(seed_));
    Per_thread<ConcurrencyTag, Minimum> minima(minimum_);
    const bool is_complete = join_cells(sample, max_join_steps(sample.size()), [&] {
      return [&own = minima.local()](std::size_t i, std::size_t j) {
        own.offer(i, j);
        return true;
      };
    }, progress_);
    minima.for_each([&](const Minimum& own) { minimum_.offer_pair_of(own); });
    return is_complete;
  }

  // Has pairs of crowded points reported, and offers them. Returns false as search_all() does.
  bool report_all() { return report_as_near() || report_nearer(); }

  // How many pairs were reported.
  enum class Reported { NONE, FEW, TOO_MANY };

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
    offer_all(Some_positions(points_.size())); // a few points, all of them that far apart
    return true;
  }

  // What a thread offers its pairs to, and counts them by.
  struct Offers
  {
    Minimum minimum;
    Step_counter counter;
  };

  // Offers the pairs within the bound, up to a number of pairs.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Reported offer_reported(const Distance_bound<Exact>& bound, bool are_ties)
  {
    Step_budget budget(max_near_pairs_per_point * points_.size());
    Per_thread<ConcurrencyTag, Offers> offers(Offers{minimum_, Step_counter(budget)});
    report_near_(points_, bound, [&](std::size_t i, std::size_t j) {
      Offers& own = offers.local();
      if(are_ties)
        own.minimum.offer_tie(i, j);
      else
        own.minimum.offer(i, j);
      return own.counter.step();
    }, progress_);
    offers.for_each([&](const Offers& own) { minimum_.offer_pair_of(own.minimum); });
    if(budget.is_exceeded())
      return Reported::TOO_MANY;
    return budget.is_used() ? Reported::FEW : Reported::NONE;
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
      divide_and_conquer<ConcurrencyTag>(points_.size(), scene_.dimension(), minimum_, progress_);
  }

  static constexpr int max_exponent = std::numeric_limits<double>::max_exponent - 1;
  static constexpr double max_reach = 0x1p1023; // beyond it, longer bounds may overflow

  const Elements& points_;
  const Scene& scene_;
  std::uint64_t seed_; // of what is drawn next
  Progress& progress_;
  const Report_near& report_near_;
  Minimum minimum_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_SEARCH_H
