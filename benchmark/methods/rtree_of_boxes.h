// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boost.Geometry's R-tree, packed when it is made, asked for the boxes that meet each box.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_RTREE_OF_BOXES_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_RTREE_OF_BOXES_H

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace thick_benchmark {

template <int Dimension>
using Rtree_corner
  = boost::geometry::model::point<double, Dimension, boost::geometry::cs::cartesian>;
template <int Dimension>
using Rtree_box
  = std::pair<boost::geometry::model::box<Rtree_corner<Dimension>>, std::uint32_t>;

// x(axis) is a coordinate of the corner.
template <int Dimension, class Coordinate>
Rtree_corner<Dimension> rtree_corner_at(const Coordinate& x)
{
  if constexpr(Dimension == 2)
    return {x(0), x(1)};
  else
    return {x(0), x(1), x(2)};
}

// Calls report(i, j) for each i and each j whose boxes meet, also for i == j.
template <class Box, class Report>
void rtree_search_boxes(const std::vector<Box>& boxes, const Report& report)
{
  namespace index = boost::geometry::index;
  const index::rtree<Box, index::linear<16>> tree(boxes);
  for(const Box& box : boxes)
    tree.query(index::intersects(box.first),
               boost::make_function_output_iterator(
                 [&](const Box& other) { report(box.second, other.second); }));
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_RTREE_OF_BOXES_H
