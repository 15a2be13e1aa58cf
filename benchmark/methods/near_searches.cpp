// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "on_near_objects.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/thick_intersection_d.h>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace thick_benchmark {

namespace {

template <class Object>
void search_boxes(const std::vector<Object>& objects, double r, Pair_list& pairs,
                  std::ptrdiff_t cutoff)
{
  constexpr int dimension = CGAL::Ambient_dimension<Object>::value;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, dimension, std::size_t>;
  std::vector<Box> boxes;
  boxes.reserve(objects.size());
  for(std::size_t i = 0; i < objects.size(); ++i)
    boxes.emplace_back(grown(objects[i].bbox(), r / 2), i);
  const auto report = [&](const Box& a, const Box& b) {
    if(CGAL::squared_distance(objects[a.info()], objects[b.info()]) <= r * r)
      pairs((std::min)(a.info(), b.info()), (std::max)(a.info(), b.info()));
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), report, cutoff);
}

template <class Maker>
Run<Pair_list> search_thickened(const Near_scene& scene)
{
  using Object = decltype(Maker::make(nullptr));
  std::vector<std::pair<Object, double>> objects;
  objects.reserve(scene.objects.size());
  for(std::size_t i = 0; i < scene.objects.size(); ++i)
    objects.emplace_back(Maker::make(scene.objects.object(i)), scene.r / 2);
  return [objects = std::make_shared<const decltype(objects)>(std::move(objects))] {
    Pair_list pairs;
    CGAL::thick_self_intersection_d(*objects, pairs);
    return pairs;
  };
}

} // namespace

Near_method near_objects()
{
  return {"Thick_intersection_d", on_near_objects([](const auto& objects, double r,
                                                     Pair_list& pairs) {
            CGAL::fixed_radius_near_neighbors(objects, CGAL::within_distance(r), pairs);
          })};
}

Near_method thickened_objects()
{
  return {"objects with radii", [](const Near_scene& scene) {
            using Segment_2 = From_corners<Epick::Segment_2, Epick::Point_2, 2>;
            using Segment_3 = From_corners<Epick::Segment_3, Epick::Point_3, 2>;
            using Triangle_3 = From_corners<Epick::Triangle_3, Epick::Point_3, 3>;
            if(scene.objects.shape == Shape::TRIANGLE)
              return search_thickened<Triangle_3>(scene);
            return scene.objects.dimension == 2 ? search_thickened<Segment_2>(scene)
                                                : search_thickened<Segment_3>(scene);
          }};
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

Near_method near_by_boxes(std::ptrdiff_t cutoff)
{
  return {"box_self_intersection_d, cutoff " + std::to_string(cutoff),
          on_near_objects([=](const auto& objects, double r, Pair_list& pairs) {
            search_boxes(objects, r, pairs, cutoff);
          })};
}

} // namespace thick_benchmark
