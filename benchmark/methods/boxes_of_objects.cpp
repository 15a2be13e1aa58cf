// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "boxes_of_objects.h"

#include "box_intersection.h"
#include "object_methods.h"

#include <CGAL/intersections.h>

#include <type_traits>

namespace thick_benchmark {

namespace {

namespace boxes = CGAL::Box_intersection_d;

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
  auto a = boxes_of<double, boxes::ID_EXPLICIT>(objects.a, outwards);
  auto b = boxes_of<double, boxes::ID_EXPLICIT>(objects.b, outwards);
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

template <class Object>
void search_by_address(const std::vector<Object>& objects, Tally& tally)
{
  const auto boxes_in_order
    = boxes_of<double, boxes::ID_FROM_BOX_ADDRESS>(objects, outwards);
  using Box = typename std::decay_t<decltype(boxes_in_order)>::value_type;
  std::vector<const Box*> addresses;
  for(const Box& box : boxes_in_order)
    addresses.push_back(&box);
  const auto report = [&](const Box* s, const Box* t) {
    if(is_intersection(objects[s->info()], objects[t->info()]))
      tally(s->info(), t->info());
  };
  CGAL::box_self_intersection_d(addresses.begin(), addresses.end(), report,
                                std::ptrdiff_t(2000));
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

Object_method boxes_by_address()
{
  return {"boxes as in PMP", [](const Object_scene& scene) {
            return run_on_objects<Tally>(scene, [](const auto& objects, Tally& tally) {
              search_by_address(objects.a, tally);
            });
          }};
}

} // namespace thick_benchmark
