// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Calls of other libraries, and those of this package that take their place. The manual shows them
// side by side. The program makes each call and compares the numbers of pairs.
//
// The headers of CGAL that are replaced are under the GPL.

#include <CGAL/AABB_tree.h>
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Random.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/interiors.h>
#include <CGAL/thick_box_intersection_d.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>
#include <CGAL/thick_mesh_self_intersections.h>

#if __has_include(<CGAL/AABB_traits_3.h>) // CGAL 6
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif
#if __has_include(<nanoflann.hpp>)
#include <nanoflann.hpp>
#endif

#include <cstddef>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Mesh = CGAL::Surface_mesh<Point>;

std::vector<Point> make_points()
{
  CGAL::Random random(1);
  std::vector<Point> points;
  for(int i = 0; i < 1000; ++i)
    points.emplace_back(random.get_double(), random.get_double(), random.get_double());
  return points;
}

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

void compare_boxes(const std::vector<Triangle>& triangles)
{
  std::size_t theirs = 0, ours = 0;
  std::vector<Box> boxes;
  for(std::size_t i = 0; i < triangles.size(); ++i)
    boxes.emplace_back(triangles[i].bbox(), i);
  {
    std::size_t& count = theirs;
    //! [box before]
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                  [&](const Box&, const Box&) { ++count; });
    //! [box before]
  }
  {
    std::size_t& count = ours;
    //! [box after]
    CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(),
                                        [&](const Box&, const Box&) { ++count; });
    //! [box after]
  }
  std::cout << "boxes: " << theirs << ' ' << ours << '\n';
}

void compare_triangles(const std::vector<Triangle>& triangles)
{
  std::size_t theirs = 0, ours = 0;
  {
    std::size_t& count = theirs;
    //! [triangles before]
    std::vector<Box> boxes;
    for(std::size_t i = 0; i < triangles.size(); ++i)
      boxes.emplace_back(triangles[i].bbox(), i);
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      if(CGAL::do_intersect(triangles[a.info()], triangles[b.info()]))
        ++count;
    });
    //! [triangles before]
  }
  {
    std::size_t& count = ours;
    //! [triangles after]
    CGAL::thick_self_intersection_d(triangles, [&](std::size_t, std::size_t) { ++count; });
    //! [triangles after]
  }
  std::cout << "triangles: " << theirs << ' ' << ours << '\n';
}

void compare_kd_tree(const std::vector<Point>& points, double r)
{
  std::size_t theirs = 0, ours = 0;
  {
    //! [tree before]
    using Traits = CGAL::Search_traits_3<Kernel>;
    CGAL::Kd_tree<Traits> tree(points.begin(), points.end());
    std::vector<Point> neighbors;
    for(const Point& p : points)
      tree.search(std::back_inserter(neighbors), CGAL::Fuzzy_sphere<Traits>(p, r));
    //! [tree before]
    theirs = (neighbors.size() - points.size()) / 2; // without the point itself, each pair once
  }
  {
    std::size_t& count = ours;
    //! [tree after]
    CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(r),
                                      [&](std::size_t, std::size_t) { ++count; });
    //! [tree after]
  }
  std::cout << "Kd_tree: " << theirs << ' ' << ours << '\n';
}

#ifdef NANOFLANN_VERSION
//! [cloud]
struct Cloud
{
  const std::vector<Point>& points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][int(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const { return false; }
};
//! [cloud]

#if NANOFLANN_VERSION < 0x150
using Found = std::pair<std::size_t, double>;
using Search_parameters = nanoflann::SearchParams;
#else
using Found = nanoflann::ResultItem<std::size_t, double>;
using Search_parameters = nanoflann::SearchParameters;
#endif

void compare_nanoflann(const std::vector<Point>& points, double r)
{
  std::size_t theirs = 0, ours = 0;
  //! [nanoflann before]
  const Cloud cloud = {points};
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3,
                                      std::size_t>
    tree(3, cloud);
  tree.buildIndex();
  std::vector<Found> found;
  for(const Point& p : points) {
    const double query[] = {p.x(), p.y(), p.z()};
    tree.radiusSearch(query, r * r, found, Search_parameters());
    theirs += found.size();
  }
  //! [nanoflann before]
  //! [nanoflann after]
  const CGAL::Neighbor_lists neighbors
    = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(r));
  for(std::size_t i = 0; i < points.size(); ++i)
    ours += neighbors[i].size();
  //! [nanoflann after]
  std::cout << "nanoflann: " << theirs - points.size() << ' ' << ours << '\n';
}
#endif

using Position = std::vector<Triangle>::const_iterator;
#if __has_include(<CGAL/AABB_traits_3.h>)
using Tree_traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_triangle_primitive_3<Kernel, Position>>;
#else
using Tree_traits = CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Position>>;
#endif

