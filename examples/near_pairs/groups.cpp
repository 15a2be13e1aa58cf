// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Neighbors and connected components; see groups.h.

#include "groups.h"

#include <algorithm>
#include <numeric>

namespace near_pairs {

Groups::Groups(std::size_t points)
  : neighbors_(points), components_(points), ranks_(points),
    sets_(ranks_.data(), components_.data())
{
  std::iota(components_.begin(), components_.end(), std::size_t(0));
}

void Groups::add_pair(std::size_t i, std::size_t j)
{
  ++neighbors_[i];
  ++neighbors_[j];
  sets_.union_set(i, j);
}

void Groups::finish()
{
  std::vector<std::size_t> roots(components_.size());
  for(std::size_t i = 0; i < roots.size(); ++i)
    roots[i] = sets_.find_set(i);
  std::vector<std::size_t> numbers(roots.size(), roots.size()); // of the components of roots
  std::vector<std::size_t> sizes;
  for(std::size_t i = 0; i < roots.size(); ++i) {
    std::size_t& number = numbers[roots[i]];
    if(number == roots.size()) {
      number = sizes.size();
      sizes.push_back(0);
    }
    ++sizes[number];
    components_[i] = number;
  }
  number_of_components_ = sizes.size();
  points_of_largest_ = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
}

} // namespace near_pairs
