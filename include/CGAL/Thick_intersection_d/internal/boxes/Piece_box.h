// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_PIECE_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_PIECE_BOX_H

// Boxes of doubles, as the box route moves them.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A closed box that encloses an object of the user.
template <int Axes>
struct Piece_box
{
  static constexpr int axes = Axes;

  std::array<double, Axes> low;
  std::array<double, Axes> high;
  Place position;

  // Bit i is set if the box is a copy along axis i: it begins in an earlier piece of a cut along
  // this axis. Two boxes that are copies along the same axis have met in an earlier piece.
  Place sides;
};

// The lower ends of boxes are ordered by coordinate and position, so no two of them are equal. Two
// boxes meet along an axis iff one of them holds the lower end of the other one: it begins before
// the other one begins, and does not end before.
template <class Box>
bool begins_before(const Box* a, const Box* b, int axis)
{
  const double x = a->low[axis];
  const double y = b->low[axis];
  return x < y || (x == y && a->position < b->position);
}

// Returns the boxes of [first, last), sorted along an axis, whose lower ends a box holds. They are
// consecutive.
template <class Box, class Iterator>
std::pair<Iterator, Iterator> boxes_held_by(const Box* box, Iterator first, Iterator last, int axis)
{
  first = std::upper_bound(first, last, box, [&](const Box* a, const Box* b) {
    return begins_before(a, b, axis);
  });
  return {first, std::partition_point(first, last, [&](const Box* b) {
            return b->low[axis] <= box->high[axis];
          })};
}

// Consecutive boxes of one set.
template <class Box>
struct Span
{
  Box* first;
  Box* last;

  Place size() const { return static_cast<Place>(last - first); }
};

// The boxes of one set, or of each of two sets, in a part of space.
template <class Box>
class Piece
{
public:
  explicit Piece(const Span<Box>& set) : sets_{set, {set.last, set.last}}, set_count_(1) {}
  Piece(const Span<Box>& first, const Span<Box>& second) : sets_{first, second}, set_count_(2) {}

  std::size_t set_count() const { return set_count_; }
  const Span<Box>& operator[](std::size_t set) const { return sets_[set]; }
  const Span<Box>* begin() const { return sets_.data(); }
  const Span<Box>* end() const { return sets_.data() + set_count_; }
  Place size() const { return sets_[0].size() + sets_[1].size(); }

  // Whether there may be a pair.
  bool has_pairs() const
  {
    return set_count_ == 1 ? size() > 1 : sets_[0].size() > 0 && sets_[1].size() > 0;
  }

private:
  std::array<Span<Box>, 2> sets_;
  std::size_t set_count_;
};

// Puts the boxes of each class next to each other. Returns the classes that have any boxes. A box
// is long along an axis if it is longer than `lengths`.
template <class Box>
std::vector<Span<Box>> divide_into_classes(const Span<Box>& boxes,
                                           const std::array<double, Box::axes>& lengths)
{
  std::vector<Span<Box>> classes(1, boxes);
  for(int axis = 0; axis < Box::axes; ++axis) {
    std::vector<Span<Box>> parts;
    for(const Span<Box>& span : classes) {
      Box* const first_long = std::partition(span.first, span.last, [&](const Box& box) {
        return !(box.high[axis] - box.low[axis] > lengths[axis]);
      });
      for(const Span<Box>& part : {Span<Box>{span.first, first_long}, {first_long, span.last}})
        if(part.size() != 0)
          parts.push_back(part);
    }
    classes.swap(parts);
  }
  return classes;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_PIECE_BOX_H
