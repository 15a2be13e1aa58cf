// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Search in Delaunay triangulations. Of equal points one is found.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_DELAUNAY_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_DELAUNAY_H

#include "all_pairs.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/range_search_delaunay_2.h>

#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace thick_benchmark {

template <class Kernel, int Dimension>
struct Delaunay;

template <class Kernel>
struct Delaunay<Kernel, 2>
{
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Data = CGAL::Triangulation_data_structure_2<Vertex_base>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Data>;
  using Edge = typename Triangulation::Edge;

  static std::pair<std::uint32_t, std::uint32_t> ends(const Edge& e)
  {
    return {e.first->vertex(Triangulation::cw(e.second))->info(),
            e.first->vertex(Triangulation::ccw(e.second))->info()};
  }
};

template <class Kernel>
struct Delaunay<Kernel, 3>
{
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
  using Cell_base = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
  using Data = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Data>;
  using Edge = typename Triangulation::Edge;

  static std::pair<std::uint32_t, std::uint32_t> ends(const Edge& e)
  {
    return {e.first->vertex(e.second)->info(), e.first->vertex(e.third)->info()};
  }
};

// The neighbours of vertex v are others[begin[v]], ..., others[begin[v + 1] - 1].
struct Adjacency
{
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> others;
};

template <class Kernel, class Point>
auto triangulate(const std::vector<Point>& points)
{
  std::vector<std::pair<Point, std::uint32_t>> vertices;
  for(std::size_t i = 0; i < points.size(); ++i)
    vertices.emplace_back(points[i], static_cast<std::uint32_t>(i));
  return typename Delaunay<Kernel, dimension_of<Point>>::Triangulation(vertices.begin(),
                                                                       vertices.end());
}

template <class Kernel, class Point>
Adjacency delaunay_neighbours(const std::vector<Point>& points)
{
  using Kind = Delaunay<Kernel, dimension_of<Point>>;
  const typename Kind::Triangulation triangulation = triangulate<Kernel>(points);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  Adjacency adjacency{std::vector<std::uint32_t>(points.size() + 2, 0), {}};
  for(const typename Kind::Edge& e : triangulation.finite_edges()) {
    edges.push_back(Kind::ends(e));
    ++adjacency.begin[edges.back().first + 2];
    ++adjacency.begin[edges.back().second + 2];
  }
  for(std::size_t v = 2; v < adjacency.begin.size(); ++v)
    adjacency.begin[v] += adjacency.begin[v - 1];
  adjacency.others.resize(2 * edges.size());
  for(const auto& [u, v] : edges) { // begin[v + 1] grows from where v begins to where it ends
    adjacency.others[adjacency.begin[u + 1]++] = v;
    adjacency.others[adjacency.begin[v + 1]++] = u;
  }
  return adjacency;
}

// Breadth-first search, from each point through the points near it: these are connected to it
// inside their ball. [L]
template <class Kernel, class Point, class Is_near, class Answer>
void delaunay_search(const std::vector<Point>& points, const Is_near& is_near, Answer& answer)
{
  const Adjacency adjacency = delaunay_neighbours<Kernel>(points);
  std::vector<std::uint32_t> last_source(points.size(), ~std::uint32_t(0));
  std::vector<std::uint32_t> reached;
  for(std::uint32_t source = 0; source < points.size(); ++source) {
    reached.assign(1, source);
    last_source[source] = source;
    for(std::size_t next = 0; next < reached.size(); ++next)
      for(std::uint32_t e = adjacency.begin[reached[next]];
          e != adjacency.begin[reached[next] + 1]; ++e) {
        const std::uint32_t v = adjacency.others[e];
        if(last_source[v] == source)
          continue;
        last_source[v] = source;
        if(!is_near(source, v))
          continue;
        reached.push_back(v);
        answer.neighbour(source, v);
      }
  }
}

// CGAL's own search in the plane, in the circle around each point. The square of r is that of the
// kernel's number type.
template <class Kernel, class Answer>
void delaunay_circle_search(const std::vector<typename Kernel::Point_2>& points, double r,
                            Answer& answer)
{
  auto triangulation = triangulate<Kernel>(points);
  const typename Kernel::FT radius(r);
  const typename Kernel::FT square = radius * radius;
  std::vector<typename Delaunay<Kernel, 2>::Triangulation::Vertex_handle> centres, near;
  for(const auto v : triangulation.finite_vertex_handles())
    centres.push_back(v);
  for(const auto centre : centres) {
    near.clear();
    CGAL::range_search(triangulation, typename Kernel::Circle_2(centre->point(), square),
                       std::back_inserter(near));
    for(const auto v : near)
      answer.neighbour(centre->info(), v->info());
  }
}

// The least squared distance: the shortest edge, for distinct points.
template <class Kernel, class Point>
double delaunay_closest(const std::vector<Point>& points)
{
  using Triangulation
    = std::conditional_t<dimension_of<Point> == 2, CGAL::Delaunay_triangulation_2<Kernel>,
                         CGAL::Delaunay_triangulation_3<Kernel>>;
  const Triangulation triangulation(points.begin(), points.end());
  double least = std::numeric_limits<double>::infinity();
  for(auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end();
      ++edge)
    least = (std::min)(least, triangulation.segment(*edge).squared_length());
  return least;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_DELAUNAY_H
