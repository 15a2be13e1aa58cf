// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "boxes_of_objects.h"

#include "box_intersection.h"
#include "object_methods.h"

#include <CGAL/intersections.h>

namespace thick_benchmark {

namespace {

// Whether two objects intersect whose boxes do.
template <class Object>
bool is_intersection(const Object& a, const Object& b)
{
  return CGAL::do_intersect(a, b);
}
bool is_intersection(const Ball_3& a, const Ball_3& b)
{
  return CGAL::Thick_ball_traits_d<Epick::Point_3>::Do_intersect_d(3)(a, b);
}
bool is_intersection(const Epick::Iso_rectangle_2&, const Epick::Iso_rectangle_2&) { return true; }
bool is_intersection(const Epick::Iso_cuboid_3&, const Epick::Iso_cuboid_3&) { return true; }

template <class Object>
void search(const Objects<Object>& objects, Tally& tally, std::ptrdiff_t cutoff)
{
  auto a = boxes_of<double>(objects.a, outwards);
  auto b = boxes_of<double>(objects.b, outwards);
  const std::vector<Object>& others = objects.are_two_sets ? objects.b : objects.a;
  const auto report = [&](const auto& s, const auto& t) {
    if(is_intersection(objects.a[s.info()], others[t.info()]))
      tally(s.info(), t.info());
  };
  if(objects.are_two_sets)
    CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(), report, cutoff);
  else
    CGAL::box_self_intersection_d(a.begin(), a.end(), report, cutoff);
}

} // namespace

Object_method boxes_of_objects(std::ptrdiff_t cutoff)
{
  return {"boxes, cutoff " + std::to_string(cutoff), [=](const Object_scene& scene) {
            return run_on_objects<Tally>(scene, [=](const auto& objects, Tally& tally) {
              search(objects, tally, cutoff);
            });
          }};
}

} // namespace thick_benchmark
