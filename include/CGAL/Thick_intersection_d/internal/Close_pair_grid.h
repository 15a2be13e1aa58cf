// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSE_PAIR_GRID_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSE_PAIR_GRID_H

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

#include <CGAL/Thick_intersection_d/internal/Cell_table.h>
#include <CGAL/Thick_intersection_d/internal/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/packing.h>
#include <CGAL/Thick_intersection_d/internal/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
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
  Close_pair_grid(const Elements& points, const Squared_bound<Exact>& bound, int dimension,
                  Bucket_access access = Bucket_access::HASHING)
    : points_(points), bound_(bound), filter_(make_distance_filter(bound, dimension)),
      is_within_(bound, filter_, dimension), dimension_(dimension), access_(access)
  {}

  // Returns a pair of the points at `positions` within the bound, if there is one: in sequence,
  // always the same for the same positions.
  template <class Positions>
  Found find(const Positions& positions) const
  {
    if(positions.size() < 2)
      return std::nullopt;
    std::vector<std::vector<Cell_number>> numbers(dimension_);
    for(int axis = 0; axis < dimension_; ++axis)
      if(!number_rounded(positions, axis, numbers[axis]))
        number_strips(positions, axis, numbers[axis]);
    const Cell_table table(positions.size(), dimension_, [&](std::size_t member, int axis) {
      return numbers[axis][member];
    });
    if(const Found pair = find_in_heavy_bucket(table, positions))
      return pair;
    return access_ == Bucket_access::HASHING ? find_by_hashing(table, positions)
                                             : find_in_order(table, positions);
  }

private:
  // Numbers cells along an axis from 1. Returns false if they would be too many, or not exact.
  template <class Positions>
  bool number_rounded(const Positions& positions, int axis,
                      std::vector<Cell_number>& numbers) const
  {
    std::pair<double, double> range = bounds(coordinate(points_[positions[0]], axis));
    double error = 0;
    for(std::size_t i = 0; i < positions.size(); ++i) {
      const std::pair<double, double> x = bounds(coordinate(points_[positions[i]], axis));
      range = {(std::min)(range.first, x.first), (std::max)(range.second, x.second)};
      error = (std::max)(error, x.second - x.first);
    }
    const double side = (bound_.reach() + error) * (1 + std::ldexp(1., -16));
    if(!(bound_.reach() >= std::ldexp(1., -900) && bound_.reach() <= std::ldexp(1., 900)
         && error <= bound_.reach() * std::ldexp(1., -20)
         && (range.second - range.first) / side < std::ldexp(1., 30)))
      return false;

    const double scale = 1 / side;
    numbers.resize(positions.size());
    for(std::size_t i = 0; i < positions.size(); ++i)
      numbers[i] = 1 + static_cast<Cell_number>(
        (bounds(coordinate(points_[positions[i]], axis)).first - range.first) * scale);
    return true;
  }

  template <class Positions>
  void number_strips(const Positions& positions, int axis,
                     std::vector<Cell_number>& numbers) const
  {
    const std::vector<std::uint32_t> order = sort_along(positions, axis);
    numbers.resize(positions.size());
    Cell_number number = 0;
    std::size_t first = 0; // the first member of the strip
    for(const std::uint32_t member : order) {
      if(number == 0 || !is_within_along(positions[member], positions[first], axis)) {
        ++number;
        first = member;
      }
      numbers[member] = number;
    }
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
    const Gap g = gap(coordinate(p, axis), coordinate(q, axis));
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

  template <class Positions>
  Found find_by_hashing(const Cell_table& table, const Positions& positions) const
  {
    const Forward_offsets offsets(dimension_);
    const Bucket_dictionary dictionary(table, dimension_);
    return find_in_buckets(table, positions, [&] {
      return [&](std::size_t bucket, const auto& compare) {
        for(std::size_t i = 0; i < offsets.size(); ++i)
          if(compare(dictionary(bucket, offsets[i])))
            return;
      };
    });
  }

  template <class Positions>
  Found find_in_order(const Cell_table& table, const Positions& positions) const
  {
    const Forward_offsets offsets(dimension_);
    return find_in_buckets(table, positions, [&] {
      return [&, finder = Sorted_bucket_finder(table, offsets)](std::size_t bucket,
                                                                const auto& compare) mutable {
        for(std::size_t i = 0; i < offsets.size(); ++i)
          if(compare(finder(bucket, i)))
            return;
      };
    });
  }

  // Compares each bucket with itself and with the adjacent ones ahead. `make_visitor()` returns a
  // function that is called as visit(bucket, compare) for increasing buckets, and calls
  // compare(other) for those adjacent ones until it returns true.
  template <class Positions, class Make_visitor>
  Found find_in_buckets(const Cell_table& table, const Positions& positions,
                        const Make_visitor& make_visitor) const
  {
    Found result;
    std::mutex mutex;
    std::atomic<bool> is_found = false;
    for_each_block<ConcurrencyTag>(table.bucket_count(), [&](std::size_t first, std::size_t last) {
      auto visit = make_visitor();
      Found pair;
      for(std::size_t bucket = first;
          bucket != last && !is_found.load(std::memory_order_relaxed); ++bucket) {
        pair = find_within(table, table.begin(bucket), table.end(bucket), positions);
        if(!pair)
          visit(bucket, [&](std::size_t other) {
            if(other != table.bucket_count())
              pair = find_between(table, bucket, other, positions);
            return pair.has_value();
          });
        if(pair)
          is_found.store(true, std::memory_order_relaxed);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      if(pair)
        result = pair;
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
  const Distance_filter filter_;
  const Is_within_distance<Point> is_within_;
  int dimension_;
  Bucket_access access_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSE_PAIR_GRID_H
