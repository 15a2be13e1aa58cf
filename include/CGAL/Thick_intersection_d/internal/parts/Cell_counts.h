// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CELL_COUNTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CELL_COUNTS_H

// How many points there are around each point of a sample: what the work of a part is made of.

#include <CGAL/Thick_intersection_d/internal/arrays/Hash_table.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Counts the points in cells as wide as the reach, but only in those that hold a point of the
// sample. Counts of all parts can be added: they depend on the sample alone, and not on where the
// points are. Two cells with the same hash count as one.
class Cell_counts
{
public:
  // The sample is of `point_count` points.
  Cell_counts(const Point_sample& sample, std::uint64_t point_count, double reach)
    : dimension_(sample.dimension), reach_(reach),
      share_(static_cast<double>(sample.size()) / static_cast<double>(point_count)),
      hash_(dimension_, 1), keys_(sample.size()), counts_(keys_.slot_count())
  {
    for(std::size_t i = 0; i < sample.size(); ++i) {
      const std::uint64_t key = key_of(sample.point(i));
      keys_[slot_of(key)] = key;
    }
  }

  // A point in a cell of the sample, which stands for `count` points.
  struct Counted_point
  {
    std::size_t position;
    std::size_t slot;
    std::size_t count;
  };

  // Adds points of a part: all of them, or random ones that stand for as many points each. Returns
  // those that are in cells of the sample.
  template <class Carried>
  std::vector<Counted_point> add_some(const Part_points<Carried>& part)
  {
    std::vector<Counted_point> counted;
    const std::size_t step = part.size() / max_looked_at + 1;
    Random_numbers random;
    for(std::size_t first = 0; first < part.size(); first += step) {
      const std::size_t count = (std::min)(step, part.size() - first);
      const std::size_t position = first + random.below(count);
      const std::uint64_t key = key_of(part.points[position]);
      const std::size_t slot = slot_of(key);
      if(keys_[slot] == key) {
        counts_[slot] += count;
        counted.push_back({position, slot, count});
      }
    }
    return counted;
  }

  std::vector<std::uint64_t>& counts() { return counts_; }

  // Adds some of the counted points of a part to `chosen`, so that each stands for as many pairs.
  // All parts together add about `total` points. A point of a crowd is there as often as it has
  // to be.
  template <class Carried>
  void choose_by_pairs(const Part_points<Carried>& part, const std::vector<Counted_point>& counted,
                       std::size_t total, Point_sample& chosen) const
  {
    double all = 0;
    for(std::size_t slot = 0; slot < counts_.size(); ++slot)
      all += pairs_of_point(slot) * static_cast<double>(counts_[slot]);
    const double step = all / static_cast<double>(total);
    double sum = step / 2;
    for(const Counted_point& point : counted) {
      sum += pairs_of_point(point.slot) * static_cast<double>(point.count);
      for(; step > 0 && sum >= step; sum -= step)
        chosen.add(part.points[point.position], part.ids[point.position]);
    }
  }

private:
  static constexpr std::size_t max_looked_at = 1 << 17;

  // Returns a number in proportion to the pairs of a point in a cell. A cell stands for those like
  // it that hold no point of the sample: it is divided by the probability that it holds one.
  double pairs_of_point(std::size_t slot) const
  {
    const double count = static_cast<double>(counts_[slot]);
    return count > 1 ? (count - 1) / -std::expm1(-share_ * count) : 0;
  }

  // The key of a cell is odd, so it is not zero.
  template <class Coordinates>
  std::uint64_t key_of(const Coordinates& x) const
  {
    std::uint64_t sum = 0;
    for(int axis = 0; axis < dimension_; ++axis) {
      const double value = x[static_cast<std::size_t>(axis)];
      const double cell = (reach_ > 0 ? std::floor(value / reach_) : value) + 0.; // no minus zero
      std::uint64_t number;
      std::memcpy(&number, &cell, sizeof number);
      sum = hash_.add(sum, axis, number);
    }
    return hash_.finish(sum) | 1;
  }

  // Returns the slot with the key, or the free one where it belongs.
  std::size_t slot_of(std::uint64_t key) const
  {
    return keys_.find(key, [=](std::uint64_t other) { return other == key; });
  }

  int dimension_;
  double reach_;
  double share_; // of the sample
  Sequence_hash<> hash_; // with the same seed in all processes
  Hash_table<std::uint64_t, 0> keys_;
  std::vector<std::uint64_t> counts_; // of the slots
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CELL_COUNTS_H
