// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CUT_TREE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CUT_TREE_H

// Parts of space, as a tree of cuts.

#include <CGAL/Thick_intersection_d/internal/parts/Byte_reader.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Every point has one part, whatever the cuts are.
class Cut_tree
{
public:
  // A part, and one of its boxes. A part around another one is in boxes on both sides of it.
  struct Part_place
  {
    int part;
    std::size_t box;
  };
  static constexpr std::size_t max_boxes = 128; // of a part; most have no points

  // Returns where a point is. `x[axis]` is a double that stands for its coordinate, always the same
  // one.
  template <class Coordinates>
  Part_place find(const Coordinates& x, std::uint64_t id) const
  {
    std::size_t box = 1;
    Side place = root_;
    while(!place.is_part) {
      const Cut& cut = cuts_[static_cast<std::size_t>(place.next)];
      const double value = x[static_cast<std::size_t>(cut.axis)];
      const bool is_below = value < cut.value || (value == cut.value && id < cut.id);
      place = is_below ? cut.below : cut.above;
      box = place.is_divided && box < max_boxes / 2 ? 2 * box + !is_below : box;
    }
    return {place.next, box};
  }

  template <class Coordinates>
  int owner(const Coordinates& x, std::uint64_t id) const
  {
    return find(x, id).part;
  }

protected:
  // What is on one side of a cut: a cut, or a part. If it is divided, its other half is above the
  // second cut, or below the first one.
  struct Side
  {
    int next = 0;
    bool is_part = true;
    bool is_divided = false;
  };

  struct Cut
  {
    int axis = 0;
    double value = 0;
    std::uint64_t id = 0;
    Side below, above;
  };

  // At most two cuts divide parts [part, part + part_count) into two groups. On all processes they
  // have the same places.
  static int place_of_cuts(int part, int part_count) { return 2 * (part + part_count / 2 - 1); }

  Cut& cut(int place) { return cuts_[static_cast<std::size_t>(place)]; }

  // There are no cuts yet.
  void reset(int part_count) { cuts_.assign(2 * static_cast<std::size_t>(part_count - 1), Cut()); }
  void set_root(const Side& root) { root_ = root; }

  // Appends the cuts at a place to `bytes`.
  void write_cuts(int place, std::vector<char>& bytes) const
  {
    write_bytes(&place, 1, bytes);
    write_bytes(&cuts_[static_cast<std::size_t>(place)], 2, bytes);
  }

  void read_cuts(const std::vector<char>& bytes)
  {
    for(Byte_reader reader(bytes); !reader.is_at_end();) {
      int place;
      reader.read(&place, 1);
      reader.read(&cut(place), 2);
    }
  }

private:
  std::vector<Cut> cuts_;
  Side root_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CUT_TREE_H
