// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The algorithms for the closest pair and for a close one: that of [L] by divide and conquer, the
// randomised incremental one, and cells as long as the distance. The library has the first one and
// the last one. No other file of the benchmarks knows how it calls them.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_CLOSEST_PAIR_ALGORITHMS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_CLOSEST_PAIR_ALGORITHMS_H

#include "Bucket_dictionary.h"
#include "Incremental_cells.h"

#include <CGAL/closest_pair.h>

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace thick_benchmark {

namespace internal = CGAL::Thick_intersection_d::internal;

template <int Dimension, class Point>
class Closest_pair_algorithms
{
  using Elements = internal::Numbered_elements<std::vector<Point>>;
  using Minimum = internal::Pair_minimum<Elements>;

public:
  using Positions = std::pair<std::size_t, std::size_t>;

  explicit Closest_pair_algorithms(const std::vector<Point>& points)
    : elements_(points), n_(points.size()),
      scene_(internal::scan_points(elements_, "point"))
  {}

  Positions by_division() const
  {
    Minimum minimum(elements_, scene_);
    internal::Unwatched_progress progress;
    internal::divide_and_conquer(n_, Dimension, internal::Threads(), minimum, progress);
    return minimum.pair();
  }

  Positions by_incremental_cells() const
  {
    std::vector<std::uint32_t> positions(n_);
    std::iota(positions.begin(), positions.end(), 0);
    Minimum minimum(elements_, scene_);
    Incremental_cells<Dimension, Elements>(elements_, std::move(positions), scene_, 1)
      .search(minimum);
    return minimum.pair();
  }

  // Whether there is a pair within the bound. Adjacent buckets are found by hashing, or else by the
  // sorted order.
  bool has_pair_in_cells(const CGAL::Distance_bound<double>& bound, bool by_hashing) const
  {
    const internal::Is_within_distance<Point> is_within(
      internal::Squared_bound<internal::Exact_number_t<double>>(bound), Dimension);
    return by_hashing ? has_pair_found_by<Bucket_dictionary>(is_within)
                      : has_pair_found_by<internal::Sorted_bucket_finder>(is_within);
  }

private:
  template <class Finder>
  bool has_pair_found_by(const internal::Is_within_distance<Point>& is_within) const
  {
    internal::Unwatched_progress progress;
    return internal::Close_pair_buckets<Elements, Finder>(
             elements_, n_, scene_, is_within)
      .find(progress).has_value();
  }

  const Elements elements_;
  const std::size_t n_;
  const internal::Scene scene_;
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_CLOSEST_PAIR_ALGORITHMS_H
