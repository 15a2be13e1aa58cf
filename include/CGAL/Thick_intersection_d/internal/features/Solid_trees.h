// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H

// Do pieces of two features meet, and is a point inside closed faces? It is if the ray upwards from
// it crosses them an odd number of times.
//
// Each tree halves the pieces of a feature along axes, and has the boxes of the parts. Pieces meet,
// and a ray crosses faces, only in parts whose boxes do.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/features/does_ray_cross_face.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// An `Object` is a segment or a triangle, or a variant of both, with a radius or without. `Box` is
// like Space_box: a test counts how often boxes are compared.
template <class Object, class Box = Space_box>
class Solid_trees
{
public:
  // Takes memory for so many pieces.
  void reserve(std::size_t count) { pieces_.reserve(count); }

  Place size() const { return static_cast<Place>(pieces_.size()); }
  const Object& piece(std::size_t position) const { return pieces_[position].piece; }

  void add_piece(const Object& piece, const Box& box) { pieces_.push_back({box, piece}); }

  // Makes a tree of the pieces from this one on, and puts them into its order.
  Halved_range add_tree(Place first)
  {
    const Halved_range tree = {static_cast<Place>(nodes_.size()), first, size()};
    if(tree.last - tree.first >= sorted_size)
      sort(tree);
    add_nodes(tree);
    return tree;
  }

  // Takes the pieces from this one on away.
  void remove_pieces(Place first) { pieces_.erase(pieces_.begin() + first, pieces_.end()); }

  // Prefetches the pieces that is_any_pair() is likely to read first.
  void prefetch(const Halved_range& tree) const
  {
    prefetch_to_read(&nodes_[tree.node]);
    const Place last = (std::min)(tree.last, tree.first + Halved_range::leaf_size);
    for(Place piece = tree.first; piece != last; ++piece) {
      prefetch_to_read(&pieces_[piece]);
      prefetch_to_read(&pieces_[piece], 1);
    }
  }

  // Whether test(i, j) holds for a piece of each of two trees, among those whose boxes meet.
  template <class Test>
  bool is_any_pair(const Halved_range& a, const Halved_range& b, const Test& test) const
  {
    Place steps = a.last - a.first + b.last - b.first;
    return is_any_pair(a, b, test, steps);
  }

  // Whether test(i) holds for a piece of a tree, among those whose boxes meet a box.
  template <class Test>
  bool is_any_in_box(const Halved_range& tree, const Box& box, const Test& test) const
  {
    if(!do_boxes_meet(nodes_[tree.node], box))
      return false;
    if(!tree.is_leaf())
      return is_any_in_box(tree.first_half(), box, test)
             || is_any_in_box(tree.second_half(), box, test);
    for(Place piece = tree.first; piece != tree.last; ++piece)
      if(do_boxes_meet(pieces_[piece].box, box) && test(piece))
        return true;
    return false;
  }

  // Whether the first vertex of a piece is inside a tree of closed faces. It is not on them.
  template <class Source>
  bool is_inside(const Source& source, const Halved_range& faces) const
  {
    if(!may_ray_meet(source, nodes_[faces.node]))
      return false;
    if(!faces.is_leaf())
      return is_inside(source, faces.first_half()) != is_inside(source, faces.second_half());
    return std::count_if(pieces_.begin() + faces.first, pieces_.begin() + faces.last,
                         [&](const Boxed_piece& face) {
                           return may_ray_meet(source, face.box)
                                  && does_ray_cross_face(source, face.piece);
                         })
             % 2 != 0;
  }

private:
  // Fewer pieces are left as they come. To sort them takes longer than what a sorted tree saves, as
  // most meshes have neighbors near each other.
  static constexpr Place sorted_size = 256;

  using Leaf_pieces = std::array<Place, Halved_range::leaf_size>;

  struct Boxed_piece
  {
    Box box;
    Object piece;
  };

  // The pieces of two trees, as the box route reads them.
  template <class Test>
  struct Pieces_of_two : Objects_in_boxes<3>
  {
    Pieces_of_two(const Solid_trees& trees, const Halved_range& a, const Halved_range& b,
                  const Test& test)
      : trees_(trees), a_(a), b_(b), test_(test)
    {}

    std::size_t size() const { return a_.last - a_.first + b_.last - b_.first; }
    auto intervals(std::size_t position) const
    {
      return [&box = trees_.pieces_[place(position)].box](int axis) {
        return box[static_cast<std::size_t>(axis)];
      };
    }
    bool do_intersect(std::size_t i, std::size_t j) const { return test_(place(i), place(j)); }

  private:
    Place place(std::size_t position) const
    {
      const Place i = static_cast<Place>(position), size = a_.last - a_.first;
      return i < size ? a_.first + i : b_.first + (i - size);
    }

    const Solid_trees& trees_;
    const Halved_range a_, b_;
    const Test& test_;
  };

  // Where a piece is, for sorting.
  struct Centered_piece
  {
    std::array<double, 3> center;
    Place piece;
  };

