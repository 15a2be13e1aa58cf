// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "on_near_objects.h"

#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

#include <type_traits>
#include <vector>

namespace thick_benchmark {

Near_method near_objects()
{
  return {"Thick_intersection_d", on_near_objects([](const auto& objects, double r,
                                                     Pair_list& pairs) {
            CGAL::fixed_radius_near_neighbors(objects, CGAL::within_distance(r), pairs);
          })};
}

Near_method grown_boxes()
{
  return {"grown boxes alone", on_near_objects([](const auto& objects, double r, Pair_list& pairs) {
            std::vector<std::decay_t<decltype(objects.front().bbox())>> boxes;
            boxes.reserve(objects.size());
            for(const auto& object : objects)
              boxes.push_back(grown(object.bbox(), r / 2));
            CGAL::thick_self_intersection_d(boxes, pairs);
          })};
}

} // namespace thick_benchmark
