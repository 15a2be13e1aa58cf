// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Counts near pairs of integer points with a grid of cells of the size of the reach: a simple exact
// reference for files that are too large for brute force.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_GRID_COUNT_H
#define THICK_INTERSECTION_TEST_SUPPORT_GRID_COUNT_H

#include "decimal.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace test_support {

struct Pair_count
{
  std::size_t closer;    // than the threshold
  std::size_t at_radius; // exactly
};

using Integer_points = std::vector<std::vector<Decimal_integer>>;
using Cell = std::array<long, 3>;
using Grid = std::map<Cell, std::vector<std::size_t>>;

// Division rounds towards zero: the cells at zero are twice as wide, which costs time but no pair.
inline Grid make_grid(const Integer_points& points, const Decimal_integer& cell_size)
{
  Grid grid;
  for(std::size_t i = 0; i < points.size(); ++i) {
    Cell cell{};
    for(std::size_t axis = 0; axis < points[i].size(); ++axis)
      cell[axis] = static_cast<long>(Decimal_integer(points[i][axis] / cell_size));
    grid[cell].push_back(i);
  }
  return grid;
}

// Of two neighbouring cells one is before the other, and only that one looks at both.
inline std::vector<std::size_t> points_in_later_neighbours(const Grid& grid, const Cell& cell)
{
  std::vector<std::size_t> result;
  for(long x = -1; x <= 1; ++x)
    for(long y = -1; y <= 1; ++y)
      for(long z = -1; z <= 1; ++z) {
        const Cell other{cell[0] + x, cell[1] + y, cell[2] + z};
        const auto found = other > cell ? grid.find(other) : grid.end();
        if(found != grid.end())
          result.insert(result.end(), found->second.begin(), found->second.end());
      }
  return result;
}

inline Decimal_integer squared_distance(const std::vector<Decimal_integer>& p,
                                        const std::vector<Decimal_integer>& q)
{
  Decimal_integer sum = 0, difference;
  for(std::size_t axis = 0; axis < p.size(); ++axis) {
    difference = p[axis] - q[axis];
    sum += difference * difference;
  }
  return sum;
}

// Points of dimension at most 3; pairs are compared with length(i, j), which is at most `reach`.
template <class Length>
Pair_count grid_count(const Integer_points& points, const Decimal_integer& reach,
                      const Length& length)
{
  Pair_count count{0, 0};
  const auto decide = [&](std::size_t i, std::size_t j) {
    const Decimal_integer bound = length(i, j);
    const int sign = squared_distance(points[i], points[j]).compare(Decimal_integer(bound * bound));
    count.closer += sign < 0 ? 1 : 0;
    count.at_radius += sign == 0 ? 1 : 0;
  };
  const Grid grid = make_grid(points, reach);
  for(const auto& [cell, members] : grid) {
    const std::vector<std::size_t> others = points_in_later_neighbours(grid, cell);
    for(std::size_t a = 0; a < members.size(); ++a) {
      for(std::size_t b = a + 1; b < members.size(); ++b)
        decide(members[a], members[b]);
      for(std::size_t other : others)
        decide(members[a], other);
    }
  }
  return count;
}

inline Pair_count grid_count(const Integer_points& points, const Decimal_integer& radius)
{
  return grid_count(points, radius, [&](std::size_t, std::size_t) { return radius; });
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_GRID_COUNT_H
