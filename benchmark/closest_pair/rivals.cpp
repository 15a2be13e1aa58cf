// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The rivals; see methods.h.

#include "methods.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>

#ifdef THICK_BENCHMARK_HAS_NANOFLANN
#include <nanoflann.hpp>
#endif

#include <algorithm>
#include <cstdint>
#include <limits>

namespace thick_benchmark {
namespace {

template <class Triangulation, class Points>
double shortest_edge(const Points& points)
{
  const Triangulation triangulation(points.begin(), points.end());
  double least = std::numeric_limits<double>::infinity();
  for(auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end();
      ++edge)
    least = std::min(least, triangulation.segment(*edge).squared_length());
  return least;
}

// The second of two neighbours: the first one is the point itself.
template <class Traits, class Points>
double least_by_kd_tree(const Points& points)
{
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  typename Search::Tree tree(points.begin(), points.end());
  tree.build();
  double least = std::numeric_limits<double>::infinity();
  for(const auto& point : points) {
    Search search(tree, point, 2);
    least = std::min(least, std::next(search.begin())->second);
  }
  return least;
}

#ifdef THICK_BENCHMARK_HAS_NANOFLANN
// What nanoflann asks of a container of points.
template <class Points>
struct Adapted_points
{
  const Points& points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return points[i].cartesian(static_cast<int>(axis));
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const { return false; }
};

template <int Dimension>
double least_by_nanoflann(const Points<Dimension>& points)
{
  using Adapted = Adapted_points<Points<Dimension>>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adapted>,
                                                   Adapted, Dimension, std::uint32_t>;
  const Adapted adapted{points};
  const Tree tree(Dimension, adapted);
  double least = std::numeric_limits<double>::infinity();
  for(const auto& point : points) {
    double center[Dimension];
    for(int axis = 0; axis < Dimension; ++axis)
      center[axis] = point.cartesian(axis);
    std::uint32_t indices[2];
    double squares[2];
    tree.knnSearch(center, 2, indices, squares);
    least = std::min(least, squares[1]);
  }
  return least;
}
#endif

} // namespace

double closest_by_delaunay(const Points<2>& points)
{
  return shortest_edge<CGAL::Delaunay_triangulation_2<Kernel>>(points);
}

double closest_by_delaunay(const Points<3>& points)
{
  return shortest_edge<CGAL::Delaunay_triangulation_3<Kernel>>(points);
}

double closest_by_kd_tree(const Points<2>& points)
{
  return least_by_kd_tree<CGAL::Search_traits_2<Kernel>>(points);
}

double closest_by_kd_tree(const Points<3>& points)
{
  return least_by_kd_tree<CGAL::Search_traits_3<Kernel>>(points);
}

#ifdef THICK_BENCHMARK_HAS_NANOFLANN
double closest_by_nanoflann(const Points<2>& points) { return least_by_nanoflann<2>(points); }
double closest_by_nanoflann(const Points<3>& points) { return least_by_nanoflann<3>(points); }
#endif

} // namespace thick_benchmark
