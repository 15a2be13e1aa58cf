// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_CUT_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_CUT_BOXES_H

// Cuts boxes into pieces along an axis. A box goes to each piece that it meets.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Two boxes that meet have a common piece: the one where the later of them begins. There, and in no
// other piece, one of them is no copy along the axis of the cut. So the pair is reported once.
//
// If the boxes are themselves in a piece of an earlier cut along the same axis, copies begin before
// it, that is, in the first piece, and they remain copies there.
template <class Box>
class Cut_boxes
{
public:
  // Counts the boxes of each piece, and of each set in it.
  Cut_boxes(const Piece<Box>& boxes, int axis, const Equal_cut& cut, const Threads& threads)
    : boxes_(boxes), axis_(axis), cut_(cut), threads_(threads),
      blocks_(boxes.size() < min_size_for_threads ? 1 : threads.block_count()),
      next_(make_uninitialized<Place>(boxes.set_count() * cut.count() * blocks_)),
      begins_(boxes.set_count() * cut.count() + std::size_t(1), 0)
  {
    for_each_block_of_boxes([&](std::size_t, Place* next, const Box* box, const Box* end) {
      const Equal_cut piece_of = cut_; // a copy, which stays in registers, as in distribute()
      const int cut_axis = axis_;
      std::fill_n(next, piece_of.count(), Place(0));
      for(; box != end; ++box) {
        const Place last = piece_of(box->high[cut_axis]);
        for(Place piece = piece_of(box->low[cut_axis]); piece <= last; ++piece)
          ++next[piece];
      }
    });
    for(std::size_t set = 0; set < boxes.set_count(); ++set)
      replace_by_sums_over_blocks(threads_, next_of(set, 0), blocks_, cut.count(),
                                  begins_.data() + set * cut.count());
    size_ = replace_by_prefix_sums(begins_.data(), begins_.data() + begins_.size());
  }

  // The number of boxes in all pieces.
  std::uint64_t size() const { return size_; }

  // Copies the boxes into the pieces. Boxes must be fewer than places.
  void distribute()
  {
    copies_ = make_uninitialized<Box>(size_);
    for_each_block_of_boxes([&](std::size_t set, Place* next, const Box* box, const Box* end) {
      const Equal_cut piece_of = cut_;
      const int axis = axis_;
      Box* const copies = copies_.get();
      add_begins(next, begins_.data() + set * piece_of.count(), piece_of.count());
      for(; box != end; ++box) {
        const Place first = piece_of(box->low[axis]);
        const Place last = piece_of(box->high[axis]);
        copies[next[first]++] = *box;
        for(Place piece = first + 1; piece <= last; ++piece) {
          Box& copy = copies[next[piece]++];
          copy = *box;
          copy.sides |= Place(1) << axis;
        }
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
    return next_.get() + (set * blocks_ + block) * cut_.count();
  }

  // Calls task(set, next, first, last) for blocks of boxes.
  template <class Task>
  void for_each_block_of_boxes(const Task& task)
  {
    for(std::size_t set = 0; set < boxes_.set_count(); ++set)
      threads_.run_numbered_blocks(
        blocks_, boxes_[set].size(), [&](std::size_t block, std::size_t i, std::size_t last) {
          task(set, next_of(set, block), boxes_[set].first + i, boxes_[set].first + last);
        });
  }

  const Piece<Box> boxes_;
  const int axis_;
  const Equal_cut cut_;
  const Threads threads_;
  const std::size_t blocks_;
  const std::unique_ptr<Place[]> next_; // for each set, block and piece
  std::vector<std::uint64_t> begins_; // for each set and piece
  std::uint64_t size_ = 0;
  std::unique_ptr<Box[]> copies_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_CUT_BOXES_H
