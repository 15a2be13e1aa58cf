// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's own ways to near pairs: kd-trees with and without a cache of coordinates, circular range
// search in Delaunay triangulations, intersecting boxes, and Compare_squared_distance.

#include "methods/Cell_list.h"
#include "columns.h"

#include "support/exact_points.h"
#include "support/kernels.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/property_map.h>
#include <CGAL/range_search_delaunay_2.h>

namespace lab {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

template <class Kernel, int Dimension>
auto kernel_points(const Point_scene& scene)
{
  return test_support::make_points<test_support::Cartesian_points<Kernel, Dimension>>(
    scene.points);
}

// With the square of r as the number type of the kernel has it.
template <class Kernel, int Dimension>
Found find_by_compare_squared_distance(const Point_scene& scene)
{
  const auto points = kernel_points<Kernel, Dimension>(scene);
  const auto arrays = array_points<Dimension>(scene);
  using FT = typename Kernel::FT;
  const FT r(length_of(scene.radius));
  const FT square = r * r;
  return timed(false, [&](Pairs& pairs) {
    for_each_candidate(arrays, length_of(scene.radius), [&](std::size_t i, std::size_t j) {
      if(CGAL::compare_squared_distance(points[i], points[j], square) != CGAL::LARGER)
        pairs.push_back(std::minmax(i, j));
    });
  });
}

template <class Kernel, int Dimension, class EnableCache>
Found find_by_kd_tree(const Point_scene& scene)
{
  using Plain_traits = std::conditional_t<Dimension == 2, CGAL::Search_traits_2<Kernel>,
                                          CGAL::Search_traits_3<Kernel>>;
  using Point = typename Plain_traits::Point_d;
  using Value = std::pair<Point, std::size_t>;
  using Traits
    = CGAL::Search_traits_adapter<Value, CGAL::First_of_pair_property_map<Value>, Plain_traits>;
  using Tree = CGAL::Kd_tree<Traits, CGAL::Sliding_midpoint<Traits>, CGAL::Tag_true, EnableCache>;

  std::vector<Value> values;
  for(const Point& p : kernel_points<Kernel, Dimension>(scene))
    values.emplace_back(p, values.size());
  const typename Kernel::FT r(length_of(scene.radius));
  return timed(true, [&](Pairs& pairs) {
    Tree tree(values.begin(), values.end());
    tree.build();
    std::vector<Value> near;
    for(const Value& centre : values) {
      near.clear();
      tree.search(std::back_inserter(near),
                  CGAL::Fuzzy_sphere<Traits>(centre, r, typename Kernel::FT(0)));
      for(const Value& other : near)
        if(other.second != centre.second)
          pairs.emplace_back(centre.second, other.second);
    }
  });
}

template <class Kernel>
Found find_by_delaunay(const Point_scene& scene)
{
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Triangulation
    = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
  std::vector<std::pair<typename Kernel::Point_2, std::size_t>> vertices;
  for(const auto& p : kernel_points<Kernel, 2>(scene))
    vertices.emplace_back(p, vertices.size());
  const typename Kernel::FT r(length_of(scene.radius));
  const typename Kernel::FT square = r * r;
  return timed(true, [&](Pairs& pairs) {
    Triangulation triangulation(vertices.begin(), vertices.end()); // equal points become one
    std::vector<typename Triangulation::Vertex_handle> centres, near;
    for(auto v : triangulation.finite_vertex_handles())
      centres.push_back(v);
    for(auto centre : centres) {
      near.clear();
      CGAL::range_search(triangulation, typename Kernel::Circle_2(centre->point(), square),
                         std::back_inserter(near));
      for(auto v : near)
        if(v != centre)
          pairs.emplace_back(centre->info(), v->info());
    }
  });
}

// Boxes of side r around the points, in doubles as programs write them; the pairs that meet are
// decided exactly, so that only lost ones are wrong.
template <int Dimension, CGAL::Box_intersection_d::Topology Topology>
Found find_by_boxes(const Point_scene& scene)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, Dimension, std::size_t>;
  const test_support::Exact_points exact(scene.points, scene.radius);
  const double half = length_of(scene.radius) / 2;
  return timed(false, [&](Pairs& pairs) {
    std::vector<Box> boxes;
    for(const auto& p : scene.points) {
      double low[Dimension], high[Dimension];
      for(int axis = 0; axis < Dimension; ++axis) {
        low[axis] = p[axis] - half;
        high[axis] = p[axis] + half;
      }
      boxes.emplace_back(low, high, boxes.size());
    }
    const auto report = [&](const Box& a, const Box& b) {
      if(exact.are_within_radius(a.info(), b.info()))
        pairs.push_back(std::minmax(a.info(), b.info()));
    };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), report, std::ptrdiff_t(10), Topology);
  });
}

template <int Dimension>
std::vector<Method> methods()
{
  using CGAL::Box_intersection_d::CLOSED;
  using CGAL::Box_intersection_d::HALF_OPEN;
  using CGAL::Tag_false;
  using CGAL::Tag_true;
  std::vector<Method> result = {
    {"EPICK Compare_squared_distance", "library",
     find_by_compare_squared_distance<Epick, Dimension>},
    {"Kd_tree EPICK", "library", find_by_kd_tree<Epick, Dimension, Tag_false>},
    {"Kd_tree EPICK, cache", "library", find_by_kd_tree<Epick, Dimension, Tag_true>},
    {"Kd_tree EPECK", "library", find_by_kd_tree<Epeck, Dimension, Tag_false>},
    {"Kd_tree EPECK, cache", "library", find_by_kd_tree<Epeck, Dimension, Tag_true>},
    {"Kd_tree rational", "library", find_by_kd_tree<Rational_kernel, Dimension, Tag_false>},
    {"Kd_tree rational, cache", "library", find_by_kd_tree<Rational_kernel, Dimension, Tag_true>},
    {"boxes, closed", "boxes", find_by_boxes<Dimension, CLOSED>},
    {"boxes, half-open", "boxes", find_by_boxes<Dimension, HALF_OPEN>},
  };
  if constexpr(Dimension == 2) {
    result.push_back({"Delaunay EPICK", "library", find_by_delaunay<Epick>});
    result.push_back({"Delaunay EPECK", "library", find_by_delaunay<Epeck>});
  }
  else
    for(const Method& method : delaunay_methods_3())
      result.push_back(method);
  return result;
}

} // namespace

std::vector<Method> cgal_methods(int dimension)
{
  return dimension == 2 ? methods<2>() : methods<3>();
}

} // namespace lab
