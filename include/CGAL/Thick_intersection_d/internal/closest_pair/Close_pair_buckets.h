// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H

// The buckets of [L] (Closest_pair_search.h) find a pair within distance r. Put the points into
// cells of side r, and sort the cells by radix. If a cell holds more points than fit in it,
// two of its points are close. Otherwise compare each bucket with itself and with the buckets of
// adjacent cells. This takes linear time.
//
// Two properties of the cells are enough. First, the cell numbers of points within r of each other
// differ by at most one along each axis. Second, cells are larger than r only by a factor that
// leaves the packing lemma true. There are two ways to number cells along an axis.
//
// Rounded: t = (x - low) * scale, cut to an integer, where 1 / scale is r (1 + 2^-16) and t is less
// than 2^30. Each operation, here and in the computation of the scale, has a relative error of at
// most 2^-52, so t is off by less than 2^-19. For |x - y| <= r, t differs by less than
//   1 / (1 + 2^-16) + 2^-18 < 1,
// and the integers differ by at most one. The cells are larger than r by a factor of at most
// 1 + 2^-15. Coordinates between doubles that are e apart add e to r, for e <= 2^-20 r.
//
// By strips: sort the points along the axis, doubles by radix. A strip ends behind the last point
// within r of its first point. Points in strips that are not adjacent have a whole strip between
// them, whose first point is more than r below the first point of the next strip. The comparisons
// are exact, so this works for all r, all coordinates and any extent.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements>
class Close_pair_buckets
{
  using Point = typename Elements::value_type;
  using Number = Coordinate_t<Point>;
  using Found = std::optional<Position_pair>;

public:
  // Takes the first `size` points of the scene.
  Close_pair_buckets(const Elements& points, std::size_t size, const Scene& scene,
                     const Is_within_distance<Point>& is_within, const Threads& threads = Threads())
    : points_(points), size_(size), scene_(scene), is_within_(is_within), threads_(threads)
  {}

  // Returns a pair within the bound, if there is one. In sequence, the same points give the same
  // pair. Each point is one step of progress per axis, and one more.
  template <class Progress>
  Found find(Progress& progress) const
  {
    if(size_ < 2 || progress.is_cancelled())
      return std::nullopt;
    std::vector<std::vector<Cell_number>> numbers(dimension());
    for(int axis = 0; axis < dimension(); ++axis) {
      numbers[axis] = can_round(axis) ? number_rounded(axis) : number_strips(axis);
      if(!progress.advance(size_))
        return std::nullopt;
    }
    const Cell_table table(size_, dimension(), [&](std::size_t member, int axis) {
      return numbers[axis][member];
    });
    const Found pair = find_in_heavy_bucket(table);
    return pair ? pair : find_in_buckets(table, progress);
  }

private:
  int dimension() const { return scene_.dimension(); }
  double reach() const { return is_within_.reach(); }
  double side() const { return (reach() + scene_.error) * (1 + 0x1p-16); }

  // Whether rounded numbers of cells along an axis are exact enough, and not too large.
  bool can_round(int axis) const
  {
    return reach() >= 0x1p-900 && reach() <= 0x1p900 && scene_.error <= reach() * 0x1p-20
           && scene_.box[axis].length() / side() < 0x1p30;
  }

  // Returns the number of the cell of each point along an axis. The first cell has number 1.
  std::vector<Cell_number> number_rounded(int axis) const
  {
    const double low = scene_.box[axis].low;
    const double scale = 1 / side();
    std::vector<Cell_number> numbers(size_);
    for(std::size_t i = 0; i < size_; ++i)
      numbers[i] = 1 + static_cast<Cell_number>(
        (coordinate_bounds(points_[i], axis).first - low) * scale);
    return numbers;
  }

  std::vector<Cell_number> number_strips(int axis) const
  {
    const auto is_beyond = [&](Place a, Place b) {
      return !is_within_.is_within_along(points_[a], points_[b], axis);
    };
    Strip_numbering<Place, decltype(is_beyond)> number_of_strip(is_beyond);
    std::vector<Cell_number> numbers(size_);
    for(const Place position : sort_along(axis))
      numbers[position] = number_of_strip(position);
    return numbers;
  }

  // Returns the points in order along an axis.
  std::vector<Place> sort_along(int axis) const
  {
    std::vector<Place> order(size_);
    if constexpr(is_held_by_double_v<Number>) {
      std::vector<Keyed_value> items(size_);
      for(std::size_t i = 0; i < size_; ++i)
        items[i] = {radix_key(static_cast<double>(coordinate(points_[i], axis))),
                    static_cast<Place>(i)};
      radix_sort(items);
      std::transform(items.begin(), items.end(), order.begin(),
                     [](const Keyed_value& item) { return item.value; });
    }
    else {
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](Place a, Place b) {
        return coordinate(points_[a], axis) < coordinate(points_[b], axis);
      });
    }
    return order;
  }

  // Looks at only N + 1 members of a bucket with more than N: two of them are close.
  Found find_in_heavy_bucket(const Cell_table& table) const
  {
    const std::size_t most = max_points_per_cell(dimension());
    for(std::size_t bucket = 0; bucket < table.bucket_count(); ++bucket)
      if(const std::size_t begin = table.begin(bucket); table.end(bucket) - begin > most)
        return find_pair(table, begin, begin + most + 1, begin, begin + most + 1);
    return std::nullopt;
  }

  // Compares each bucket with itself and with the adjacent buckets ahead.
  template <class Progress>
  Found find_in_buckets(const Cell_table& table, Progress& progress) const
  {
    const Forward_offsets offsets(dimension());
    Found result;
    std::mutex mutex;
    std::atomic<bool> go_on = true;
    const auto search = [&](std::size_t, std::size_t first, std::size_t last) {
      Sorted_bucket_finder find(table, offsets, first);
      Found pair;
      for(std::size_t bucket = first;
          bucket != last && go_on.load(std::memory_order_relaxed); ++bucket) {
        const std::size_t begin = table.begin(bucket), end = table.end(bucket);
        pair = find_pair(table, begin, end, begin, end);
        for(std::size_t i = 0; !pair && i < offsets.size(); ++i) {
          const std::size_t other = find(bucket, i);
          if(other != table.bucket_count())
            pair = find_pair(table, begin, end, table.begin(other), table.end(other));
        }
        if(pair || !progress.advance(end - begin))
          go_on.store(false, std::memory_order_relaxed);
      }
      if(pair) {
        const std::lock_guard<std::mutex> lock(mutex);
        result = pair;
      }
    };
    threads_.run_numbered_blocks(threads_.block_count(), table.bucket_count(), search);
    return result;
  }

  // Finds a pair of a member at the places [a, a_end) and one behind it at [b, b_end).
  Found find_pair(const Cell_table& table, std::size_t a, std::size_t a_end, std::size_t b,
                  std::size_t b_end) const
  {
    for(; a < a_end; ++a)
      for(std::size_t other = (std::max)(a + 1, b); other < b_end; ++other)
        if(const Found pair = test(table.member(a), table.member(other)))
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
  std::size_t size_;
  const Scene& scene_;
  const Is_within_distance<Point>& is_within_;
  const Threads threads_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H
