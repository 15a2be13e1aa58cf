// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STREAMED_SAMPLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STREAMED_SAMPLE_H

// A sample of points whose number is not known before all of them have passed by.

#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Holds a random point of each block of consecutive points. The blocks grow, so that the sample
// stays small. The same points in the same order make the same sample.
class Streamed_sample
{
public:
  // Holds at most `most` points, an even number.
  explicit Streamed_sample(std::size_t most) : most_(most) { sample_.dimension = dimension; }

  // The points that have passed by.
  std::uint64_t count() const { return count_; }

  const Point_sample& sample() const { return sample_; }

  void add(const Stored_point& point)
  {
    if(count_ == chosen_) {
      sample_.coordinates.insert(sample_.coordinates.end(), point.x.begin(), point.x.end());
      sample_.ids.push_back(point.id);
      sample_.loads.push_back({1, 0});
    }
    if(++count_ == block_end_)
      begin_block();
  }

private:
  static constexpr int dimension = 3;

  void begin_block()
  {
    if(sample_.size() == most_)
      double_blocks();
    chosen_ = count_ + random_() % block_;
    block_end_ = count_ + block_;
  }

  // Keeps one of the points of each two blocks.
  void double_blocks()
  {
    for(std::size_t i = 0; i < most_ / 2; ++i) {
      const std::size_t kept = 2 * i + (random_() >> 8) % 2;
      std::copy_n(sample_.point(kept), dimension, sample_.coordinates.data() + i * dimension);
      sample_.ids[i] = sample_.ids[kept];
    }
    sample_.coordinates.resize(most_ / 2 * dimension);
    sample_.ids.resize(most_ / 2);
    sample_.loads.resize(most_ / 2);
    block_ *= 2;
  }

  std::size_t most_;
  Point_sample sample_;
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
