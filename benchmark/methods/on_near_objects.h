// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The objects of a scene in EPICK, and their grown boxes.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_ON_NEAR_OBJECTS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_ON_NEAR_OBJECTS_H

#include "near_methods.h"
#include "on_objects.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace thick_benchmark {

// Of search(objects, r, pairs), where objects are a vector of segments or triangles.
template <class Search>
auto on_near_objects(const Search& search)
{
  return [search](const Near_scene& scene) {
    return run_on_simplices<Pair_list, Epick>(
      scene.objects, [search, r = scene.r](const auto& objects, Pair_list& pairs) {
        using Object = typename std::decay_t<decltype(objects.a)>::value_type;
        if constexpr(!std::is_same_v<Object, Epick::Tetrahedron_3>)
          search(objects.a, r, pairs);
      });
  };
}

// Boxes that are grown by x on all sides, rounded outwards.
inline double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
inline double below(double x) { return -above(-x); }

inline CGAL::Bbox_2 grown(const CGAL::Bbox_2& box, double x)
{
  return CGAL::Bbox_2(below(box.xmin() - x), below(box.ymin() - x), above(box.xmax() + x),
                      above(box.ymax() + x));
}

inline CGAL::Bbox_3 grown(const CGAL::Bbox_3& box, double x)
{
  return CGAL::Bbox_3(below(box.xmin() - x), below(box.ymin() - x), below(box.zmin() - x),
                      above(box.xmax() + x), above(box.ymax() + x), above(box.zmax() + x));
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_ON_NEAR_OBJECTS_H
