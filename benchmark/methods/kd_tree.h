// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's Kd_tree, asked for a Fuzzy_sphere without fuzziness around each point, or for its nearest
// neighbour. Distances are squared in the number type of the kernel: doubles are not exact.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_KD_TREE_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_KD_TREE_H

#include "all_pairs.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
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

template <class Kernel, class Point>
using Kd_tree_traits = std::conditional_t<dimension_of<Point> == 2, CGAL::Search_traits_2<Kernel>,
                                          CGAL::Search_traits_3<Kernel>>;

// EnableCache tells whether the tree keeps a copy of the coordinates; CGAL's default is that it
// does not.
template <class Kernel, class EnableCache = CGAL::Tag_false, class Point, class Answer>
void kd_tree_search(const std::vector<Point>& points, double r, Answer& answer)
{
  using Numbered_point = std::pair<Point, std::uint32_t>;
  using Traits = CGAL::Search_traits_adapter<Numbered_point,
                                             CGAL::First_of_pair_property_map<Numbered_point>,
                                             Kd_tree_traits<Kernel, Point>>;
  std::vector<Numbered_point> numbered;
  for(std::size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(points[i], static_cast<std::uint32_t>(i));
  CGAL::Kd_tree<Traits, CGAL::Sliding_midpoint<Traits>, CGAL::Tag_true, EnableCache> tree(
    numbered.begin(), numbered.end());
  tree.build();
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto report = [&](const Numbered_point& p) { answer.neighbour(i, p.second); };
    tree.search(boost::make_function_output_iterator(std::ref(report)), // CGAL assigns iterators
                CGAL::Fuzzy_sphere<Traits>(points[i], typename Kernel::FT(r)));
  }
}

// The least squared distance of a point and its nearest neighbour. The first of two neighbours is
// the point itself.
template <class Kernel, class Point>
double kd_tree_closest(const std::vector<Point>& points)
{
  using Search = CGAL::Orthogonal_k_neighbor_search<Kd_tree_traits<Kernel, Point>>;
  typename Search::Tree tree(points.begin(), points.end());
  tree.build();
  double least = std::numeric_limits<double>::infinity();
  for(const Point& point : points) {
    Search search(tree, point, 2);
    least = (std::min)(least, std::next(search.begin())->second);
  }
  return least;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_KD_TREE_H
