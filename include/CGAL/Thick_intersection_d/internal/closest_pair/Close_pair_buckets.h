// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H

// The grid of [L] for a pair within distance r: points are put into cells of side r, and the cells
// are radix-sorted. If a cell holds more points than packing.h allows then two of them are close.
// Otherwise each bucket is compared with itself and with those of adjacent cells: linear time.
//
// Cells are asked for two properties only: points within r of each other have numbers that differ
// by at most one along each axis, and points of one cell are within a factor of r along each axis
// that leaves the packing lemma true. There are two ways to number them.
//
// Rounded: t = (x - low) * scale, cut to an integer, where 1 / scale is r (1 + 2^-16) and t is less
// than 2^30. Each of these operations, and of those that made the scale, has a relative error of at
// most 2^-52, so that t is off by less than 2^-19. For |x - y| <= r, t differs by less than
//   1 / (1 + 2^-16) + 2^-18 < 1,
// and the integers by at most one. The cells are larger than r by a factor of 1 + 2^-15 at most.
// Coordinates between doubles that are e apart add e to r, for e <= 2^-20 r.
//
// By strips: the points are sorted along the axis, and a strip ends behind the last point that is
// within r of its first one. Points in strips that are not adjacent have a whole strip between
// them, the first point of which is more than r below the first one of the next. The comparisons
// are exact, so this works for all r and all coordinates, with any extent; doubles are sorted by
// radix.

#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/packing.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag, class Elements>
class Close_pair_grid
{
  using Point = typename Elements::value_type;
  using Number = Coordinate_t<Point>;
  using Exact = Exact_number_t<Number>;
  using Found = std::optional<Position_pair>;

public:
  // Of points in the scene of `profile`, whose coordinates have doubles around them that are at
  // most `error` apart.
  Close_pair_grid(const Elements& points, const Squared_bound<Exact>& bound,
                  const Scene_profile& profile, double error,
                  Bucket_access access = Bucket_access::HASHING)
    : points_(points), bound_(bound), profile_(profile), dimension_(profile.dimension()),
      error_(error), access_(access), filter_(make_distance_filter(bound, dimension_)),
      is_within_(bound, filter_, dimension_)
  {}

  // Returns a pair of the points at `positions` within the bound, if there is one: in sequence,
  // always the same for the same positions. The progress is that of all points once for each axis,
  // and once more.
  template <class Positions, class Progress>
  Found find(const Positions& positions, Progress& progress) const
  {
    if(positions.size() < 2 || progress.is_cancelled())
      return std::nullopt;
    std::vector<std::vector<Cell_number>> numbers(dimension_);
    for(int axis = 0; axis < dimension_; ++axis) {
      numbers[axis] = can_round(axis) ? number_rounded(positions, axis)
                                      : number_strips(positions, axis);
      if(!progress.advance(positions.size()))
        return std::nullopt;
    }
    const Cell_table table(positions.size(), dimension_, [&](std::size_t member, int axis) {
      return numbers[axis][member];
    });
    if(const Found pair = find_in_heavy_bucket(table, positions))
      return pair;
    const Forward_offsets offsets(dimension_);
    if(access_ == Bucket_access::SORTED_ORDER)
      return find_in_buckets(table, positions, offsets.size(), progress,
                             [&] { return Sorted_bucket_finder(table, offsets); });
    const Bucket_dictionary dictionary(table, offsets, dimension_);
    return find_in_buckets(table, positions, offsets.size(), progress,
                           [&] { return std::cref(dictionary); });
  }

private:
  double side() const { return (bound_.reach() + error_) * (1 + std::ldexp(1., -16)); }

  // Whether rounded numbers along an axis are exact enough, and not too large.
  bool can_round(int axis) const
  {
    const std::pair<double, double>& range = profile_.range(axis);
    return bound_.reach() >= std::ldexp(1., -900) && bound_.reach() <= std::ldexp(1., 900)
           && error_ <= bound_.reach() * std::ldexp(1., -20)
           && (range.second - range.first) / side() < std::ldexp(1., 30);
  }

