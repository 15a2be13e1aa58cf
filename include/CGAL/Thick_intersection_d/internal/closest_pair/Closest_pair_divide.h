// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_DIVIDE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_DIVIDE_H

// The divide and conquer of [L], in any dimension. It takes O(n log n) comparisons of degree 2 in
// the worst case, and only compares, so coordinates may have any type.
//
//   [L]  Computational geometry: closest pair and close pair. Slides of a lecture on algorithms,
//        without name or date.
//
// At the beginning, sort the points along each axis. Divide a range along axis 0 at its middle, and
// the orders along the other axes with it. After the recursion, merge these orders again, and scan
// the strip: the points within d of the dividing line, in order along the last axis. Here d is the
// distance of the closest pair so far.
//
// In dimension D, a closed cube of side d holds at most N points with distances of d or more
// (Cell_table.h).
//
// Theorem. In the plane, a point of the strip is compared with at most 2 N - 1 = 7 points behind it
// [L]. They lie, with the point itself, in two squares of side d, left and right of the line. The
// squares are closed, so the scan looks at pairs at distance d too, and finds ties.
//
// In higher dimension, a scan along one axis is not enough. Further strips cut the strip along each
// axis between the first and the last. A strip ends behind the last point within d of its first
// point, which comparisons find. So points within d of each other are in one cell or in adjacent
// cells. Along axis 0 a cell lies within d of the line, on either side. A point is compared with at
// most 2 N - 1 points behind it in its own cell. It is compared with at most 4 N points in each of
// the (3^(D-2) - 1) / 2 cells ahead: these points lie within d of it along the last axis. Together
// this is 2 N 3^(D-2) - 1, which is 47 in space. Cell_table finds cells in linear time, so T(n) =
// 2 T(n/2) + O(n) in any fixed dimension.
//
// Both bounds need d > 0. Equal points are found first: they are neighbors in lexicographic order.

#include <CGAL/Thick_intersection_d/internal/closest_pair/Axis_orders.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Minimum` can be copied, and has the functions less(), is_beyond(), offer(), offer_pair_of() and
// has_pair() of Pair_minimum.
template <class Minimum>
class Closest_pair_divide
{
public:
  // Takes the points at `positions`.
  Closest_pair_divide(std::vector<std::size_t> positions, int dimension, const Threads& threads)
    : positions_(std::move(positions)), dimension_(dimension), threads_(threads)
  {}

  // Offers pairs to `minimum`, among them the lexicographically smallest closest pair.
  template <class Progress>
  void search(Minimum& minimum, Progress& progress)
  {
    sort_lexicographically(minimum);
    if(offer_equal_points(minimum))
      return;
    orders_.sort(positions_.size(), dimension_, [&](Rank a, Rank b, int axis) {
      return minimum.less(positions_[a], positions_[b], axis);
    });
    strip_.resize(positions_.size());
    progress.restart(positions_.size() * level_count(positions_.size()));
    divide(0, positions_.size(), minimum, progress);
  }

private:
  void sort_lexicographically(const Minimum& minimum)
  {
    std::sort(positions_.begin(), positions_.end(), [&](std::size_t i, std::size_t j) {
      for(int axis = 0; axis < dimension_; ++axis) {
        if(minimum.less(i, j, axis))
          return true;
        if(minimum.less(j, i, axis))
          return false;
      }
      return i < j;
    });
  }

  bool are_equal(std::size_t i, std::size_t j, const Minimum& minimum) const
  {
    for(int axis = 0; axis < dimension_; ++axis)
      if(minimum.less(i, j, axis) || minimum.less(j, i, axis))
        return false;
    return true;
  }

  // Offers the first two points of each set of equal points. They have the smallest positions.
  bool offer_equal_points(Minimum& minimum) const
  {
    bool are_any = false;
    bool is_with_previous = false; // point k is equal to point k - 1
    for(std::size_t k = 0; k + 1 < positions_.size(); ++k) {
      const bool is_with_next = are_equal(positions_[k], positions_[k + 1], minimum);
      if(is_with_next && !is_with_previous)
        minimum.offer(positions_[k], positions_[k + 1]);
      is_with_previous = is_with_next;
      are_any = are_any || is_with_next;
    }
    return are_any;
  }

  // Returns the largest number of ranges of the recursion that a point is in.
  static std::size_t level_count(std::size_t size)
  {
    std::size_t levels = 1;
    for(; size > max_leaf_size; size -= size / 2)
      ++levels;
    return levels;
  }

  // Offers the closest pairs of the ranks [first, last). Leaves the orders as they were.
  template <class Progress>
  void divide(Rank first, Rank last, Minimum& minimum, Progress& progress)
  {
    if(progress.is_cancelled())
      return;
    if(last - first <= max_leaf_size)
      offer_all(first, last, minimum);
    else
      divide_at_middle(first, last, minimum, progress);
    progress.advance(last - first);
  }

  void offer_all(Rank first, Rank last, Minimum& minimum) const
  {
    for(Rank a = first; a != last; ++a)
      for(Rank b = a + 1; b != last; ++b)
        minimum.offer(positions_[a], positions_[b]);
  }

  template <class Progress>
  void divide_at_middle(Rank first, Rank last, Minimum& minimum, Progress& progress)
  {
    const Rank middle = first + (last - first) / 2;
    orders_.divide(first, middle, last);
    conquer(first, middle, last, minimum, progress);
    orders_.merge(first, middle, last);
    scan_strip(first, middle, last, minimum);
  }

