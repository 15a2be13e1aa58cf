// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CUT_TREE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CUT_TREE_H

// Which part has a point, by cuts of space.

#include <cstddef>
#include <cstdint>
#include <limits>
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

  // Points with the same coordinate are cut by their ids.
  struct Border
  {
    double value;
    std::uint64_t id;

    bool is_above(double x, std::uint64_t i) const { return x < value || (x == value && i < id); }
  };

  // Divides parts into two groups: one is between two borders, and the other one around it. Without
  // borders, all points go to the first group, which has the lower parts.
  struct Cut
  {
    int place = 0;
    int axis = 0;
    bool is_first_inside = true;
    Border low = {-std::numeric_limits<double>::infinity(), 0};
    Border high = {std::numeric_limits<double>::infinity(), ~std::uint64_t(0)};

    bool has_two_borders() const
    {
      return low.value > -std::numeric_limits<double>::infinity()
             && high.value < std::numeric_limits<double>::infinity();
    }
  };

  // Returns where a point is. `x[axis]` is a double that stands for its coordinate, always the same
  // one.
  template <class Coordinates>
  Part_place find(const Coordinates& x, std::uint64_t id) const
  {
    int part = 0, part_count = static_cast<int>(cuts_.size()) + 1;
    std::size_t box = 1;
    while(part_count > 1) {
      const int first_count = part_count / 2;
      const Cut& cut = cuts_[static_cast<std::size_t>(place_of_cut(part, part_count))];
      const double value = x[static_cast<std::size_t>(cut.axis)];
      const bool is_below = cut.low.is_above(value, id);
      const bool is_inside = !is_below && cut.high.is_above(value, id);
      if(!is_inside && box < max_boxes / 2 && cut.has_two_borders())
        box = 2 * box + is_below;
      const bool is_in_first = is_inside == cut.is_first_inside;
      part += is_in_first ? 0 : first_count;
      part_count = is_in_first ? first_count : part_count - first_count;
    }
    return {part, box};
  }

  template <class Coordinates>
  int owner(const Coordinates& x, std::uint64_t id) const
  {
    return find(x, id).part;
  }

  void add(const std::vector<Cut>& cuts)
  {
    for(const Cut& cut : cuts)
      cuts_[static_cast<std::size_t>(cut.place)] = cut;
  }

protected:
  explicit Cut_tree(int part_count) : cuts_(static_cast<std::size_t>(part_count - 1)) {}

  // The place of the cut that divides parts [part, part + part_count), the same on all processes.
  static int place_of_cut(int part, int part_count) { return part + part_count / 2 - 1; }

private:
  std::vector<Cut> cuts_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CUT_TREE_H