  // Returns the number of the cell of each point along an axis; the first cell has number 1.
  template <class Positions>
  std::vector<Cell_number> number_rounded(const Positions& positions, int axis) const
  {
    const double low = profile_.range(axis).first;
    const double scale = 1 / side();
    std::vector<Cell_number> numbers(positions.size());
    for(std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = 1 + static_cast<Cell_number>(
        (coordinate_bounds(points_[positions[i]], axis).first - low) * scale);
    return numbers;
  }

  template <class Positions>
  std::vector<Cell_number> number_strips(const Positions& positions, int axis) const
  {
    const std::vector<std::uint32_t> order = sort_along(positions, axis);
    std::vector<Cell_number> numbers(positions.size());
    Cell_number number = 0;
    std::size_t first = 0; // the first member of the strip
    for(const std::uint32_t member : order) {
      if(number == 0 || !is_within_along(positions[member], positions[first], axis)) {
        ++number;
        first = member;
      }
      numbers[member] = number;
    }
    return numbers;
  }

  // Returns the members of `positions` in order along an axis.
  template <class Positions>
  std::vector<std::uint32_t> sort_along(const Positions& positions, int axis) const
  {
    std::vector<std::uint32_t> order(positions.size());
    if constexpr(is_held_by_double_v<Number>) {
      std::vector<Keyed_value> items(positions.size());
      for(std::size_t i = 0; i < positions.size(); ++i)
        items[i] = {radix_key(static_cast<double>(coordinate(points_[positions[i]], axis))),
                    static_cast<std::uint32_t>(i)};
      radix_sort(items);
      std::transform(items.begin(), items.end(), order.begin(),
                     [](const Keyed_value& item) { return item.value; });
    }
    else {
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return coordinate(points_[positions[a]], axis) < coordinate(points_[positions[b]], axis);
      });
    }
    return order;
  }

  // Whether points are within the bound along an axis, exactly.
  bool is_within_along(std::size_t i, std::size_t j, int axis) const
  {
    const auto& p = points_[i];
    const auto& q = points_[j];
    const Gap g = gap_along(p, q, axis);
    if(g.sup * g.sup <= filter_.inside)
      return true;
    if(g.inf * g.inf > filter_.outside)
      return false;
    const Exact difference
      = to_exact_number(coordinate(p, axis)) - to_exact_number(coordinate(q, axis));
    return bound_.holds_for(Exact(difference * difference));
  }

  // The members of a bucket that has more than N are not all looked at: N + 1 have a close pair.
  template <class Positions>
  Found find_in_heavy_bucket(const Cell_table& table, const Positions& positions) const
  {
    const std::size_t most = greatest_packing(dimension_);
    for(std::size_t bucket = 0; bucket < table.bucket_count(); ++bucket)
      if(table.end(bucket) - table.begin(bucket) > most)
        return find_within(table, table.begin(bucket), table.begin(bucket) + most + 1, positions);
    return std::nullopt;
  }

  // Compares each bucket with itself and with the adjacent ones ahead. `make_finder()` returns a
  // function that is called as find(bucket, i) for increasing buckets, and returns the bucket at
  // the offset `i`.
  template <class Positions, class Progress, class Make_finder>
  Found find_in_buckets(const Cell_table& table, const Positions& positions,
                        std::size_t offset_count, Progress& progress,
                        const Make_finder& make_finder) const
  {
    Found result;
    std::mutex mutex;
    std::atomic<bool> go_on = true;
    for_each_block<ConcurrencyTag>(table.bucket_count(), [&](std::size_t first, std::size_t last) {
      auto find = make_finder();
      Found pair;
      for(std::size_t bucket = first;
          bucket != last && go_on.load(std::memory_order_relaxed); ++bucket) {
        pair = find_within(table, table.begin(bucket), table.end(bucket), positions);
        for(std::size_t i = 0; !pair && i < offset_count; ++i) {
          const std::size_t other = find(bucket, i);
          if(other != table.bucket_count())
            pair = find_between(table, bucket, other, positions);
        }
        if(pair || !progress.advance(table.end(bucket) - table.begin(bucket)))
          go_on.store(false, std::memory_order_relaxed);
      }
      if(pair) {
        const std::lock_guard<std::mutex> lock(mutex);
        result = pair;
      }
    });
    return result;
  }

  template <class Positions>
  Found find_within(const Cell_table& table, std::size_t begin, std::size_t end,
                    const Positions& positions) const
  {
    for(std::size_t a = begin; a < end; ++a)
      for(std::size_t b = a + 1; b < end; ++b)
        if(const Found pair = test(positions[table.member(a)], positions[table.member(b)]))
          return pair;
    return std::nullopt;
  }

  template <class Positions>
  Found find_between(const Cell_table& table, std::size_t bucket, std::size_t other,
                     const Positions& positions) const
  {
    for(std::size_t a = table.begin(bucket); a != table.end(bucket); ++a)
      for(std::size_t b = table.begin(other); b != table.end(other); ++b)
        if(const Found pair = test(positions[table.member(a)], positions[table.member(b)]))
          return pair;
    return std::nullopt;
  }

  Found test(std::size_t i, std::size_t j) const
  {
    if(!is_within_(points_[i], points_[j]))
      return std::nullopt;
    return Position_pair(std::minmax(i, j));
  }

  const Elements& points_;
  const Squared_bound<Exact>& bound_;
  const Scene_profile& profile_;
  int dimension_;
  double error_;
  Bucket_access access_;
  const Distance_filter filter_;
  const Is_within_distance<Point> is_within_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H
