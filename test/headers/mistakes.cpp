// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Calls that do not compile. For each of them the compiler says one sentence, and nothing else. The
// sentence is in the comment above the call; check_mistakes.sh compares.

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/Dimension.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Memory_budget.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/Thick_object_traits_d.h>
#include <CGAL/closest_pair.h>
#include <CGAL/external_fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_tracks.h>
#include <CGAL/interiors.h>
#include <CGAL/periodic_closest_pair.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>
#include <CGAL/property_map.h>
#include <CGAL/thick_box_intersection_d.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>
#include <CGAL/thick_mesh_self_intersections.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Ball = std::pair<Point, double>;

struct Point_of_any_dimension
{
  using Ambient_dimension = CGAL::Dynamic_dimension_tag;
  int dimension() const;
  double cartesian(int axis) const;
};

// A model of ThickDistanceTraits_d.
struct Traits_of_strings
{
  int dimension() const;
  struct Interval_d
  {
    std::pair<double, double> operator()(const std::string&, int) const;
  };
  struct Is_within_distance_d
  {
    bool operator()(const std::string&, const std::string&, CGAL::Distance_bound<double>) const;
  };
  Interval_d interval_d_object() const;
  Is_within_distance_d is_within_distance_d_object() const;
};

// Classes that derive from objects of a kernel, with a test of their own.
struct Owned_parcel : Kernel::Triangle_2
{
  int owner;
};
struct Owned_road : Kernel::Segment_2
{
  int owner;
};
bool do_intersect(const Owned_parcel&, const Owned_road&);

// Traits whose functor has another name than the concept says.
struct Traits_with_wrong_name : Traits_of_strings
{
  struct Is_within_distance_d {};
  Is_within_distance_d is_within_distance_d_object() const;
};

// Traits that inherit functors of other objects.
struct Traits_of_other_objects : CGAL::Thick_object_traits_d<Kernel::Segment_2>
{
  using Object_d = std::string;
};

const std::vector<Point> points;
const std::vector<Kernel::Point_3> points_in_space;
const std::vector<std::map<double, Point>> tracks;
const std::vector<std::map<double, Kernel::Point_3>> tracks_in_space;
const std::vector<Point_of_any_dimension> points_of_any_dimension;
const std::vector<std::array<double, 2>> arrays;
const std::vector<Kernel::Weighted_point_2> weighted_points;
const std::vector<Ball> balls;
const std::vector<std::pair<Point, std::size_t>> points_with_indices;
const std::vector<std::pair<Point, int>> points_with_numbers;
const std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> points_with_normals;
const std::vector<CGAL::Polygon_2<Kernel>> polygons;
const std::vector<std::variant<std::vector<Point>, CGAL::Polygon_2<Kernel>>>
  polylines_and_polygons;
const std::vector<CGAL::Polygon_2<CGAL::Projection_traits_xy_3<Kernel>>> projected_polygons;
const CGAL::Surface_mesh<Kernel::Point_3> mesh;
const std::vector<Kernel::Circle_2> circles;
const std::vector<std::string> strings;
const std::vector<std::variant<Kernel::Segment_2, Kernel::Segment_3>> variants;
const std::vector<CGAL::Bbox_2> boxes;
const std::vector<std::pair<std::pair<std::vector<Point>, double>, double>> thickened_twice;
const std::vector<std::pair<std::vector<Point>, double>> roads_with_widths;
const std::vector<Owned_parcel> owned_parcels;
const std::vector<Owned_road> owned_roads;
const std::vector<CGAL::Box_intersection_d::Box_d<double, 2>> boxes_with_ids;
const auto bound = CGAL::within_distance(1);
const auto report = [](std::size_t, std::size_t) {};
const auto report_images = [](std::size_t, std::size_t, const std::array<int, 2>&) {};
const auto report_text = [](std::size_t, std::size_t, const std::array<int, 2>&) {
  return std::string();
};
const Kernel::Iso_rectangle_2 square;
const CGAL::Memory_budget budget(1 << 30);
CGAL::Scene_profile profile;
std::pair<CGAL::SM_Face_index, CGAL::SM_Face_index>* pairs_of_faces = nullptr;

