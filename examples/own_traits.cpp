// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Traits of one's own, with three predicates: requests to a server that come from one network
// within a second. Addresses are no numbers, so there are no intervals: they have an order, and
// addresses of one network follow each other in it.

#include <CGAL/thick_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

struct Request
{
  std::array<unsigned, 8> address; // IPv6; the first four numbers are the network
  long long time;                  // nanoseconds since 1970, more than doubles hold
};

class Burst_traits
{
public:
  using Object_d = Request;

  explicit Burst_traits(long long duration) : duration_(duration) {}

  // Axis 0 is the time, axis 1 is the address.
  struct Less_coordinate_d
  {
    bool operator()(const Request& a, const Request& b, int i) const
    {
      return i == 0 ? a.time < b.time : a.address < b.address;
    }
  };

  struct Is_close_along_axis_d
  {
    long long duration;
    bool operator()(const Request& a, const Request& b, int i) const
    {
      return i == 0 ? std::llabs(a.time - b.time) <= duration
                    : std::equal(a.address.begin(), a.address.begin() + 4, b.address.begin());
    }
  };

  struct Do_intersect_d
  {
    Is_close_along_axis_d is_close;
    bool operator()(const Request& a, const Request& b) const
    {
      return is_close(a, b, 0) && is_close(a, b, 1);
    }
  };

  int dimension() const { return 2; }
  Less_coordinate_d less_coordinate_d_object() const { return {}; }
  Is_close_along_axis_d is_close_along_axis_d_object() const { return {duration_}; }
  Do_intersect_d do_intersect_d_object() const { return {is_close_along_axis_d_object()}; }

private:
  long long duration_;
};

int main()
{
  const long long t = 1700000000000000000, second = 1000000000;
  const std::vector<Request> requests = {{{0x2001, 0xdb8, 0, 1, 0, 0, 0, 7}, t},
                                         {{0x2001, 0xdb8, 0, 1, 0, 0, 0, 9}, t + second},
                                         {{0x2001, 0xdb8, 0, 2, 0, 0, 0, 7}, t},
                                         {{0x2001, 0xdb8, 0, 1, 0, 0, 0, 8}, t + second + 1}};
  CGAL::thick_self_intersection_d(
    requests, [](std::size_t i, std::size_t j) { std::cout << i << ' ' << j << '\n'; },
    CGAL::parameters::geom_traits(Burst_traits(second)));
}
