// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_NEIGHBOR_LISTS_H
#define CGAL_NEIGHBOR_LISTS_H

// The neighbors of all points of a range, in compressed rows.

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

holds a list of neighbors for each point of a range, as positions in the range, in ascending order.

`fixed_radius_neighbor_lists()` makes the lists. They do not refer to the points. The lists are
stored one after another, in \f$ 8 (n + 1) \f$ bytes for \f$ n \f$ points and 4 bytes for each
neighbor. Several threads may read them at once.
*/
class Neighbor_lists
{
public:
  /// the position of a point.
  using Position = std::uint32_t;
  /// a range of positions with random access.
  using Neighbors = boost::iterator_range<const Position*>;

  /// constructs the lists of no points.
  Neighbor_lists() : begins_(1, 0) {}

  /// constructs lists from compressed rows: the neighbors of point `i` are `positions[begins[i]]`
  /// up to but excluding `positions[begins[i + 1]]`. \pre `begins` is ascending, begins with 0 and
  /// ends with the size of `positions`.
  Neighbor_lists(std::vector<std::size_t> begins, std::vector<Position> positions)
    : begins_(std::move(begins)), positions_(std::move(positions))
  {}

  /// returns the number of points.
  std::size_t size() const { return begins_.size() - 1; }

  /// returns the neighbors of the point at position `i`, in ascending order.
  Neighbors operator[](std::size_t i) const
  {
    return {positions_.data() + begins_[i], positions_.data() + begins_[i + 1]};
  }

  /// returns the number of pairs of neighbors, each counted once.
  std::size_t number_of_pairs() const { return positions_.size() / 2; }

  /// returns where the neighbors of each point begin in `positions()`. The last value is where the
  /// neighbors of the last point end.
  const std::vector<std::size_t>& begins() const { return begins_; }

  /// returns the neighbors of all points, one list after another.
  const std::vector<Position>& positions() const { return positions_; }

  /// returns whether `a` and `b` hold the same lists.
  friend bool operator==(const Neighbor_lists& a, const Neighbor_lists& b)
  {
    return a.begins_ == b.begins_ && a.positions_ == b.positions_;
  }

private:
  std::vector<std::size_t> begins_;
  std::vector<Position> positions_;
};

} // namespace CGAL

#endif // CGAL_NEIGHBOR_LISTS_H
