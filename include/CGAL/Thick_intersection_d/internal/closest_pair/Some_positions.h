// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SOME_POSITIONS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SOME_POSITIONS_H

// The positions of some points: of the first ones, or of a random sample.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Some_positions
{
public:
  // Takes the first `size` points.
  explicit Some_positions(std::size_t size) : size_(size) {}

  // Draws each point of another sample with a probability of 1/8.
  BOOST_NOINLINE Some_positions(const Some_positions& sample, std::uint64_t& seed)
  {
    for(std::size_t i = random_word(seed) % max_sample_step; i < sample.size();
        i += 1 + random_word(seed) % max_sample_step)
      positions_.push_back(sample[i]);
    size_ = positions_.size();
  }

  std::size_t size() const { return size_; }

  Place operator[](std::size_t i) const
  {
    return positions_.empty() ? static_cast<Place>(i) : positions_[i];
  }

  // Copies the positions [first, last) of the sample.
  void copy(std::size_t first, std::size_t last, Place* positions) const
  {
    if(positions_.empty())
      std::iota(positions, positions + (last - first), static_cast<Place>(first));
    else
      std::copy(positions_.data() + first, positions_.data() + last, positions);
  }

private:
  std::size_t size_;
  std::vector<Place> positions_; // none if the first points are taken
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SOME_POSITIONS_H
