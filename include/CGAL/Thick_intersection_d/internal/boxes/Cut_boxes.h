// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_CUT_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_CUT_BOXES_H

// Cuts boxes into pieces along an axis. A box goes to each piece that it meets.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Equal_cut.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Two boxes that meet have a common piece: the one where the later of them begins. There, and in no
// other piece, one of them is no copy along the axis of the cut. So the pair is reported once.
//
// If the boxes are themselves in a piece of an earlier cut along the same axis, copies begin before
// it, that is, in the first piece, and they remain copies there.
template <class ConcurrencyTag, class Box>
class Cut_boxes
{
public:
  // Counts the boxes of each piece, and of each set in it.
  Cut_boxes(const Piece<Box>& boxes, int axis, const Equal_cut& cut)
    : boxes_(boxes), axis_(axis), cut_(cut),
      blocks_(boxes.size() < min_size_for_threads ? 1 : block_count<ConcurrencyTag>()),
      next_(boxes.set_count() * cut.count() * blocks_, 0), begins_(next_.size() / blocks_ + 1)
  {
    for_each_box([&](Place* next, const Box& box) {
      const Place last = cut_(box.high[axis_]);
      for(Place piece = cut_(box.low[axis_]); piece <= last; ++piece)
        ++next[piece];
    });
    auto begin = begins_.begin();
    for(std::size_t set = 0; set < boxes.set_count(); ++set)
      for(Place piece = 0; piece < cut.count(); ++piece) {
        *begin++ = size_;
        for(std::size_t block = 0; block < blocks_; ++block)
          size_ += std::exchange(next_of(set, block)[piece], static_cast<Place>(size_));
      }
    *begin = size_;
  }

  // The number of boxes in all pieces.
  std::uint64_t size() const { return size_; }

  // Copies the boxes into the pieces. Boxes are to be fewer than places.
  void distribute()
  {
    copies_ = make_uninitialized<Box>(size_);
    for_each_box([&](Place* next, const Box& box) {
      const Place first = cut_(box.low[axis_]);
      const Place last = cut_(box.high[axis_]);
      copies_[next[first]++] = box;
      for(Place piece = first + 1; piece <= last; ++piece) {
        Box& copy = copies_[next[piece]++];
        copy = box;
        copy.sides |= Place(1) << axis_;
      }
    });
  }

  Piece<Box> piece(Place piece) const
  {
    return boxes_.set_count() == 1 ? Piece<Box>(span(piece))
                                   : Piece<Box>(span(piece), span(cut_.count() + piece));
  }

private:
  static constexpr Place min_size_for_threads = 1 << 14;

  Span<Box> span(std::size_t i) const
  {
    return {copies_.get() + begins_[i], copies_.get() + begins_[i + 1]};
  }

  // Where the next box of each piece goes.
  Place* next_of(std::size_t set, std::size_t block)
  {
    return next_.data() + (set * blocks_ + block) * cut_.count();
  }

  // Calls task(next, box).
  template <class Task>
  void for_each_box(const Task& task)
  {
    for(std::size_t set = 0; set < boxes_.set_count(); ++set)
      for_each_numbered_block<ConcurrencyTag>(
        blocks_, boxes_[set].size(), [&](std::size_t block, std::size_t i, std::size_t last) {
          for(Place* const next = next_of(set, block); i != last; ++i)
            task(next, boxes_[set].first[i]);
        });
  }

  const Piece<Box> boxes_;
  const int axis_;
  const Equal_cut cut_;
  const std::size_t blocks_;
  std::vector<Place> next_; // for each set, block and piece
  std::vector<std::uint64_t> begins_; // for each set and piece
  std::uint64_t size_ = 0;
  std::unique_ptr<Box[]> copies_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_CUT_BOXES_H