  void sort(const Halved_range& tree)
  {
    std::vector<Centered_piece> centers;
    centers.reserve(tree.last - tree.first);
    for(Place piece = tree.first; piece != tree.last; ++piece) {
      const Box& box = pieces_[piece].box;
      const auto center = [&](std::size_t axis) {
        const auto ends = finite_interval({box[axis].low, box[axis].high}); // else perhaps NaN
        return ends.first / 2 + ends.second / 2;
      };
      centers.push_back({{center(0), center(1), center(2)}, piece});
    }
    sort_by_halves(centers.data(), {0, 0, tree.last - tree.first});
    std::vector<Boxed_piece> sorted;
    sorted.reserve(centers.size());
    for(const Centered_piece& center : centers)
      sorted.push_back(std::move(pieces_[center.piece]));
    std::move(sorted.begin(), sorted.end(), pieces_.begin() + tree.first);
  }

  // Halves the range along the axis along which the centers are farthest apart, and so on.
  static void sort_by_halves(Centered_piece* centers, const Halved_range& range)
  {
    if(range.is_leaf())
      return;
    Space_box box;
    for(Place i = range.first; i != range.last; ++i)
      for(std::size_t axis = 0; axis < 3; ++axis)
        box[axis].add(centers[i].center[axis]);
    const auto longest = std::max_element(box.begin(), box.end(), [](const auto& a, const auto& b) {
      return a.half_length() < b.half_length();
    });
    const std::size_t axis = static_cast<std::size_t>(longest - box.begin());
    std::nth_element(centers + range.first, centers + range.middle(), centers + range.last,
                     [=](const Centered_piece& a, const Centered_piece& b) {
                       return a.center[axis] < b.center[axis];
                     });
    sort_by_halves(centers, range.first_half());
    sort_by_halves(centers, range.second_half());
  }

  void add_nodes(const Halved_range& range)
  {
    nodes_.emplace_back();
    Box box;
    if(range.is_leaf())
      for(Place piece = range.first; piece != range.last; ++piece)
        box.add_box(pieces_[piece].box);
    else
      for(const Halved_range& half : {range.first_half(), range.second_half()}) {
        add_nodes(half);
        box.add_box(nodes_[half.node]);
      }
    nodes_[range.node] = box;
  }

  // The same in so many steps. Where pieces are long, most boxes of subtrees may meet, but those of
  // no pieces. So the subtrees that are left after the steps take the box route: there are a few of
  // each size, so that the pieces of all of them are a few times those of both trees. Halves the
  // larger box first: that of a shell around another one may meet it, and none of its halves.
  template <class Test>
  bool is_any_pair(const Halved_range& a, const Halved_range& b, const Test& test,
                   Place& steps) const
  {
    if(!do_boxes_meet(nodes_[a.node], nodes_[b.node]))
      return false;
    if(a.is_leaf() && b.is_leaf())
      return is_any_pair_of_leaves(a, b, test);
    const auto is_leaf_elsewhere = [&](const Halved_range& leaf, const Box& box) {
      return leaf.is_leaf()
             && std::none_of(pieces_.begin() + leaf.first, pieces_.begin() + leaf.last,
                             [&](const Boxed_piece& p) { return do_boxes_meet(p.box, box); });
    };
    if(is_leaf_elsewhere(a, nodes_[b.node]) || is_leaf_elsewhere(b, nodes_[a.node]))
      return false;
    if(steps == 0)
      return is_any_pair_by_boxes(a, b, test);
    --steps;
    if(b.is_leaf() || (!a.is_leaf() && extent(nodes_[a.node]) >= extent(nodes_[b.node])))
      return is_any_pair(a.first_half(), b, test, steps)
             || is_any_pair(a.second_half(), b, test, steps);
    return is_any_pair(a, b.first_half(), test, steps)
           || is_any_pair(a, b.second_half(), test, steps);
  }

  template <class Test>
  bool is_any_pair_by_boxes(const Halved_range& a, const Halved_range& b, const Test& test) const
  {
    bool is_found = false;
    const auto stop = [&](std::size_t, std::size_t) {
      is_found = true;
      return false;
    };
    Unwatched_progress progress;
    report_meeting_boxes(Pieces_of_two<Test>(*this, a, b, test), Two_sets{a.last - a.first}, stop,
                         progress, Threads());
    return is_found;
  }

  // Pieces that follow each other are alike: if two do not meet, their neighbors may not either. So
  // each step takes another piece of both, in opposite orders, as meshes may have one pattern.
  template <class Test>
  bool is_any_pair_of_leaves(const Halved_range& a, const Halved_range& b, const Test& test) const
  {
    Leaf_pieces of_a, of_b;
    const std::size_t a_count = find_near(a, nodes_[b.node], of_a);
    const std::size_t b_count = find_near(b, nodes_[a.node], of_b);
    for(std::size_t first = 0; first != b_count; ++first) {
      std::size_t k = first;
      for(std::size_t i = 0; i != a_count; ++i) {
        if(do_boxes_meet(pieces_[of_a[i]].box, pieces_[of_b[k]].box) && test(of_a[i], of_b[k]))
          return true;
        k = (k == 0 ? b_count : k) - 1;
      }
    }
    return false;
  }

  // Puts the pieces of a leaf whose boxes meet a box. Returns how many they are.
  std::size_t find_near(const Halved_range& leaf, const Box& box, Leaf_pieces& near) const
  {
    std::size_t count = 0;
    for(Place piece = leaf.first; piece != leaf.last; ++piece)
      if(do_boxes_meet(pieces_[piece].box, box))
        near[count++] = piece;
    return count;
  }

  std::vector<Boxed_piece> pieces_;
  std::vector<Box> nodes_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_TREES_H
