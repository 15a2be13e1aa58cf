// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H

// The buckets of [L] (Closest_pair_search.h) find a pair within distance r. Put the points into
// cells of side r, and sort the cells by radix. If a cell holds more points than packing.h allows,
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
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Strip_numbering.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/packing.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <mutex>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag, class Elements>
class Close_pair_buckets
{
  using Point = typename Elements::value_type;
  using Number = Coordinate_t<Point>;
  using Found = std::optional<Position_pair>;

public:
  // Takes the points of the scene.
  Close_pair_buckets(const Elements& points, const Scene& scene,
                     const Is_within_distance<Point>& is_within,
                     Bucket_access access = Bucket_access::HASHING)
    : points_(points), scene_(scene), is_within_(is_within), access_(access)
  {}

  // Returns a pair of the points at `positions` within the bound, if there is one. In sequence, the
  // same positions give the same pair. Each point is one step of progress per axis, and one more.
  template <class Positions, class Progress>
  Found find(const Positions& positions, Progress& progress) const
  {
    if(positions.size() < 2 || progress.is_cancelled())
      return std::nullopt;
    std::vector<std::vector<Cell_number>> numbers(dimension());
    for(int axis = 0; axis < dimension(); ++axis) {
      numbers[axis] = can_round(axis) ? number_rounded(positions, axis)
                                      : number_strips(positions, axis);
      if(!progress.advance(positions.size()))
        return std::nullopt;
    }
    const Cell_table table(positions.size(), dimension(), [&](std::size_t member, int axis) {
      return numbers[axis][member];
    });
    if(const Found pair = find_in_heavy_bucket(table, positions))
      return pair;
    const Forward_offsets offsets(dimension());
    if(access_ == Bucket_access::SORTED_ORDER)
      return find_in_buckets(table, positions, offsets.size(), progress,
                             [&] { return Sorted_bucket_finder(table, offsets); });
    const Bucket_dictionary dictionary(table, offsets, dimension());
    return find_in_buckets(table, positions, offsets.size(), progress,
                           [&] { return std::cref(dictionary); });
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
  template <class Positions>
  std::vector<Cell_number> number_rounded(const Positions& positions, int axis) const
  {
    const double low = scene_.box[axis].low;
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
    const auto is_beyond = [&](Place a, Place b) {
      return !is_within_.is_within_along(points_[positions[a]], points_[positions[b]], axis);
    };
    Strip_numbering<Place, decltype(is_beyond)> number_of_strip(is_beyond);
    std::vector<Cell_number> numbers(positions.size());
    for(const Place member : sort_along(positions, axis))
      numbers[member] = number_of_strip(member);
    return numbers;
  }

  // Returns the members of `positions` in order along an axis.
  template <class Positions>
  std::vector<Place> sort_along(const Positions& positions, int axis) const
  {
    std::vector<Place> order(positions.size());
    if constexpr(is_held_by_double_v<Number>) {
      std::vector<Keyed_value> items(positions.size());
      for(std::size_t i = 0; i < positions.size(); ++i)
        items[i] = {radix_key(static_cast<double>(coordinate(points_[positions[i]], axis))),
                    static_cast<Place>(i)};
      radix_sort(items);
      std::transform(items.begin(), items.end(), order.begin(),
                     [](const Keyed_value& item) { return item.value; });
    }
    else {
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](Place a, Place b) {
        return coordinate(points_[positions[a]], axis) < coordinate(points_[positions[b]], axis);
      });
    }
    return order;
  }

  // Looks at only N + 1 members of a bucket with more than N: two of them are close.
  template <class Positions>
  Found find_in_heavy_bucket(const Cell_table& table, const Positions& positions) const
  {
    const std::size_t most = max_points_per_cell(dimension());
    for(std::size_t bucket = 0; bucket < table.bucket_count(); ++bucket)
      if(table.end(bucket) - table.begin(bucket) > most)
        return find_within(table, table.begin(bucket), table.begin(bucket) + most + 1, positions);
    return std::nullopt;
  }

  // Compares each bucket with itself and with the adjacent buckets ahead. `make_finder()` returns a
  // function find(bucket, i), which returns the bucket at offset `i`. The search calls it for
  // increasing buckets.
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
  const Scene& scene_;
  const Is_within_distance<Point>& is_within_;
  Bucket_access access_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSE_PAIR_BUCKETS_H
