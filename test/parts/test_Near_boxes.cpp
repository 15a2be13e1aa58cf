// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The boxes of parts, and which parts receive a point.

#include <CGAL/Thick_intersection_d/internal/parts/Near_boxes.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Near_boxes)

namespace internal = CGAL::Thick_intersection_d::internal;

using Boxes = std::vector<internal::Part_box>;

struct On_line
{
  double x;
  std::pair<double, double> bounds_along(int) const { return {x, x}; }
};

internal::Part_box interval(double low, double high)
{
  internal::Part_box box(1);
  box.add(On_line{low});
  box.add(On_line{high});
  return box;
}

BOOST_AUTO_TEST_CASE(boxes_with_points_are_read_as_they_were_written)
{
  std::vector<char> bytes;
  internal::write_boxes({interval(1, 2), internal::Part_box(1), interval(5, 7)}, bytes);
  internal::write_boxes({}, bytes);
  const std::vector<Boxes> boxes = internal::read_boxes_of_parts(bytes, 1);
  BOOST_REQUIRE_EQUAL(boxes.size(), 2);
  BOOST_REQUIRE_EQUAL(boxes[0].size(), 2);
  BOOST_CHECK_EQUAL(boxes[0][0].intervals()[0].high, 2);
  BOOST_CHECK_EQUAL(boxes[0][1].intervals()[0].low, 5);
  BOOST_CHECK(boxes[1].empty());
}

// Part 1 receives from part 2, and part 2 from part 0. Part 0 has two boxes around those of others.
BOOST_AUTO_TEST_CASE(a_part_receives_a_point_near_two_of_its_boxes_once)
{
  const Boxes mine = {internal::Part_box(1), interval(4, 6)};
  const std::vector<Boxes> all
    = {{interval(1, 3), interval(7, 9)}, {interval(3, 3.5), interval(6.5, 7)}, {interval(4, 6)}};
  const auto receivers = [&](std::size_t box, double x, double reach) {
    std::vector<std::size_t> parts;
    internal::Near_boxes(mine, 2, all, reach).for_receivers(box, On_line{x}, [&](std::size_t part) {
      parts.push_back(part);
    });
    return parts;
  };
  BOOST_CHECK(receivers(1, 4, 0.5) == std::vector<std::size_t>{1});
  BOOST_CHECK(receivers(1, 6, 0.5) == std::vector<std::size_t>{1});
  BOOST_CHECK(receivers(1, 5, 3) == std::vector<std::size_t>{1});
  BOOST_CHECK(receivers(1, 5, 0.5).empty());
  BOOST_CHECK(receivers(0, 5, 3).empty());
}

BOOST_AUTO_TEST_SUITE_END()
