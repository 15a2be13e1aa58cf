// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PARTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PARTS_H

// The parts of a feature in space, which may be inside others: sets of its pieces that common
// vertices connect. Pieces that are elsewhere may be missing. Their neighbors have vertices there,
// so they are in no part that is inside.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/Mesh_shape.h>
#include <CGAL/Thick_intersection_d/internal/features/Solid_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Adds the vertices of a piece to the ends of an interval along each axis, which all of them may be
// in: the least upper bound, and the greatest lower bound. These may be in reverse order.
template <class Object>
void add_ends(const Object& piece, Space_box& ends)
{
  with_points_of(piece, [&](const auto& points) {
    for(int v = 0; v < Vertex_count<std::decay_t<decltype(points)>>::value; ++v)
      for(int axis = 0; axis < 3; ++axis) {
        const auto x = vertex_bounds(points, v, axis);
        ends[static_cast<std::size_t>(axis)].add({x.second, x.first});
      }
  });
}

// Whether all vertices may be in a box.
inline bool are_ends_in(const Space_box& ends, const Space_box& box)
{
  for(std::size_t axis = 0; axis < 3; ++axis)
    if(ends[axis].low < box[axis].low || box[axis].high < ends[axis].high)
      return false;
  return true;
}

template <class Object>
bool is_within(const Object& piece, const Space_box& box)
{
  Space_box ends;
  add_ends(piece, ends);
  return are_ends_in(ends, box);
}

class Solid_parts
{
public:
  // Reads some of Solid_pieces.
  template <class Pieces>
  Solid_parts(const Pieces& pieces, const std::vector<Place>& places)
  {
    const auto piece_at = [&](std::size_t k) -> const auto& { return pieces.thick(places[k]); };
    const std::vector<Place> numbers = Mesh_shape(places.size(), piece_at).part_numbers();
    std::vector<Part> parts;
    for(std::size_t k = 0; k < numbers.size(); ++k) {
      if(numbers[k] == parts.size())
        parts.push_back({places[k], {}});
      add_ends(piece_at(k), parts[numbers[k]].ends);
    }
    for(const Part& part : parts) {
      Space_box box;
      for(std::size_t axis = 0; axis < 3; ++axis)
        for(const double end : {part.ends[axis].low, part.ends[axis].high})
          box[axis].add(end);
      trees_.add_piece(part, box);
    }
    tree_ = trees_.add_tree(0);
  }

  // Whether is_inside(i) holds for a piece of each part of which all vertices may be in a box.
  template <class Is_inside>
  bool is_any_inside(const Space_box& box, const Is_inside& is_inside) const
  {
    return trees_.is_any_in_box(tree_, box, [&](Place i) {
      const Part& part = trees_.piece(i);
      return are_ends_in(part.ends, box) && is_inside(part.piece);
    });
  }

private:
  struct Part
  {
    Place piece; // one of them
    Space_box ends;
  };

  Solid_trees<Part> trees_;
  Halved_range tree_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PARTS_H
