// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes in groups, some of which are pairs, and the pairs of groups by brute force.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_GROUPED_BOXES_H
#define THICK_INTERSECTION_TEST_SUPPORT_GROUPED_BOXES_H

#include "number_boxes.h"
#include "pairs.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace test_support {

// Of the boxes of two groups that meet, one of `rarity` pairs makes the groups a pair. If `rarity`
// is zero, none does. What is asked is counted. Unwanted pairs are not to be asked about.
class Grouped_objects : public Number_objects
{
public:
  static constexpr bool have_groups = true;

  Grouped_objects(const Number_boxes& boxes, int dimension, const std::vector<std::size_t>& groups,
                  std::size_t rarity)
    : Number_objects(boxes, dimension, false), groups_(groups), rarity_(rarity)
  {}

  std::size_t group_of(std::size_t i) const { return groups_[i]; }

  bool is_wanted(std::size_t i, std::size_t j) const
  {
    ++looks;
    return is_open(i, j);
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    ++tests;
    wrong += !is_open(i, j);
    if(!Number_objects::do_intersect(i, j) || !is_pair(i, j))
      return false;
    known_.insert(groups_of(i, j));
    return true;
  }

  Pair groups_of(std::size_t i, std::size_t j) const
  {
    return std::minmax({groups_[i], groups_[j]});
  }

  // The pairs of groups, in ascending order.
  Pairs all_pairs(const Pairs& meeting_boxes) const
  {
    std::set<Pair> pairs;
    for(const auto& [i, j] : meeting_boxes)
      if(groups_[i] != groups_[j] && is_pair(i, j))
        pairs.insert(groups_of(i, j));
    return Pairs(pairs.begin(), pairs.end());
  }

  mutable std::size_t looks = 0; // at pairs of boxes, to see whether they are wanted
  mutable std::size_t tests = 0;
  mutable std::size_t wrong = 0; // tests

private:
  bool is_open(std::size_t i, std::size_t j) const
  {
    return groups_[i] != groups_[j] && known_.count(groups_of(i, j)) == 0;
  }

  bool is_pair(std::size_t i, std::size_t j) const
  {
    return rarity_ != 0 && ((std::min)(i, j) * 7 + (std::max)(i, j) * 31) % rarity_ == 0;
  }

  const std::vector<std::size_t> groups_;
  const std::size_t rarity_;
  mutable std::set<Pair> known_;
};

// The pairs of groups by the box route.
template <int Axes>
Pairs pairs_of_groups(const Grouped_objects& objects, const Box_tuning& tuning = Box_tuning(),
                      std::optional<std::size_t> first_set_size = std::nullopt)
{
  Pairs pairs;
  for(const auto& [i, j] : pairs_by_boxes<Axes>(objects, tuning, first_set_size))
    pairs.push_back(objects.groups_of(i, j));
  return sorted(pairs);
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_GROUPED_BOXES_H
