// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points without duplicates, for structures that merge equal points, and the way back to all the
// positions of the input.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DISTINCT_POINTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_DISTINCT_POINTS_H

#include "pairs.h"
#include "point_scene.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace test_support {

class Distinct_points
{
public:
  explicit Distinct_points(const Points& all)
  {
    std::map<Coordinates, std::size_t> known;
    for(std::size_t i = 0; i < all.size(); ++i) {
      const auto [entry, is_new] = known.emplace(all[i], points_.size());
      if(is_new) {
        points_.push_back(all[i]);
        positions_.emplace_back();
      }
      positions_[entry->second].push_back(i);
    }
  }

  const Points& points() const { return points_; }

  // Appends the pairs of input positions that the distinct points u and v stand for; u == v gives
  // the pairs among its copies.
  void append_pairs(std::size_t u, std::size_t v, Pairs& pairs) const
  {
    for(std::size_t i : positions_[u])
      for(std::size_t j : positions_[v])
        if(u != v || i < j)
          pairs.emplace_back((std::min)(i, j), (std::max)(i, j));
  }

private:
  Points points_;
  std::vector<std::vector<std::size_t>> positions_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DISTINCT_POINTS_H
