// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "on_near_objects.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <string>
#include <type_traits>
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

template <class Object>
using Position = typename std::vector<Object>::const_iterator;

template <class Object>
using Primitive_t
  = std::conditional_t<std::is_same_v<Object, Epick::Segment_3>,
                       CGAL::AABB_segment_primitive<Epick, Position<Object>>,
                       CGAL::AABB_triangle_primitive<Epick, Position<Object>>>;

template <class Object>
void search_tree(const std::vector<Object>& objects, double r, Pair_list& pairs)
{
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Epick, Primitive_t<Object>>>;
  const Tree tree(objects.begin(), objects.end());
  for(auto i = objects.begin(); i != objects.end(); ++i) {
    const auto report = [&](const Position<Object>& j) {
      if(i < j && CGAL::squared_distance(*i, *j) <= r * r)
        pairs(static_cast<std::size_t>(i - objects.begin()),
              static_cast<std::size_t>(j - objects.begin()));
    };
    tree.all_intersected_primitives(Epick::Iso_cuboid_3(grown(i->bbox(), r)),
                                    boost::make_function_output_iterator(report));
  }
}

} // namespace

Near_method near_by_boxes(std::ptrdiff_t cutoff)
{
  return {"box_self_intersection_d, cutoff " + std::to_string(cutoff),
          on_near_objects([=](const auto& objects, double r, Pair_list& pairs) {
            search_boxes(objects, r, pairs, cutoff);
          })};
}

Near_method near_by_aabb_tree()
{
  return {"AABB_tree", on_near_objects([](const auto& objects, double r, Pair_list& pairs) {
            using Object = typename std::decay_t<decltype(objects)>::value_type;
            if constexpr(std::is_same_v<Object, Epick::Segment_3>
                         || std::is_same_v<Object, Epick::Triangle_3>)
              search_tree(objects, r, pairs);
            else
              throw std::invalid_argument("The tree takes segments and triangles in space.");
          })};
}

} // namespace thick_benchmark
