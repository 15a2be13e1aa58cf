// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the pairs make of the points: how many neighbors each has, and the connected components.

#ifndef NEAR_PAIRS_GROUPS_H
#define NEAR_PAIRS_GROUPS_H

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <vector>

namespace near_pairs {

class Groups
{
public:
  explicit Groups(std::size_t points);
  Groups(const Groups&) = delete;
  Groups& operator=(const Groups&) = delete;

  void add_pair(std::size_t i, std::size_t j);

  // Call this after the last pair, and before the functions below.
  void finish();

  std::size_t neighbors(std::size_t point) const { return neighbors_[point]; }

  // The number of the component of a point. Components are numbered from 0, in the order of their
  // first points.
  std::size_t component(std::size_t point) const { return components_[point]; }

  std::size_t number_of_components() const { return number_of_components_; }
  std::size_t points_of_largest() const { return points_of_largest_; }

private:
  std::vector<std::size_t> neighbors_;
  std::vector<std::size_t> components_; // until finish(), the parents of the points
  std::vector<unsigned char> ranks_;
  boost::disjoint_sets<unsigned char*, std::size_t*> sets_;
  std::size_t number_of_components_ = 0;
  std::size_t points_of_largest_ = 0;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_GROUPS_H
