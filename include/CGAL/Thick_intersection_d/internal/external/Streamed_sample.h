// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STREAMED_SAMPLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STREAMED_SAMPLE_H

// A sample of points whose number is not known before all of them have passed by.

#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Holds a random point of each block of consecutive points. The blocks grow, so that the sample
// stays small. The same points in the same order make the same sample.
template <class Point>
class Streamed_sample
{
public:
  // Holds at most `most` points, an even number.
  explicit Streamed_sample(std::size_t most) : most_(most) {}

  const std::vector<Point>& points() const { return points_; }

  void add(const Point& point)
  {
    if(count_ == chosen_)
      points_.push_back(point);
    if(++count_ == block_end_)
      begin_block();
  }

private:
  void begin_block()
  {
    if(points_.size() == most_)
      double_blocks();
    chosen_ = count_ + random_() % block_;
    block_end_ = count_ + block_;
  }

  // Keeps one of the points of each two blocks.
  void double_blocks()
  {
    for(std::size_t i = 0; i < most_ / 2; ++i)
      points_[i] = points_[2 * i + (random_() >> 8) % 2];
    points_.resize(most_ / 2);
    block_ *= 2;
  }

  std::size_t most_;
  std::vector<Point> points_;
  Random_numbers random_;
  std::uint64_t count_ = 0;
  std::uint64_t block_ = 1;
  std::uint64_t chosen_ = 0;
  std::uint64_t block_end_ = 1;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STREAMED_SAMPLE_H
