// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rtree_of_boxes.h"

#include "object_methods.h"

namespace thick_benchmark {

namespace {

template <int Dimension>
Tally search(const Object_scene& scene)
{
  std::vector<Rtree_box<Dimension>> boxes;
  boxes.reserve(scene.size());
  for(std::size_t i = 0; i < scene.size(); ++i) {
    const auto corner_at = [](const double* x) {
      return rtree_corner_at<Dimension>([x](int axis) { return x[axis]; });
    };
    const double* x = scene.object(i);
    boxes.push_back({{corner_at(x), corner_at(x + Dimension)}, static_cast<std::uint32_t>(i)});
  }
  Tally tally;
  rtree_search_boxes(boxes, [&](std::size_t i, std::size_t j) { tally.neighbour(i, j); });
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
