// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_PERIODIC_NEIGHBOR_LISTS_H
#define CGAL_PERIODIC_NEIGHBOR_LISTS_H

#include <CGAL/Neighbor_lists.h>

#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

holds a list of neighbors for each point of a range in a periodic domain, with the offset that moves
each neighbor near the point.

A neighbor is as often in a list as images of it are near, and so is the point itself. The lists are
sorted by positions, and images of one point by their offsets. They take \f$ 8 (n + 1) + (4 + 4d) k
\f$ bytes for \f$ n \f$ points with \f$ k \f$ neighbors in all. Several threads may read them at
once.

\tparam Dimension is 2 or 3.
*/
template <int Dimension>
class Periodic_neighbor_lists
{
public:
  /// how many times each period is added to a neighbor.
  using Offset = std::array<int, static_cast<std::size_t>(Dimension)>;

  /// a range of offsets.
  using Offsets = boost::iterator_range<const Offset*>;

  /// makes no list.
  Periodic_neighbor_lists() = default;

#ifndef DOXYGEN_RUNNING
  Periodic_neighbor_lists(Neighbor_lists lists, std::vector<Offset> offsets)
    : lists_(std::move(lists)), offsets_(std::move(offsets))
  {}
#endif

  /// returns the number of lists.
  std::size_t size() const { return lists_.size(); }

  /// returns the positions of the neighbors of point `i`.
  Neighbor_lists::Neighbors operator[](std::size_t i) const { return lists_[i]; }

  /// returns the offsets of the neighbors of point `i`, in the order of their positions.
  Offsets offsets_of(std::size_t i) const
  {
    return {offsets_.data() + lists_.begins()[i], offsets_.data() + lists_.begins()[i + 1]};
  }

  /// returns the lists without offsets.
  const Neighbor_lists& lists() const { return lists_; }

  /// returns the offsets of all neighbors, in the order of `lists().positions()`.
  const std::vector<Offset>& offsets() const { return offsets_; }

  /// returns the number of pairs of images: half of the neighbors, or all if there are two ranges.
  std::size_t number_of_pairs() const { return lists_.number_of_pairs(); }

  /// returns whether both hold the same lists with the same offsets.
  friend bool operator==(const Periodic_neighbor_lists& a, const Periodic_neighbor_lists& b)
  {
    return a.lists_ == b.lists_ && a.offsets_ == b.offsets_;
  }

private:
  Neighbor_lists lists_;
  std::vector<Offset> offsets_;
};

} // namespace CGAL

#endif // CGAL_PERIODIC_NEIGHBOR_LISTS_H
