// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_AXIS_ORDERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_AXIS_ORDERS_H

// The orders of points along the axes. A divide and conquer divides the orders, and merges them
// again.

#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

using Rank = std::size_t; // the rank of a point in the lexicographic order
using Ranks = std::vector<Rank>;

// The points in order along an axis. When the recursion is at the ranks [first, last), these ranks
// are at the places [first, last).
struct Axis_order
{
  int axis;
  Ranks ranks;
  Ranks places;                     // the place of each rank in the whole order
  std::vector<Cell_number> numbers; // by rank: the number of the strip, for ranks in the strip
};

// The orders along all axes except the first. Along the first axis, the ranks are in order.
class Axis_orders
{
public:
  // Sorts `size` ranks. less(a, b, axis) compares the points of two ranks. On the line, axis 0 is
  // also the last axis.
  template <class Less>
  void sort(std::size_t size, int dimension, const Less& less)
  {
    scratch_.resize(size);
    for(int axis = dimension == 1 ? 0 : 1; axis < dimension; ++axis) {
      orders_.push_back(sorted(size, axis, less));
      if(axis + 1 < dimension)
        orders_.back().numbers.resize(size);
    }
  }

  std::size_t size() const { return orders_.size(); }
  Axis_order& operator[](std::size_t i) { return orders_[i]; }
  const Axis_order& last() const { return orders_.back(); }

  // In each order, moves the ranks [first, middle) in front of the ranks [middle, last). Keeps the
  // order on both sides.
  void divide(Rank first, Rank middle, Rank last)
  {
    for(Axis_order& order : orders_)
      divide(order.ranks, first, middle, last);
  }

  // Undoes divide().
  void merge(Rank first, Rank middle, Rank last)
  {
    for(Axis_order& order : orders_)
      merge(order, first, middle, last);
  }

private:
  template <class Less>
  static Axis_order sorted(std::size_t size, int axis, const Less& less)
  {
    Axis_order order = {axis, Ranks(size), Ranks(size), {}};
    for(Rank rank = 0; rank < size; ++rank)
      order.ranks[rank] = rank;
    std::sort(order.ranks.begin(), order.ranks.end(), [&](Rank a, Rank b) {
      if(less(a, b, axis))
        return true;
      return !less(b, a, axis) && a < b;
    });
    for(std::size_t place = 0; place < size; ++place)
      order.places[order.ranks[place]] = place;
    return order;
  }

  void divide(Ranks& ranks, Rank first, Rank middle, Rank last)
  {
    std::size_t left = first;
    std::size_t right = first;
    for(std::size_t place = first; place != last; ++place) {
      const Rank rank = ranks[place];
      if(rank < middle)
        ranks[left++] = rank;
      else
        scratch_[right++] = rank;
    }
    std::copy(scratch_.begin() + first, scratch_.begin() + right, ranks.begin() + left);
  }

  void merge(Axis_order& order, Rank first, Rank middle, Rank last)
  {
    Ranks& ranks = order.ranks;
    std::copy(ranks.begin() + first, ranks.begin() + middle, scratch_.begin() + first);
    std::merge(scratch_.begin() + first, scratch_.begin() + middle, ranks.begin() + middle,
               ranks.begin() + last, ranks.begin() + first,
               [&](Rank a, Rank b) { return order.places[a] < order.places[b]; });
  }

  std::vector<Axis_order> orders_;
  Ranks scratch_; // each thread uses the places of its ranks
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_AXIS_ORDERS_H
