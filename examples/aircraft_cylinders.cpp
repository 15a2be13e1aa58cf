// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Traits of one's own, with intervals: aircraft in conflict, closer than 5 nautical miles (9260 m)
// horizontally and than 1000 feet (304.8 m) vertically. Each aircraft is the axis of a cylinder of
// half that size, and two are in conflict iff the interiors of their cylinders intersect.
//
// All numbers are whole decimeters, so the answer is exact: the sum of the squares fits in 64 bits,
// and doubles hold the ends of the intervals.

#include <CGAL/Dimension.h>
#include <CGAL/thick_intersection_d.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

struct Aircraft
{
  std::int64_t position[3]; // east, north, up
};

struct Conflict_traits
{
  static constexpr std::int64_t horizontal = 92600, vertical = 3048; // decimeters

  using Object_d = Aircraft;
  using Dimension = CGAL::Dimension_tag<3>;

  // The box of the cylinder.
  struct Interval_d
  {
    std::pair<double, double> operator()(const Aircraft& a, int axis) const
    {
      const std::int64_t half = (axis == 2 ? vertical : horizontal) / 2;
      return {double(a.position[axis] - half), double(a.position[axis] + half)};
    }
  };

  struct Do_intersect_d
  {
    bool operator()(const Aircraft& a, const Aircraft& b) const
    {
      const std::int64_t east = a.position[0] - b.position[0];
      const std::int64_t north = a.position[1] - b.position[1];
      const std::int64_t up = a.position[2] - b.position[2];
      return east * east + north * north < horizontal * horizontal && std::abs(up) < vertical;
    }
  };

  int dimension() const { return 3; }
  Interval_d interval_d_object() const { return {}; }
  Do_intersect_d do_intersect_d_object() const { return {}; }
};

int main()
{
  const std::vector<Aircraft> aircraft = {{{0, 0, 100584}},
                                          {{60000, 60000, 102108}},
                                          {{60000, 60000, 105156}},  // 304.8 m above the last
                                          {{60000, 152600, 105156}}, // 9260 m north of the last
                                          {{60000, 152599, 108000}}};
  CGAL::thick_self_intersection_d(
    aircraft, [](std::size_t i, std::size_t j) { std::cout << i << ' ' << j << '\n'; },
    CGAL::parameters::geom_traits(Conflict_traits()));
}
