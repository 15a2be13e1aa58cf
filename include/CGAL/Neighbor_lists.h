// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_NEIGHBOR_LISTS_H
#define CGAL_NEIGHBOR_LISTS_H

// The neighbors of all points of a range, in compressed rows.

#include <CGAL/Thick_intersection_d/internal/arrays/Plain_array.h>

#include <boost/iterator/iterator_facade.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

holds a list of neighbors for each point of a range, as positions in ascending order. The neighbors
are points of the same range, or of a second one.

The lists do not refer to the points. They are stored one after another, in \f$ 8 (n + 1) \f$ bytes
for \f$ n \f$ points, and the size of a position for each neighbor. Where lists begin is of the type
`std::size_t`, with 64 bits on common machines. So only the memory limits how many neighbors there
are in all. Several threads may read the lists at once.

\tparam Position_ is an unsigned integer: `std::uint32_t` in `Neighbor_lists`, `std::uint64_t` in
`Distributed_neighbor_lists`.
*/
template <class Position_>
class Basic_neighbor_lists
{
public:
  /// the position of a point.
  using Position = Position_;
  /// a range of positions with random access.
  using Neighbors = boost::iterator_range<const Position*>;

#ifdef DOXYGEN_RUNNING
  /// iterates over the lists, from point to point. It has random access, and makes `Neighbors`. It
  /// stays valid if the lists are moved.
  using const_iterator = unspecified_type;

  /// the places where lists begin: a contiguous range of `std::size_t` with `data()`, `size()` and
  /// random access, which converts to a `std::vector`.
  using Begins = unspecified_type;

  /// the neighbors of all points: such a range of `Position`.
  using Positions = unspecified_type;
#else
  using Begins = Thick_intersection_d::internal::Plain_array<std::size_t>;
  using Positions = Thick_intersection_d::internal::Plain_array<Position>;

  class const_iterator
    : public boost::iterator_facade<const_iterator, const Neighbors,
                                    std::random_access_iterator_tag, const Neighbors>
  {
  public:
    const_iterator() = default;
    Neighbors operator[](std::ptrdiff_t n) const { return *(*this + n); }

  private:
    friend class boost::iterator_core_access;
    friend Basic_neighbor_lists;
    const_iterator(const std::size_t* begin, const Position* positions)
      : begin_(begin), positions_(positions)
    {}

    Neighbors dereference() const { return {positions_ + begin_[0], positions_ + begin_[1]}; }
    bool equal(const const_iterator& other) const { return begin_ == other.begin_; }
    void increment() { ++begin_; }
    void decrement() { --begin_; }
    void advance(std::ptrdiff_t n) { begin_ += n; }
    std::ptrdiff_t distance_to(const const_iterator& other) const { return other.begin_ - begin_; }

    const std::size_t* begin_ = nullptr;
    const Position* positions_ = nullptr;
  };
#endif

  /// constructs the lists of no points.
  Basic_neighbor_lists() : begins_(std::vector<std::size_t>(1, 0)) {}

  /// constructs lists from compressed rows: the neighbors of point `i` are `positions[begins[i]]`
  /// up to but excluding `positions[begins[i + 1]]`. If the neighbors are points of the same range,
  /// each pair is in two lists. \pre `begins` is ascending, begins with 0 and ends with the size of
  /// `positions`.
  Basic_neighbor_lists(std::vector<std::size_t> begins, std::vector<Position> positions,
                       bool are_of_one_range = true)
    : begins_(std::move(begins)), positions_(std::move(positions)),
      are_of_one_range_(are_of_one_range)
  {}

#ifndef DOXYGEN_RUNNING
  Basic_neighbor_lists(Begins begins, Positions positions, bool are_of_one_range)
    : begins_(std::move(begins)), positions_(std::move(positions)),
      are_of_one_range_(are_of_one_range)
  {}
#endif

  /// returns the number of points that have a list.
  std::size_t size() const { return begins_.empty() ? 0 : begins_.size() - 1; } // if moved from

  /// returns the neighbors of the point at position `i`, in ascending order.
  Neighbors operator[](std::size_t i) const
  {
    return {positions_.data() + begins_[i], positions_.data() + begins_[i + 1]};
  }

  /// returns an iterator to the list of the first point.
  const_iterator begin() const { return {begins_.data(), positions_.data()}; }

  /// returns the end of the lists.
  const_iterator end() const { return begin() + static_cast<std::ptrdiff_t>(size()); }

  /// returns the number of pairs of neighbors, each counted once. Of lists of several processes, it
  /// is the number of neighbors: the other list of a pair may be on another process.
  std::size_t number_of_pairs() const { return positions_.size() / (are_of_one_range_ ? 2 : 1); }

  /// returns where the neighbors of each point begin in `positions()`. The last value is where the
  /// neighbors of the last point end.
  const Begins& begins() const& { return begins_; }

  /// moves the array out: `std::move(lists).begins()`. The lists can then only be replaced or
  /// destroyed, and the other array be moved out.
  Begins begins() && { return std::move(begins_); }

  /// returns the neighbors of all points, one list after another.
  const Positions& positions() const& { return positions_; }

  /// moves the array out: `std::move(lists).positions()`. The lists can then only be replaced or
  /// destroyed, and the other array be moved out. A `std::vector` is a copy of it, unless the lists
  /// were constructed from one.
  Positions positions() && { return std::move(positions_); }

  /// returns whether `a` and `b` hold the same lists.
  friend bool operator==(const Basic_neighbor_lists& a, const Basic_neighbor_lists& b)
  {
    return a.begins_ == b.begins_ && a.positions_ == b.positions_;
  }

private:
  Begins begins_;
  Positions positions_;
  bool are_of_one_range_ = true;
};

/*!
\ingroup PkgThickIntersectionDRef

holds the lists that `fixed_radius_neighbor_lists()` makes. Positions have 32 bits, so ranges have
less than \f$ 2^{32} \f$ points. `neighbor_squared_distances()` computes the distances when they are
wanted.
*/
using Neighbor_lists = Basic_neighbor_lists<std::uint32_t>;

/*!
\ingroup PkgThickIntersectionDRef

holds the lists that `distributed_fixed_radius_neighbor_lists()` makes. The positions are the ids of
points, which may be on other processes.
*/
using Distributed_neighbor_lists = Basic_neighbor_lists<std::uint64_t>;

} // namespace CGAL

#endif // CGAL_NEIGHBOR_LISTS_H
