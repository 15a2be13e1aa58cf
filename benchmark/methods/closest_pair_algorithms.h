// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The algorithms of [L] that the library has: divide and conquer for the closest pair, and cells as
// long as the distance for a close one. No other file of the benchmarks knows how it calls them.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_CLOSEST_PAIR_ALGORITHMS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_CLOSEST_PAIR_ALGORITHMS_H

#include <CGAL/closest_pair.h>

#include <cstddef>
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

  // Whether there is a pair within the bound.
  bool has_pair_in_cells(const CGAL::Distance_bound<double>& bound) const
  {
    const internal::Is_within_distance<Point> is_within(
      internal::Squared_bound<internal::Exact_number_t<double>>(bound), Dimension);
    internal::Unwatched_progress progress;
    return internal::Close_pair_buckets<Elements>(elements_, n_, scene_, is_within)
      .find(progress).has_value();
  }

private:
  const Elements elements_;
  const std::size_t n_;
  const internal::Scene scene_;
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_CLOSEST_PAIR_ALGORITHMS_H
