// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's own circular range search on an exact Delaunay triangulation, once per distinct point.
// It shares no arithmetic with brute_force.h: the distances are compared by the exact kernel.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DELAUNAY_ORACLE_2_H
#define THICK_INTERSECTION_TEST_SUPPORT_DELAUNAY_ORACLE_2_H

#include "distinct_points.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/range_search_delaunay_2.h>

#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_support {

namespace delaunay_2 {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Data_structure = CGAL::Triangulation_data_structure_2<Vertex_base>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Data_structure>;

inline Kernel::FT exact_integer(const std::string& text)
{
  const double value = std::stod(text);
  if(std::abs(value) > 9007199254740992.) // 2^53
    throw std::invalid_argument("squared radius with too many digits for this oracle: " + text);
  return Kernel::FT(value);
}

inline Kernel::FT exact_square(const Radius& radius)
{
  if(radius.length())
    return Kernel::FT(*radius.length()) * Kernel::FT(*radius.length());
  const std::string& text = radius.square_text();
  const std::size_t bar = text.find('/');
  if(bar == std::string::npos)
    return exact_integer(text);
  return exact_integer(text.substr(0, bar)) / exact_integer(text.substr(bar + 1));
}

inline Triangulation triangulate(const Points& points)
{
  std::vector<std::pair<Kernel::Point_2, std::size_t>> vertices;
  for(std::size_t i = 0; i < points.size(); ++i)
    vertices.emplace_back(Kernel::Point_2(points[i][0], points[i][1]), i);
  return Triangulation(vertices.begin(), vertices.end());
}

} // namespace delaunay_2

inline Pairs delaunay_pairs_2(const Point_scene& scene)
{
  using namespace delaunay_2;
  const Distinct_points distinct(scene.points);
  const Kernel::FT square = delaunay_2::exact_square(scene.radius);
  Triangulation triangulation = triangulate(distinct.points());
  std::vector<Triangulation::Vertex_handle> sources, found;
  for(auto v : triangulation.finite_vertex_handles())
    sources.push_back(v);
  Pairs pairs;
  for(auto source : sources) {
    found.clear();
    CGAL::range_search(triangulation, Kernel::Circle_2(source->point(), square),
                       std::back_inserter(found));
    for(auto v : found)
      if(source->info() <= v->info())
        distinct.append_pairs(source->info(), v->info(), pairs);
  }
  return sorted(std::move(pairs));
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_DELAUNAY_ORACLE_2_H
