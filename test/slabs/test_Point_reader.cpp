// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blocks have all points in their order, wherever their doubles are in memory.

#include "support/point_source.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Point_reader.h>

BOOST_AUTO_TEST_SUITE(Point_reader)

using namespace test_support;

constexpr int dimension = 3;
using Near_points = internal::Near_points<dimension>;
using Doubles_view = internal::Doubles_view<dimension>;

const char* address(const double& x) { return reinterpret_cast<const char*>(&x); }

// Points in an array, each with something behind its coordinates.
struct In_array
{
  struct Element
  {
    std::array<double, dimension> x;
    int color;
  };

  explicit In_array(const Points& points)
  {
    for(const Coordinates& c : points)
      elements.push_back({{c[0], c[1], c[2]}, 0});
  }

  Doubles_view view() const
  {
    Doubles_view view;
    for(std::size_t axis = 0; axis < dimension; ++axis) {
      view.x[axis] = elements.empty() ? nullptr : address(elements[0].x[axis]);
      view.step[axis] = sizeof(Element);
    }
    return view;
  }

  std::vector<Element> elements;
};

// Points in columns. All points share the coordinate along axis 1.
struct In_columns
{
  explicit In_columns(const Points& points)
  {
    for(const Coordinates& c : points)
      for(std::size_t axis = 0; axis < dimension; ++axis)
        columns[axis].push_back(c[axis]);
  }

  Doubles_view view() const
  {
    Doubles_view view;
    for(std::size_t axis = 0; axis < dimension; ++axis) {
      view.x[axis] = columns[axis].empty() ? nullptr : address(columns[axis][0]);
      view.step[axis] = axis == 1 ? 0 : sizeof(double);
    }
    return view;
  }

  std::array<std::vector<double>, dimension> columns;
};

// Reads the points [first, last) in blocks, along all axes and along each one.
void check_blocks(const Near_points& near, const Points& points, std::size_t first,
                  std::size_t last)
{
  const internal::Block_reader<dimension> reader(near);
  for(int axis = Near_points::all_axes; axis < dimension; ++axis) {
    std::size_t next = first;
    reader.read_blocks(first, last, axis, [&](const internal::Point_block& block) {
      BOOST_REQUIRE_EQUAL(block.first, next);
      for(std::size_t p = 0; p < block.size; ++p, ++next) {
        for(int a = 0; a < dimension; ++a)
          if(axis == a || axis == Near_points::all_axes)
            BOOST_CHECK_EQUAL(block.point(p)[a], points[next][static_cast<std::size_t>(a)]);
        if(axis == Near_points::all_axes)
          BOOST_CHECK_EQUAL(block.numbers[p], next);
      }
    });
    BOOST_CHECK_EQUAL(next, last);
  }
}

void check_points(const Near_points& near, const Points& points)
{
  check_blocks(near, points, 0, points.size());
  check_blocks(near, points, points.size() / 3, points.size() / 3 * 2);
  for(std::size_t i = 0; i < points.size(); i += 7) {
    const std::array<double, dimension> x = internal::doubles_of(near, i);
    BOOST_CHECK(std::equal(x.begin(), x.end(), points[i].begin()));
  }
}

BOOST_AUTO_TEST_CASE(points_are_read_from_wherever_they_are)
{
  for(const std::size_t size : {0, 1, 2, 3, 5, 255, 256, 257, 1000}) {
    Points points = uniform_points(dimension, size, 0, 1, size);
    for(Coordinates& c : points)
      c[1] = 0.25;
    Point_source<dimension> source(points);
    check_points(source, points);
    for(const std::size_t first_size : {std::size_t(0), size / 2, size}) {
      const Points first(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first_size));
      const Points second(points.begin() + static_cast<std::ptrdiff_t>(first_size), points.end());
      source.are_viewed = true;
      source.first_size = first_size;
      const In_array array(first), other_array(second);
      const In_columns columns(first), other_columns(second);
      source.views[0] = array.view();
      source.views[1] = other_array.view();
      check_points(source, points);
      In_array shared(first); // an array, but for axis 1
      for(std::size_t i = 1; i < first_size; ++i)
        shared.elements[i].x[1] = 7;
      source.views[0] = shared.view();
      source.views[0].step[1] = 0;
      check_points(source, points);
      source.views[0] = columns.view();
      check_points(source, points);
      source.views[1] = other_columns.view();
      check_points(source, points);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
