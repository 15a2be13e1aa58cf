// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The randomized incremental algorithm. It inserts points in random order into cells about as large
// as the distance of the closest pair so far. It compares each point with the points in the cells
// around. When the distance shrinks, it makes the cells anew. The k-th point is in the closest pair
// of the first k points with probability 2/k, and new cells take O(k) time. So the expected time is
// linear for any points that know neither the order nor the keys of the hash. [Golin, Raman,
// Schwarz, Smid: Simple randomized algorithms for closest pair problems, 1995]

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_INCREMENTAL_CELLS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_INCREMENTAL_CELLS_H

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Join_task.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace thick_benchmark {

namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Place;

template <int Dimension, class Elements>
class Incremental_cells
{
  using Minimum = internal::Pair_minimum<Elements>;
  using Cells = internal::Hashed_cells<Dimension>;

public:
  // Takes the points of the scene at `positions`.
  Incremental_cells(const Elements& points, std::vector<Place> positions,
                    const internal::Scene& scene, std::uint64_t seed)
    : points_(points), positions_(std::move(positions)), error_(scene.error), seed_(seed),
      slot_bits_(internal::hash_table_bits(positions_.size())),
      heads_(std::size_t(1) << slot_bits_), next_(positions_.size())
  {
    std::copy_n(scene.box.begin(), Dimension, box_.begin());
    std::mt19937_64 random(seed);
    for(std::size_t i = positions_.size(); i > 1; --i)
      std::swap(positions_[i - 1], positions_[random() % i]);
  }

  // Offers the closest pairs to `minimum`. Returns false if it cannot go on, because points are
  // equal or doubles are too coarse for the distance.
  bool search(Minimum& minimum)
  {
    if(positions_.size() >= 2)
      minimum.offer(positions_[0], positions_[1]);
    if(!refine(minimum, 0))
      return false;
    // Invariant: the closest pairs of the first k points have been offered, and these points are in
    // the cells.
    for(std::size_t k = 0; k < positions_.size(); ++k) {
      around_.for_each_cell_around(doubles_of(positions_[k]).data(), [&](std::uint64_t hash) {
        for(Place other = heads_[slot(hash)]; other != 0; other = next_[other - 1])
          minimum.offer(positions_[k], positions_[other - 1]);
      });
      if(minimum.reach() < reach_ && !refine(minimum, k))
        return false;
      insert(k);
    }
    return true;
  }

private:
  // Makes cells that fit the distance, and inserts the first `count` points.
  bool refine(const Minimum& minimum, std::size_t count)
  {
    if(!minimum.has_tight_reach() || !internal::do_cells_fit(minimum.reach(), error_))
      return false;
    reach_ = minimum.reach();
    const double padded_reach
      = std::nextafter(reach_ + error_, std::numeric_limits<double>::infinity());
    around_ = Cells(box_, 0, padded_reach, 2 * reach_, seed_);
    home_ = Cells(box_, 0, 0, 2 * reach_, seed_);
    std::fill(heads_.begin(), heads_.end(), 0);
    for(std::size_t k = 0; k < count; ++k)
      insert(k);
    return true;
  }

  void insert(std::size_t k)
  {
    Place& head = heads_[slot(home_.first_cell_around(doubles_of(positions_[k]).data()).hash)];
    next_[k] = head;
    head = static_cast<Place>(k) + 1;
  }

  std::array<double, Dimension> doubles_of(Place position) const
  {
    std::array<double, Dimension> x;
    for(int axis = 0; axis < Dimension; ++axis)
      x[static_cast<std::size_t>(axis)]
        = internal::coordinate_bounds(points_[position], axis).first;
    return x;
  }

  std::size_t slot(std::uint64_t hash) const { return hash >> (64 - slot_bits_); }

  const Elements& points_;
  std::vector<Place> positions_; // in the order of insertion
  double error_;
  std::uint64_t seed_; // of the hash
  double reach_ = 0;
  std::array<internal::Interval, Dimension> box_;
  Cells around_ = Cells(box_, 0, 0, 1, 0); // the cells that points within the distance are in
  Cells home_ = around_;                   // the cell of a point
  int slot_bits_;
  std::vector<Place> heads_; // by slot: 1 + the last point in cells of this slot, or 0
  std::vector<Place> next_;  // by point: 1 + the point before it in the slot, or 0
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_INCREMENTAL_CELLS_H
