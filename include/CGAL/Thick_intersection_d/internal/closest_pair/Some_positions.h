// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SOME_POSITIONS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SOME_POSITIONS_H

// The positions of some points: of the first ones, or of a random sample.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <cstddef>
#include <cstdint>
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
  BOOST_NOINLINE
  Some_positions(const Threads& threads, const Some_positions& sample, std::uint64_t& seed)
  {
    if(threads.are_many())
      draw_in_strata(threads, sample, seed);
    else
      draw(sample, 0, sample.size(), seed, [&](Place p) { positions_.push_back(p); });
    size_ = positions_.size();
  }

  std::size_t size() const { return size_; }

  // Whether the first points are taken.
  bool are_first() const { return positions_.empty(); }

  // Returns the positions of a sample.
  const Place* data() const { return positions_.data(); }

  Place operator[](std::size_t i) const
  {
    return positions_.empty() ? static_cast<Place>(i) : positions_[i];
  }

private:
  // Calls task(position) for the points that are drawn of [first, last).
  template <class Task>
  static void draw(const Some_positions& sample, std::size_t first, std::size_t last,
                   std::uint64_t& seed, const Task& task)
  {
    for(std::size_t i = first + random_word(seed) % max_sample_step; i < last;
        i += 1 + random_word(seed) % max_sample_step)
      task(sample[i]);
  }

  // Draws from each stratum twice, by a seed of its own: first to count the points, and then to
  // write them down.
  void draw_in_strata(const Threads& threads, const Some_positions& sample, std::uint64_t& seed)
  {
    std::vector<std::uint64_t> seeds(sample.size() / sample_stratum_size + 1);
    for(std::uint64_t& seed_of_stratum : seeds)
      seed_of_stratum = random_word(seed);
    const auto draw_each = [&](const auto& task) {
      threads.run_numbered_blocks(
        seeds.size(), sample.size(), [&](std::size_t s, std::size_t first, std::size_t last) {
          std::uint64_t own_seed = seeds[s];
          draw(sample, first, last, own_seed, [&](Place position) { task(s, position); });
        });
    };
    std::vector<std::size_t> next(seeds.size() + 1, 0); // where the next point of a stratum goes
    draw_each([&](std::size_t s, Place) { ++next[s]; });
    positions_.resize(replace_by_prefix_sums(next.data(), next.data() + next.size()));
    draw_each([&](std::size_t s, Place position) { positions_[next[s]++] = position; });
  }

  std::size_t size_;
  std::vector<Place> positions_; // none if the first points are taken
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SOME_POSITIONS_H
