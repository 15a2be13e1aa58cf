// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boost.Geometry's R-tree, packed when it is made, asked for the boxes that meet each box.

#include "object_methods.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cstdint>
#include <utility>

namespace thick_benchmark {

namespace {

namespace geometry = boost::geometry;

template <int Dimension>
using Corner = geometry::model::point<double, Dimension, geometry::cs::cartesian>;
template <int Dimension>
using Numbered_box = std::pair<geometry::model::box<Corner<Dimension>>, std::uint32_t>;

template <int Dimension>
Corner<Dimension> corner_at(const double* x)
{
  if constexpr(Dimension == 2)
    return {x[0], x[1]};
  else
    return {x[0], x[1], x[2]};
}

template <int Dimension>
Tally search(const Object_scene& scene)
{
  using Box = Numbered_box<Dimension>;
  std::vector<Box> boxes;
  boxes.reserve(scene.size());
  for(std::size_t i = 0; i < scene.size(); ++i) {
    const double* x = scene.object(i);
    boxes.push_back({{corner_at<Dimension>(x), corner_at<Dimension>(x + Dimension)},
                     static_cast<std::uint32_t>(i)});
  }
  const geometry::index::rtree<Box, geometry::index::linear<16>> tree(boxes);
  Tally tally;
  for(const Box& box : boxes)
    tree.query(geometry::index::intersects(box.first),
               boost::make_function_output_iterator(
                 [&](const Box& other) { tally.neighbour(box.second, other.second); }));
  return tally;
}

} // namespace

Object_method rtree_of_boxes()
{
  return {"Boost.Geometry rtree", [](const Object_scene& scene) -> Run<Tally> {
            return [&scene] { return scene.dimension == 2 ? search<2>(scene) : search<3>(scene); };
          }};
}

} // namespace thick_benchmark
