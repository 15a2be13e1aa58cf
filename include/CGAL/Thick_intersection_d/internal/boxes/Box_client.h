// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLIENT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLIENT_H

// What a search by boxes is told and asks: doubles and positions. The search knows no type of the
// user. It reads boxes, and gives pairs of boxes that meet, in blocks.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The objects of a search, each in a box with `Axes` axes. Several threads may call the functions
// at once. Those that take pairs return false to stop.
template <int Axes>
class Box_client
{
public:
  std::size_t size = 0;
  Place first_size = max_place; // of the first of two sets, which has the first positions
  bool are_decided = false;     // whether objects are a pair iff their boxes meet
  bool have_groups = false;     // whether pairs of groups are looked for; then are_decided is false

  bool are_two_sets() const { return first_size != max_place; }

  // Makes the boxes of the objects at the positions [first, last).
  virtual void read(std::size_t first, std::size_t last, Piece_box<Axes>* boxes) const = 0;

  // Takes up to about a thousand pairs of a box of run `a` and a box of run `b` that meet. They are
  // places in the runs, and may be changed. Adds the number of wanted pairs to `wanted_count`.
  virtual bool take(const Box_run<Axes>& a, const Box_run<Axes>& b, Found_pair* pairs, Place count,
                    std::uint64_t& wanted_count) = 0;

  // Takes the pairs of a position and `lanes` others. Not called if boxes do not decide.
  virtual bool take_row(Place i, const Place* others) = 0;

  // Takes two positions whose boxes meet.
  virtual bool take_pair(Place i, Place j) = 0;

  // The group of an object. Most pairs of objects in groups may be of no use: those within a group,
  // and those of two groups that are known to be a pair.
  virtual std::size_t group_of(Place position) const = 0;

  // Whether a pair of these objects would tell a pair of groups that is not known. This depends on
  // the groups alone. Two groups are no longer wanted when two of their objects have been a pair.
  virtual bool is_wanted(Place i, Place j) const = 0;

  // Counts boxes as finished.
  virtual bool advance(std::size_t finished) = 0;

protected:
  ~Box_client() = default;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLIENT_H
