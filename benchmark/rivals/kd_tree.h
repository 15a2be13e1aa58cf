// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's Kd_tree, asked for a Fuzzy_sphere without fuzziness around each point. It squares the
// distance in the number type of the kernel: with doubles it is not exact.

#ifndef THICK_INTERSECTION_BENCHMARK_RIVALS_KD_TREE_H
#define THICK_INTERSECTION_BENCHMARK_RIVALS_KD_TREE_H

#include "near_points.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace thick_benchmark {

template <class Kernel, class Point, class Callback>
void kd_tree_search(const std::vector<Point>& points, double r, Callback& callback)
{
  using Numbered_point = std::pair<Point, std::uint32_t>;
  using Base_traits = std::conditional_t<dimension_of<Point> == 2, CGAL::Search_traits_2<Kernel>,
                                         CGAL::Search_traits_3<Kernel>>;
  using Traits = CGAL::Search_traits_adapter<
    Numbered_point, CGAL::First_of_pair_property_map<Numbered_point>, Base_traits>;

  std::vector<Numbered_point> numbered;
  for(std::size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(points[i], static_cast<std::uint32_t>(i));
  CGAL::Kd_tree<Traits> tree(numbered.begin(), numbered.end());
  tree.build();
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto report = [&](const Numbered_point& p) {
      if(i < p.second)
        callback(i, p.second);
    };
    tree.search(boost::make_function_output_iterator(std::ref(report)), // CGAL assigns iterators
                CGAL::Fuzzy_sphere<Traits>(points[i], r));
  }
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_RIVALS_KD_TREE_H