  template <class Progress>
  void conquer(Rank first, Rank middle, Rank last, Minimum& minimum, Progress& progress)
  {
    if(threads_.are_many() && last - first > min_task_size) {
      Minimum other(minimum);
      threads_.run_blocks(2, [&](std::size_t half, std::size_t end) {
        for(; half != end; ++half)
          if(half == 0)
            divide(first, middle, minimum, progress);
          else
            divide(middle, last, other, progress);
      });
      minimum.offer_pair_of(other);
    }
    else {
      divide(first, middle, minimum, progress);
      divide(middle, last, minimum, progress);
    }
  }

  // Offers the closest pairs that the line through `middle` separates.
  void scan_strip(Rank first, Rank middle, Rank last, Minimum& minimum)
  {
    const auto is_in_strip = [&](Rank rank) {
      return !minimum.is_beyond(positions_[rank], positions_[middle], 0);
    };
    const Ranks& ranks = orders_.last().ranks;
    const std::size_t end
      = std::copy_if(ranks.begin() + first, ranks.begin() + last, strip_.begin() + first,
                     is_in_strip) - strip_.begin();
    // A short strip needs no cells for the bound on comparisons, unless its points are crowded.
    // Then cells are faster, if a point has fewer cells to look at than it had candidates.
    const bool is_plane = dimension_ <= 2;
    const double steps_per_point = (std::max)(double(max_strip_steps_per_point),
                                              touching_cell_count(dimension_));
    const auto max_steps
      = static_cast<std::size_t>((std::min)(steps_per_point, 1e9) * double(end - first));
    if((is_plane || end - first <= max_candidate_count(dimension_))
       && scan(first, end, is_plane ? unlimited : max_steps, minimum))
      return;
    for(std::size_t i = 0; i + 1 < orders_.size(); ++i)
      number_strips(orders_[i], first, last, is_in_strip, minimum);
    scan_cells(first, end, minimum);
  }

  // Numbers the strips along an axis between the first and the last, for the points of the strip
  // along axis 0.
  template <class Is_in_strip>
  void number_strips(Axis_order& order, Rank first, Rank last, const Is_in_strip& is_in_strip,
                     const Minimum& minimum)
  {
    const auto is_beyond = [&](Rank a, Rank b) {
      return minimum.is_beyond(positions_[a], positions_[b], order.axis);
    };
    Strip_numbering<Rank, decltype(is_beyond)> number_of_strip(is_beyond);
    for(std::size_t place = first; place != last; ++place)
      if(const Rank rank = order.ranks[place]; is_in_strip(rank))
        order.numbers[rank] = number_of_strip(rank);
  }

  void scan_cells(std::size_t first, std::size_t end, Minimum& minimum)
  {
    const int axis_count = dimension_ - 2;
    const Cell_table table(end - first, axis_count, [&](std::size_t member, int i) {
      return orders_[i].numbers[strip_[first + member]];
    });
    const Ranks members(strip_.begin() + first, strip_.begin() + end);
    for(std::size_t place = 0; place < members.size(); ++place) // in the order of cells
      strip_[first + place] = members[table.member(place)];
    const Forward_offsets offsets(axis_count);
    Sorted_bucket_finder find(table, offsets, 0);
    for(std::size_t bucket = 0; bucket < table.bucket_count(); ++bucket) {
      scan(first + table.begin(bucket), first + table.end(bucket), unlimited, minimum);
      for(std::size_t i = 0; i < offsets.size(); ++i) {
        const std::size_t other = find(bucket, i);
        if(other != table.bucket_count())
          scan(first + table.begin(bucket), first + table.end(bucket), first + table.begin(other),
               first + table.end(other), minimum);
      }
    }
  }

  // Scans points of the strip, in order along the last axis [L], up to `max_steps` candidates.
  bool scan(std::size_t begin, std::size_t end, std::size_t max_steps, Minimum& minimum) const
  {
    for(std::size_t a = begin; a < end; ++a) {
      const std::size_t q = positions_[strip_[a]];
      for(std::size_t b = a + 1; b < end; ++b) {
        const std::size_t p = positions_[strip_[b]];
        if(minimum.is_beyond(p, q, dimension_ - 1))
          break;
        if(max_steps-- == 0)
          return false;
        minimum.offer(q, p);
      }
    }
    return true;
  }

  // Scans the points of two cells of the strip against each other.
  void scan(std::size_t begin, std::size_t end, std::size_t other_begin, std::size_t other_end,
            Minimum& minimum) const
  {
    const int axis = dimension_ - 1;
    for(std::size_t a = begin; a < end; ++a) {
      const std::size_t q = positions_[strip_[a]];
      // Invariant: points before `other_begin` are below all points from a on, and beyond d.
      for(; other_begin < other_end; ++other_begin) {
        const std::size_t p = positions_[strip_[other_begin]];
        if(!(minimum.less(p, q, axis) && minimum.is_beyond(p, q, axis)))
          break;
      }
      for(std::size_t b = other_begin; b < other_end; ++b) {
        const std::size_t p = positions_[strip_[b]];
        if(minimum.is_beyond(p, q, axis))
          break;
        minimum.offer(q, p);
      }
    }
  }

  static constexpr std::size_t unlimited = static_cast<std::size_t>(-1);

  std::vector<std::size_t> positions_; // by rank
  int dimension_;
  const Threads threads_;
  Axis_orders orders_;
  Ranks strip_; // each thread uses the places of its ranks
};

// Offers the closest pairs of the first `size` points to `minimum`.
template <class Minimum, class Progress>
void divide_and_conquer(std::size_t size, int dimension, const Threads& threads, Minimum& minimum,
                        Progress& progress)
{
  std::vector<std::size_t> positions(size);
  std::iota(positions.begin(), positions.end(), 0);
  Closest_pair_divide<Minimum>(std::move(positions), dimension, threads)
    .search(minimum, progress);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CLOSEST_PAIR_DIVIDE_H
