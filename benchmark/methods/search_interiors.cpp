// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "on_objects.h"
#include "overlap_methods.h"

#include <CGAL/interiors.h>
#include <CGAL/thick_intersection_d.h>

#include <type_traits>

namespace thick_benchmark {

namespace {

// Of search(objects, tally), on a vector of objects that have interiors.
template <class Search>
Run<Tally> run_on_filled_objects(const Object_scene& scene, const Search& search)
{
  return run_on_objects<Tally>(scene, [search](const auto& objects, Tally& tally) {
    using Object = typename std::decay_t<decltype(objects.a)>::value_type;
    constexpr bool is_segment = std::is_same_v<Object, Epick::Segment_2>
                                || std::is_same_v<Object, Epick::Segment_3>;
    if constexpr(!is_segment && !std::is_same_v<Object, Epick::Triangle_3>)
      search(objects.a, tally);
  });
}

} // namespace

Overlap_search overlaps_by_interiors(const Object_scene& scene)
{
  return run_on_filled_objects(scene, [](const auto& objects, Tally& tally) {
    CGAL::thick_self_intersection_d(CGAL::interiors(objects), tally);
  });
}

Overlap_search intersections_of_objects(const Object_scene& scene)
{
  return run_on_filled_objects(scene, [](const auto& objects, Tally& tally) {
    CGAL::thick_self_intersection_d(objects, tally);
  });
}

} // namespace thick_benchmark