void make_mistakes()
{
  // error: The callback must take two positions (std::size_t i, std::size_t j). For one that
  // takes two elements of the range, pass CGAL::with_elements(callback).
  CGAL::fixed_radius_near_neighbors(points, bound, [](const Point&, const Point&) {});

  // error: The callback in with_elements() must take two elements of the range.
  CGAL::fixed_radius_near_neighbors(points, bound, CGAL::with_elements([](const std::string&) {}));

  // error: The callback must return void, or bool to tell whether the search goes on.
  CGAL::thick_self_intersection_d(boxes, [](std::size_t, std::size_t) { return std::string(); });

  // error: The points must be points in the plane or in space whose coordinates are doubles, or
  // numbers that doubles hold.
  CGAL::external_fixed_radius_near_neighbors(points_of_any_dimension, bound, budget, report);

  // error: The callback must take two positions of the type std::uint64_t.
  CGAL::external_fixed_radius_near_neighbors(points, bound, budget,
                                             [](const Point&, const Point&) {});

  // error: The callback must return void, or bool to tell whether the search goes on.
  CGAL::external_fixed_radius_near_neighbors(points, bound, budget,
                                             [](std::uint64_t, std::uint64_t) { return 0; });

  // error: Parallel_tag is enabled but TBB is unavailable.
  CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(points, bound, report);

  // error: The argument must be a range with forward iterators.
  CGAL::fixed_radius_near_neighbors(7, bound, report);

  // error: The elements of the range must be points or objects of a kernel of CGAL: pass a
  // property map to such elements as point_map, or a model of ThickDistanceTraits_d as geom_traits.
  CGAL::fixed_radius_near_neighbors(arrays, bound, report);

  // error: The elements of the range must be points of a kernel of CGAL: pass a property map
  // to such points as point_map.
  CGAL::closest_pair(balls);

  // error: The property map point_map must take the elements of the range.
  CGAL::fixed_radius_near_neighbors(
    points, bound, report,
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Ball>()));

  // error: Weighted points have no distance here: pass a point_map to their points, or make them
  // balls: pairs of a center and a radius.
  CGAL::fixed_radius_neighbor_lists(weighted_points, bound);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare
  // number.
  CGAL::fixed_radius_near_neighbors(points, 1.0, report);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare
  // number.
  CGAL::fixed_radius_near_neighbors(points, points, 1, report);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare
  // number.
  CGAL::has_close_pair(points, 1.f);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare
  // number.
  CGAL::external_fixed_radius_near_neighbors(points, 1L, budget, report);

  // error: The objects must be all in the plane, or all in space.
  CGAL::fixed_radius_near_neighbors(variants, bound, report);

  // error: The objects must be all in the plane, or all in space.
  CGAL::thick_intersection_d(boxes, points_in_space, report);

  // error: A Scene_profile is for points and objects of a kernel, without geom_traits.
  CGAL::fixed_radius_near_neighbors(strings, bound, report, profile,
                                    CGAL::parameters::geom_traits(Traits_of_strings()));

  // error: geom_traits must be a model of ThickDistanceTraits_d whose functors take the elements
  // of the range and the bound, or the kernel of points.
  CGAL::fixed_radius_near_neighbors(points, bound, report, CGAL::parameters::geom_traits(42));

  // error: geom_traits must be a model of ThickDistanceTraits_d whose functors take the elements
  // of the range and the bound, or the kernel of points.
  CGAL::fixed_radius_neighbor_lists(
    points_in_space, bound,
    CGAL::parameters::geom_traits(CGAL::Projection_traits_xy_3<Kernel>()));

  // error: geom_traits must be a model of ThickDistanceTraits_d whose functors take the elements
  // of the range and the bound, or the kernel of points.
  CGAL::fixed_radius_near_neighbors(boxes, boxes, bound, report,
                                    CGAL::parameters::geom_traits(Traits_with_wrong_name()));

  // error: geom_traits must be the kernel of the points, if it is given: this function asks no
  // other traits.
  CGAL::closest_pair(points, CGAL::parameters::geom_traits(Traits_of_strings()));

  // error: geom_traits must be the kernel of the points, if it is given: this function asks no
  // other traits.
  CGAL::thick_feature_self_intersection_d(
    points, report, CGAL::parameters::geom_traits(CGAL::Thick_object_traits_d<Point>()));

  // error: geom_traits must be the kernel of the points, if it is given: this function asks no
  // other traits.
  CGAL::thick_mesh_self_intersections(mesh, pairs_of_faces,
                                      CGAL::parameters::geom_traits(Traits_of_strings()));

  // error: The last argument must be made of named parameters: pass traits by
  // CGAL::parameters::geom_traits(traits).
  CGAL::fixed_radius_near_neighbors(points, bound, report, Kernel());

  // error: The first template argument must be Sequential_tag or Parallel_tag.
  CGAL::fixed_radius_near_neighbors<int>(points, bound, report);

  // error: The progress functor that is given as callback must take a double, and return bool to
  // tell whether the search goes on.
  CGAL::closest_pair(points, CGAL::parameters::callback([](double) {}));

  // error: The elements of the range must be objects with bbox() and do_intersect(): pass a
  // property map to such objects as point_map, or traits as geom_traits.
  CGAL::thick_self_intersection_d(polygons, report);

  // error: vertex_point_map is for meshes: pass the map as point_map.
  CGAL::closest_pair(points, CGAL::parameters::vertex_point_map(mesh.points()));

  // error: point_map is for ranges: pass the map from the vertices of a mesh as vertex_point_map.
  CGAL::thick_mesh_self_intersections(mesh, pairs_of_faces,
                                      CGAL::parameters::point_map(mesh.points()));

  // error: A pair of an object and an integer may be an object with an index: pass a property map
  // to the objects as point_map, or make the integer a number of the kernel if it is a radius.
  CGAL::fixed_radius_near_neighbors(points_with_indices, bound, report);

  // error: A pair of an object and an integer may be an object with an index: pass a property map
  // to the objects as point_map, or make the integer a number of the kernel if it is a radius.
  CGAL::thick_self_intersection_d(points_with_numbers, report);

  // error: The elements of the range must be points or objects of a kernel of CGAL: pass a
  // property map to such elements as point_map, or a model of ThickDistanceTraits_d as geom_traits.
  CGAL::fixed_radius_near_neighbors(points_with_normals, bound, report);

  // error: This function does not take interiors(). Two interiors are within a distance iff the
  // closed objects are closer: pass the ranges, and bound.open().
  CGAL::fixed_radius_near_neighbors(CGAL::interiors(boxes), bound, report);

  // error: geom_traits decide about objects as they are: pass them without interiors().
  CGAL::thick_self_intersection_d(
    CGAL::interiors(boxes), report,
    CGAL::parameters::geom_traits(CGAL::Thick_object_traits_d<CGAL::Bbox_2>()));

  // error: interiors() takes objects with an interior: triangles in the plane, tetrahedra,
  // iso-boxes, and objects with a radius. Beside them may be other objects of a kernel.
  CGAL::thick_intersection_d(CGAL::interiors(points), boxes, report);

  // error: interiors() takes objects with an interior: triangles in the plane, tetrahedra,
  // iso-boxes, and objects with a radius. Beside them may be other objects of a kernel.
  CGAL::thick_intersection_d(CGAL::interiors(owned_parcels), owned_roads, report);

  // error: A Scene_profile is for objects of a kernel or boxes, without geom_traits.
  CGAL::thick_intersection_d(owned_parcels, owned_roads, report, profile);

  // error: A weighted point is no ball: make it a pair of a center and a radius.
  CGAL::thick_self_intersection_d(weighted_points, report);

  // error: The ranges hold objects of two types: geom_traits must have intervals of both, and
  // do_intersect_d_object() must take one of each.
  CGAL::thick_intersection_d(
    points, boxes, report, CGAL::parameters::geom_traits(CGAL::Thick_object_traits_d<Point>()));

  // error: do_intersect() takes circles and spheres as curves and surfaces: use
  // Thick_ball_traits_d.
  CGAL::thick_self_intersection_d(circles, report);

  // error: The elements of the range must be objects with bbox() and do_intersect(): pass a
  // property map to such objects as point_map, or traits as geom_traits.
  CGAL::thick_intersection_d(strings, strings, report);

  // error: geom_traits must be a model of ThickIntersectionIntervalTraits_d or of
  // ThickIntersectionTraits_d.
  CGAL::thick_self_intersection_d(points, report, CGAL::parameters::geom_traits(Kernel()));

  // error: The elements of the range must be of the type Object_d of geom_traits: pass a
  // property map to such objects as point_map.
  CGAL::thick_self_intersection_d(
    points, report, CGAL::parameters::geom_traits(CGAL::Thick_ball_traits_d<Point>(balls)));

  // error: The functors of geom_traits must take its type Object_d, as constant functors.
  CGAL::thick_self_intersection_d(strings, report,
                                  CGAL::parameters::geom_traits(Traits_of_other_objects()));

  // error: The elements of the range must be polylines, polygons or triangle meshes: ranges of
  // Point_2 or Point_3, Polygon_2 or Polygon_with_holes_2, models of FaceListGraph with points in
  // space, or pairs of points and triples of indices. For others, pass a property map to such
  // features as point_map.
  CGAL::thick_feature_self_intersection_d(projected_polygons, report);

  // error: The elements of the range must be polylines, polygons or triangle meshes: ranges of
  // Point_2 or Point_3, Polygon_2 or Polygon_with_holes_2, models of FaceListGraph with points in
  // space, or pairs of points and triples of indices. For others, pass a property map to such
  // features as point_map.
  CGAL::thick_feature_self_intersection_d(boxes, report);

  // error: The elements of the range must be polylines, polygons or triangle meshes: ranges of
  // Point_2 or Point_3, Polygon_2 or Polygon_with_holes_2, models of FaceListGraph with points in
  // space, or pairs of points and triples of indices. For others, pass a property map to such
  // features as point_map.
  CGAL::thick_feature_self_intersection_d(thickened_twice, report);

  // error: The features of the two ranges must have points of one type.
  CGAL::thick_feature_intersection_d(points, points_in_space, report);

  // error: Features in interiors() must be polygons in the plane: points and polylines have no
  // interior, and solids are always closed.
  CGAL::thick_feature_self_intersection_d(CGAL::interiors(polylines_and_polygons), report);

  // error: Features in interiors() must be polygons in the plane: points and polylines have no
  // interior, and solids are always closed.
  CGAL::thick_feature_intersection_d(CGAL::interiors(polygons), CGAL::interiors(points), report);

  // error: Beside interiors(), features must have no radius: one overlaps a polygon iff this is
  // closer than the radius. If all have the same one, pass features and polygons without radii, and
  // bound.open(), to fixed_radius_near_features().
  CGAL::thick_feature_intersection_d(CGAL::interiors(polygons), roads_with_widths, report);

  // error: This function does not take interiors(). Two interiors are within a distance iff the
  // closed objects are closer: pass the ranges, and bound.open().
  CGAL::fixed_radius_near_features(polygons, CGAL::interiors(polygons), bound, report);

  // error: A track must be a range of std::pair<Time, Point>, with a number type and points in the
  // plane or in space. For others, pass a property map to such tracks as point_map.
  CGAL::fixed_radius_near_tracks(points, bound, report);

  // error: A track must be a range of std::pair<Time, Point>, with a number type and points in the
  // plane or in space. For others, pass a property map to such tracks as point_map.
  CGAL::closest_approach(points, points);

  // error: The tracks of the two ranges must have times and points of the same types.
  CGAL::fixed_radius_near_tracks(tracks, tracks_in_space, bound, report);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare number.
  CGAL::fixed_radius_near_tracks(tracks, 1., report);

  // error: The callback must take two boxes, as the iterators give them.
  CGAL::thick_box_self_intersection_d(boxes_with_ids.begin(), boxes_with_ids.end(), [](int) {});

  // error: The domain must be an Iso_rectangle_2 for points in the plane, an Iso_cuboid_3 in
  // space, or a Periodic_lattice_d of this dimension.
  CGAL::periodic_fixed_radius_near_neighbors(points_in_space, square, bound, report_images);

  // error: The domain must be an Iso_rectangle_2 for points in the plane, an Iso_cuboid_3 in
  // space, or a Periodic_lattice_d of this dimension.
  CGAL::periodic_fixed_radius_neighbor_lists(points, 1, bound);

  // error: The domain must be an Iso_rectangle_2 for points in the plane, an Iso_cuboid_3 in
  // space, or a Periodic_lattice_d of this dimension.
  CGAL::periodic_fixed_radius_near_neighbors(points, points_in_space, square, bound,
                                             report_images);

  // error: The elements of the range must be points of a kernel of CGAL: pass a property map to
  // such points as point_map.
  CGAL::periodic_closest_pair(strings, square);

  // error: The callback must take two positions and an offset: (std::size_t i, std::size_t j,
  // std::array<int, d> offset); or, in CGAL::with_elements(), two elements and an offset.
  CGAL::periodic_fixed_radius_near_neighbors(points, square, bound, report);

  // error: The callback must return void, or bool to tell whether the search goes on.
  CGAL::periodic_fixed_radius_near_neighbors(points, square, bound, report_text);
}
