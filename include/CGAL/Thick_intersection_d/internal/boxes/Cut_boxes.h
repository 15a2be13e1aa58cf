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
  // Counts the boxes of each piece.
  Cut_boxes(const Span<Box>& boxes, int axis, const Equal_cut& cut)
    : boxes_(boxes), axis_(axis), cut_(cut),
      blocks_(boxes.size() < min_size_for_threads ? 1 : block_count<ConcurrencyTag>()),
      next_(blocks_ * cut.count(), 0)
  {
    for_each_box([&](std::size_t block, const Box& box) {
      const Place last = cut_(box.high[axis_]);
      for(Place piece = cut_(box.low[axis_]); piece <= last; ++piece)
        ++next(block, piece);
    });
    for(Place piece = 0; piece < cut.count(); ++piece) {
      begins_.push_back(size_);
      for(std::size_t block = 0; block < blocks_; ++block)
        size_ += std::exchange(next(block, piece), static_cast<Place>(size_));
    }
    begins_.push_back(size_);
  }

  // The number of boxes in all pieces.
  std::uint64_t size() const { return size_; }

  // Copies the boxes into the pieces. Boxes are to be fewer than places.
  void distribute()
  {
    copies_ = make_uninitialized<Box>(size_);
    for_each_box([&](std::size_t block, const Box& box) {
      const Place first = cut_(box.low[axis_]);
      const Place last = cut_(box.high[axis_]);
      copies_[next(block, first)++] = box;
      for(Place piece = first + 1; piece <= last; ++piece) {
        Box& copy = copies_[next(block, piece)++];
        copy = box;
        copy.sides |= Place(1) << axis_;
      }
    });
  }

  Span<Box> piece(Place piece) const
  {
    return {copies_.get() + begins_[piece], copies_.get() + begins_[piece + 1]};
  }

private:
  static constexpr Place min_size_for_threads = 1 << 14;

  Place& next(std::size_t block, Place piece) { return next_[block * cut_.count() + piece]; }

  template <class Task>
  void for_each_box(const Task& task)
  {
    for_each_numbered_block<ConcurrencyTag>(
      blocks_, boxes_.size(), [&](std::size_t block, std::size_t i, std::size_t last) {
        for(; i != last; ++i)
          task(block, boxes_.first[i]);
      });
  }

  const Span<Box> boxes_;
  const int axis_;
  const Equal_cut cut_;
  const std::size_t blocks_;
  std::vector<Place> next_; // for each block and piece, where the next box goes
  std::vector<std::uint64_t> begins_;
  std::uint64_t size_ = 0;
  std::unique_ptr<Box[]> copies_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_CUT_BOXES_H
