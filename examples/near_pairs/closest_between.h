// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The closest pair of a point of one set and a point of another one.

#ifndef NEAR_PAIRS_CLOSEST_BETWEEN_H
#define NEAR_PAIRS_CLOSEST_BETWEEN_H

#include "error.h"
#include "progress.h"
#include "stop.h"

#include <CGAL/Distance_bound.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Thick_point_traits_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace near_pairs {

// The double halfway between two that are not negative, in the order of doubles.
inline double middle_double(double low, double high)
{
  std::uint64_t bits[2];
  std::memcpy(&bits[0], &low, sizeof low);
  std::memcpy(&bits[1], &high, sizeof high);
  const std::uint64_t middle_bits = bits[0] + (bits[1] - bits[0]) / 2;
  double middle;
  std::memcpy(&middle, &middle_bits, sizeof middle);
  return middle;
}

// Searches within the distance of the best pair so far, and breaks off a search that finds too many
// pairs. So each search takes O(n) pairs, and 64 of them halve the doubles below the first distance
// until none is left: only then does a search go on whatever it finds.
template <class ConcurrencyTag, class Point>
class Closest_between
{
public:
  using Pair = std::pair<std::size_t, std::size_t>; // of positions in the two sets

  // The first `first_size` points are one set, the others are the other one. Neither is empty.
  Closest_between(const std::vector<Point>& points, std::size_t first_size)
    : points_(points), first_size_(first_size), most_(4 * points.size())
  {}

  // The lexicographically first of the closest pairs. Throws Error if the search is to stop.
  Pair operator()()
  {
    take_sample();
    shrink();
    return first_of_ties();
  }

private:
  using Number = CGAL::Exact_rational;
  using Bound = CGAL::Distance_bound<Number>;
  using Is_near = CGAL::Thick_point_traits_d<Point>;

  const Point& first(std::size_t i) const { return points_[i]; }
  const Point& second(std::size_t j) const { return points_[first_size_ + j]; }
  std::size_t second_size() const { return points_.size() - first_size_; }

  // Searches the first `prefix` points of the first set. Returns false iff the callback stopped the
  // search. Throws Error if something else did.
  template <class Callback>
  bool report(std::size_t prefix, const Bound& bound, Callback callback) const
  {
    std::mutex mutex; // several threads may call
    const auto begin = points_.begin(), middle = begin + static_cast<std::ptrdiff_t>(first_size_);
    const bool is_complete = CGAL::fixed_radius_near_neighbors<ConcurrencyTag>(
      CGAL::make_range(begin, begin + static_cast<std::ptrdiff_t>(prefix)),
      CGAL::make_range(middle, points_.end()), bound, [&](std::size_t i, std::size_t j) -> bool {
        const std::lock_guard<std::mutex> lock(mutex);
        return callback(i, j);
      },
      CGAL::parameters::callback(progress_functor(false)));
    if(stop_requested)
      throw Error("stopped");
    return is_complete;
  }

  // Takes the pair if it is closer than the best one.
  void offer(const Point& p, const Point& q)
  {
    if(is_closer_ && !is_closer_->do_intersect_d_object()(p, q))
      return;
    squared_ = Number(0);
    for(int axis = 0; axis < 3; ++axis) {
      const Number difference = Number(p.cartesian(axis)) - Number(q.cartesian(axis));
      squared_ += difference * difference;
    }
    is_closer_.emplace(CGAL::within_squared_distance(squared_).open());
  }

  void take_sample()
  {
    const std::size_t sample = 8, step = std::max<std::size_t>(first_size_ / sample, 1);
    for(std::size_t i = 0; i < first_size_; i += step)
      for(std::size_t j = 0; j < second_size(); ++j)
        offer(first(i), second(j));
  }

  // Looks for pairs that are closer than this. Returns whether it has seen all of them.
  bool search(const Number& squared, std::size_t most)
  {
    return report(first_size_, CGAL::within_squared_distance(squared).open(),
                  [&, count = std::size_t(0)](std::size_t i, std::size_t j) mutable {
                    offer(first(i), second(j));
                    return ++count < most;
                  });
  }

  // Invariant: no pair has a smaller squared distance than `low`.
  void shrink()
  {
    double low = 0;
    while(squared_ != 0 && !search(squared_, most_)) {
      const Number best = squared_;
      const double middle = middle_double(low, CGAL::to_double(best));
      if(middle <= low || Number(middle) >= best) {
        search(best, std::numeric_limits<std::size_t>::max());
        return;
      }
      const bool is_complete = search(Number(middle), most_);
      if(is_complete && squared_ < best)
        return;
      if(is_complete)
        low = middle;
    }
  }

  // There may be very many ties. If so, halving finds the shortest prefix of the first set that has
  // one.
  Pair first_of_ties() const
  {
    const Bound bound = CGAL::within_squared_distance(squared_);
    std::size_t count = 0;
    Pair best(first_size_, second_size());
    const bool is_complete = report(first_size_, bound, [&](std::size_t i, std::size_t j) {
      best = std::min(best, Pair(i, j));
      return ++count < most_;
    });
    if(is_complete)
      return best;
    std::size_t without = 0, with = best.first + 1; // lengths of prefixes
    while(with - without > 1) {
      const std::size_t middle = without + (with - without) / 2;
      const bool has_none
        = report(middle, bound, [](std::size_t, std::size_t) { return false; });
      (has_none ? without : with) = middle;
    }
    const Is_near traits(bound);
    std::size_t j = 0;
    while(!traits.do_intersect_d_object()(first(without), second(j)))
      ++j;
    return Pair(without, j);
  }

  const std::vector<Point>& points_;
  const std::size_t first_size_;
  const std::size_t most_;            // pairs of a search, before it is broken off
  Number squared_;                    // the distance of the best pair
  std::optional<Is_near> is_closer_;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_CLOSEST_BETWEEN_H