void compare_aabb_tree(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                       double r)
{
  std::size_t theirs = 0, ours = 0;
  {
    std::size_t& count = theirs;
    //! [aabb before]
    CGAL::AABB_tree<Tree_traits> tree(triangles.begin(), triangles.end());
    const Kernel::Vector_3 reach(r, r, r);
    for(const Point& p : points) {
      std::vector<Position> found;
      tree.all_intersected_primitives(Kernel::Iso_cuboid_3(p - reach, p + reach),
                                      std::back_inserter(found));
      for(Position triangle : found)
        if(CGAL::squared_distance(p, *triangle) <= r * r)
          ++count;
    }
    //! [aabb before]
  }
  {
    std::size_t& count = ours;
    //! [aabb after]
    CGAL::fixed_radius_near_neighbors(points, triangles, CGAL::within_distance(r),
                                      [&](std::size_t, std::size_t) { ++count; });
    //! [aabb after]
  }
  std::cout << "AABB_tree: " << theirs << ' ' << ours << '\n';
}

void compare_mesh(const Mesh& mesh)
{
  using Face_pairs = std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>>;
  Face_pairs theirs, ours;
  {
    Face_pairs& pairs = theirs;
    //! [mesh before]
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    //! [mesh before]
  }
  {
    Face_pairs& pairs = ours;
    //! [mesh after]
    CGAL::thick_mesh_self_intersections(mesh, std::back_inserter(pairs));
    //! [mesh after]
  }
  std::cout << "mesh: " << theirs.size() << ' ' << ours.size() << '\n';
}

void compare_solids(const std::vector<Mesh>& meshes)
{
  using Position_pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  Position_pairs theirs, ours;
  {
    Position_pairs& pairs = theirs;
    //! [solids before]
    CGAL::Polygon_mesh_processing::intersecting_meshes(
      meshes, std::back_inserter(pairs),
      CGAL::parameters::do_overlap_test_of_bounded_sides(true));
    //! [solids before]
  }
  {
    Position_pairs& pairs = ours;
    //! [solids after]
    CGAL::thick_feature_self_intersection_d(meshes, std::back_inserter(pairs));
    //! [solids after]
  }
  std::cout << "solids: " << theirs.size() << ' ' << ours.size() << '\n';
}

using Polygon = CGAL::Polygon_2<CGAL::Exact_predicates_exact_constructions_kernel>;

void compare_polygons(const std::vector<Polygon>& polygons)
{
  std::size_t theirs = 0, ours = 0;
  {
    std::size_t& count = theirs;
    //! [polygons before]
    using Polygon_box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, const Polygon*>;
    std::vector<Polygon_box> boxes;
    for(const Polygon& polygon : polygons)
      boxes.emplace_back(polygon.bbox(), &polygon);
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                  [&](const Polygon_box& a, const Polygon_box& b) {
                                    if(CGAL::do_intersect(*a.info(), *b.info()))
                                      ++count;
                                  });
    //! [polygons before]
  }
  {
    std::size_t& count = ours;
    //! [polygons after]
    CGAL::thick_feature_self_intersection_d(CGAL::interiors(polygons),
                                            [&](std::size_t, std::size_t) { ++count; });
    //! [polygons after]
  }
  std::cout << "polygons: " << theirs << ' ' << ours << '\n';
}

// Tetrahedra of different sizes, of which some are inside others.
std::vector<Mesh> make_solids(const std::vector<Point>& points)
{
  std::vector<Mesh> meshes(points.size() / 4);
  for(std::size_t i = 0; i < meshes.size(); ++i) {
    const double size = i % 5 == 0 ? 0.8 : 0.1;
    const Point* const p = &points[4 * i];
    const auto corner = [&](int k) { return p[0] + size * (p[k] - p[0]); };
    CGAL::make_tetrahedron(p[0], corner(1), corner(2), corner(3), meshes[i]);
  }
  return meshes;
}

// Parcels of a street that share their borders, and a road that overlaps them all.
std::vector<Polygon> make_polygons()
{
  const auto rectangle = [](int x0, int y0, int x1, int y1) {
    Polygon polygon;
    for(const auto& [x, y] : {std::pair(x0, y0), {x1, y0}, {x1, y1}, {x0, y1}})
      polygon.push_back(Polygon::Point_2(x, y));
    return polygon;
  };
  std::vector<Polygon> polygons = {rectangle(0, 8, 200, 12)};
  for(int i = 0; i < 20; ++i)
    for(int y : {0, 10})
      polygons.push_back(rectangle(10 * i, y, 10 * (i + 1), y + 10));
  return polygons;
}

int main()
{
  const std::vector<Point> points = make_points();
  std::vector<Triangle> triangles;
  for(std::size_t i = 0; i + 2 < points.size(); ++i)
    triangles.emplace_back(points[i], points[i + 1], points[i + 2]);
  compare_boxes(triangles);
  compare_triangles(triangles);
  compare_kd_tree(points, 0.1);
#ifdef NANOFLANN_VERSION
  compare_nanoflann(points, 0.1);
#endif
  compare_aabb_tree(points, triangles, 0.1);
  Mesh mesh;
  CGAL::make_grid(10, 10, mesh, true);
  for(const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = points[v];
  compare_mesh(mesh);
  compare_solids(make_solids(points));
  compare_polygons(make_polygons());
}
