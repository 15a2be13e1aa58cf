// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "overlap_methods.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/interiors.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <memory>
#include <vector>

namespace thick_benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class K>
auto polygons_of(const Rings& rings)
{
  auto polygons = std::make_shared<std::vector<CGAL::Polygon_2<K>>>();
  for(const Ring& ring : rings) {
    polygons->emplace_back();
    for(const auto& p : ring)
      polygons->back().push_back(typename K::Point_2(p[0], p[1]));
  }
  return polygons;
}

} // namespace

Overlap_search overlaps_by_interiors(const Rings& rings)
{
  return [polygons = polygons_of<Kernel>(rings)] {
    Tally tally;
    CGAL::thick_feature_self_intersection_d(CGAL::interiors(*polygons), tally);
    return tally;
  };
}

Overlap_search intersections_of_polygons(const Rings& rings)
{
  return [polygons = polygons_of<Kernel>(rings)] {
    Tally tally;
    CGAL::thick_feature_self_intersection_d(*polygons, tally);
    return tally;
  };
}

// Its arrangements have points where edges cross, so the kernel must construct them exactly.
Overlap_search overlaps_by_boolean_sets(const Rings& rings)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  return [polygons = polygons_of<Exact>(rings)] {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
    std::vector<Box> boxes;
    for(std::size_t i = 0; i < polygons->size(); ++i)
      boxes.emplace_back((*polygons)[i].bbox(), i);
    Tally tally;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      if(CGAL::do_intersect((*polygons)[a.info()], (*polygons)[b.info()]))
        tally(a.info(), b.info());
    });
    return tally;
  };
}

} // namespace thick_benchmark
