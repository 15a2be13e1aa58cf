// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Traits of one's own: aircraft in conflict, closer than 9260 m horizontally and than 305 m
// vertically. The distances are a state of the traits. All numbers are whole meters, so the
// predicates are exact.

#include <CGAL/thick_intersection_d.h>
#include <cstdlib>
#include <iostream>
#include <vector>

struct Aircraft
{
  long position[3]; // east, north, up
};

class Conflict_traits
{
public:
  using Object_d = Aircraft;

  Conflict_traits(long horizontal, long vertical) : reach_{horizontal, horizontal, vertical} {}

  struct Less_coordinate_d
  {
    bool operator()(const Aircraft& a, const Aircraft& b, int i) const
    {
      return a.position[i] < b.position[i];
    }
  };

  struct Is_close_along_axis_d
  {
    long reach[3];
    bool operator()(const Aircraft& a, const Aircraft& b, int i) const
    {
      return std::labs(a.position[i] - b.position[i]) < reach[i];
    }
  };

  struct Do_intersect_d
  {
    Is_close_along_axis_d is_close;
    bool operator()(const Aircraft& a, const Aircraft& b) const
    {
      const long east = a.position[0] - b.position[0], north = a.position[1] - b.position[1];
      const long horizontal = is_close.reach[0];
      return is_close(a, b, 2) && east * east + north * north < horizontal * horizontal;
    }
  };

  int dimension() const { return 3; }
  Less_coordinate_d less_coordinate_d_object() const { return {}; }
  Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return {{reach_[0], reach_[1], reach_[2]}};
  }
  Do_intersect_d do_intersect_d_object() const { return {is_close_along_axis_d_object()}; }

private:
  long reach_[3];
};

int main()
{
  const std::vector<Aircraft> aircraft = {{{0, 0, 10000}},
                                          {{5000, 5000, 10200}},
                                          {{5000, 5000, 11000}},
                                          {{5000, 14000, 11000}}};
  CGAL::thick_self_intersection_d(
    aircraft, [](std::size_t i, std::size_t j) { std::cout << i << ' ' << j << '\n'; },
    CGAL::parameters::geom_traits(Conflict_traits(9260, 305)));
}
