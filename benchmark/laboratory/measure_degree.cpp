// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Runs algorithms on numbers that measure algebraic degree, and writes, for each call site, the
// highest degree whose sign was taken and the bits of the longest number computed, for integer
// input of 8, 16 and 24 bits.
//
//   measure_degree <folder for degree.csv>

#include "object_makers.h"
#include "paper_traits.h"

#include "support/degree_traits.h"

#include "measuring/Csv_file.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/Thick_object_traits_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_tracks.h>
#include <CGAL/interiors.h>
#include <CGAL/intersections.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <array>
#include <functional>
#include <iostream>

namespace CGAL {
namespace Box_intersection_d {

template <>
struct box_limits<test_support::Degree_number>
{
  static test_support::Degree_number inf() { return -sup(); }
  static test_support::Degree_number sup() { return max_side; }
  static inline double max_side = 0; // beyond all sides of boxes, with no more bits than needed
};

} // namespace Box_intersection_d
} // namespace CGAL

namespace {

using namespace lab;
using namespace test_support;
using thick_benchmark::Csv_file;
using Kernel = Degree_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;

constexpr std::size_t n = 200;

const auto ignore_pair = [](std::size_t, std::size_t) {};

// Points on a lattice of 2^(bits - 5), so that 5 steps of it make ties.
Degree_number radius(int bits) { return Degree_number::input(5 * std::ldexp(1., bits - 5)); }

// Delaunay triangulations ask their traits for these predicates.
struct Delaunay_traits_2 : Kernel
{
  using Orientation_2 = Predicate_at_site<Kernel::Orientation_2>;
  using Side_of_oriented_circle_2 = Predicate_at_site<Kernel::Side_of_oriented_circle_2>;

  Orientation_2 orientation_2_object() const
  {
    return {Kernel::orientation_2_object(), "Orientation_2"};
  }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const
  {
    return {Kernel::side_of_oriented_circle_2_object(), "Side_of_oriented_circle_2"};
  }
};

// In space there is one more, for points on a common plane and circle.
struct Delaunay_traits_3 : Kernel
{
  using Coplanar_side_of_bounded_circle_3
    = Predicate_at_site<Kernel::Coplanar_side_of_bounded_circle_3>;
  using Orientation_3 = Predicate_at_site<Kernel::Orientation_3>;
  using Side_of_oriented_sphere_3 = Predicate_at_site<Kernel::Side_of_oriented_sphere_3>;

  Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const
  {
    return {Kernel::coplanar_side_of_bounded_circle_3_object(),
            "Coplanar_side_of_bounded_circle_3"};
  }
  Orientation_3 orientation_3_object() const
  {
    return {Kernel::orientation_3_object(), "Orientation_3"};
  }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const
  {
    return {Kernel::side_of_oriented_sphere_3_object(), "Side_of_oriented_sphere_3"};
  }
};

template <class Point, int Dimension>
void run_near_neighbors(int bits)
{
  const auto points = degree_points<Point, Dimension>(n, bits, 1);
  CGAL::Scene_profile profile; // otherwise integers decide what the filter leaves
  profile.force_tier(CGAL::Arithmetic_tier::FILTERED_EXACT);
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(radius(bits)), ignore_pair,
                                    profile);
}

template <class Objects, class Traits>
void run_traits(const Objects& objects, const Traits& traits)
{
  CGAL::thick_self_intersection_d(
    objects, ignore_pair, CGAL::parameters::geom_traits(Traits_with_sites<Traits>(traits)));
}

template <class Point, int Dimension>
void run_point_traits(int bits)
{
  const auto points = degree_points<Point, Dimension>(n, bits, 1);
  run_traits(points, CGAL::Thick_point_traits_d<Point>(CGAL::within_distance(radius(bits))));
}

template <class Point, int Dimension>
void run_paper_traits(int bits)
{
  const auto points = degree_points<Point, Dimension>(n, bits, 1);
  run_traits(points, Paper_point_traits<Point, Dimension>(radius(bits)));
}

template <class Point, int Dimension>
std::vector<std::pair<Point, Degree_number>> degree_balls(int bits)
{
  std::vector<std::pair<Point, Degree_number>> balls;
  for(const Point& p : degree_points<Point, Dimension>(n, bits, 1))
    balls.emplace_back(p, Degree_number::input(std::ldexp(1. + balls.size() % 4, bits - 5)));
  return balls;
}

template <class Point, int Dimension>
void run_ball_traits(int bits)
{
  const auto balls = degree_balls<Point, Dimension>(bits);
  run_traits(balls, CGAL::Thick_ball_traits_d<Point>(balls));
}

template <class Sphere, class Point, int Dimension>
void run_squared_radii(int bits)
{
  std::vector<Sphere> spheres;
  for(const auto& [centre, r] : degree_balls<Point, Dimension>(bits))
    spheres.emplace_back(centre, r * r);
  run_traits(spheres, Squared_radius_traits<Sphere, Dimension>(
                        Degree_number::input(std::ldexp(8., bits - 5))));
}

// Objects of which many touch.
template <class Maker>
auto degree_objects(int bits)
{
  using Point = decltype(Maker::template point<Kernel>(std::vector<Degree_number>(3), 0));
  const auto points
    = degree_points<Point, Maker::dimension>(Maker::points * n / 2, bits, Maker::points);
  std::vector<decltype(Maker::template make<Kernel>(std::vector<Degree_number>(12)))> objects;
  for(std::size_t i = 0; i < points.size(); i += Maker::points) {
    std::vector<Degree_number> c;
    for(std::size_t k = i; k < i + Maker::points; ++k)
      for(int axis = 0; axis < Maker::dimension; ++axis)
        c.push_back(points[k].cartesian(axis));
    objects.push_back(Maker::template make<Kernel>(c));
  }
  return objects;
}

template <class Objects, class Predicate>
void ask_about_all_pairs(const Objects& objects, const Predicate& do_intersect)
{
  for(const auto& a : objects)
    for(const auto& b : objects)
      do_intersect(a, b);
}

// Their boxes are boxes of doubles, which know nothing about hidden coordinates: all boxes meet.
template <class Maker>
void run_object_traits(int bits)
{
  const auto objects = degree_objects<Maker>(bits);
  using Object = typename decltype(objects)::value_type;
  const CGAL::Thick_object_traits_d<Object> traits(objects);
  ask_about_all_pairs(objects, traits.do_intersect_d_object());
}

// With a radius each.
template <class Maker>
void run_thickened(int bits)
{
  const auto objects = degree_objects<Maker>(bits);
  std::vector<std::pair<std::decay_t<decltype(objects[0])>, Degree_number>> thickened;
  for(const auto& object : objects)
    thickened.emplace_back(
      object, Degree_number::input(std::ldexp(1. + thickened.size() % 3, bits - 5)));
  const CGAL::Thick_object_traits_d<typename decltype(thickened)::value_type> traits(thickened);
  ask_about_all_pairs(thickened, traits.do_intersect_d_object());
}

template <class Maker>
void run_interiors(int bits)
{
  CGAL::thick_self_intersection_d(CGAL::interiors(degree_objects<Maker>(bits)), ignore_pair);
}

// Polygons of four vertices, many of which cross themselves.
void run_polygons(int bits)
{
  const auto points = degree_points<Point_2, 2>(n, bits, 1);
  std::vector<CGAL::Polygon_2<Kernel>> polygons;
  for(std::size_t i = 0; i < points.size(); i += 4)
    polygons.emplace_back(points.begin() + i, points.begin() + i + 4);
  CGAL::thick_feature_self_intersection_d(CGAL::interiors(polygons), ignore_pair);
}

// Tetrahedra by their four faces, and points, which are in few of the faces.
void run_solids(int bits)
{
  using Soup = std::pair<std::vector<Point_3>, std::vector<std::array<int, 3>>>;
  const auto points = degree_points<Point_3, 3>(n, bits, 1);
  std::vector<Soup> solids;
  for(std::size_t i = 0; i < points.size(); i += 4)
    solids.push_back({{points.begin() + i, points.begin() + i + 4},
                      {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}});
  const Call_site site("two solids");
  CGAL::thick_feature_self_intersection_d(solids, ignore_pair);
  const Call_site site_of_points("a point and a solid");
  CGAL::thick_feature_intersection_d(degree_points<Point_3, 3>(n, bits, 2), solids, ignore_pair);
}

// Tracks of one leg each, during the same time or times of their own.
template <class Point, int Dimension, bool HaveCommonTimes>
void run_tracks(int bits)
{
  const auto points = degree_points<Point, Dimension>(n, bits, 1);
  const auto times = degree_points<Point_2, 2>(n / 2, bits, 2);
  std::vector<std::vector<std::pair<Degree_number, Point>>> tracks;
  for(std::size_t i = 0; i < times.size(); ++i) {
    const Degree_number& begin = times[HaveCommonTimes ? 0 : i].x();
    const Degree_number end = begin + Degree_number::input(std::ldexp(1., bits - 2));
    tracks.push_back({{begin, points[2 * i]}, {end, points[2 * i + 1]}});
  }
  CGAL::fixed_radius_near_tracks(tracks, CGAL::within_distance(radius(bits)), ignore_pair);
}

template <class Maker>
void run_do_intersect(int bits)
{
  ask_about_all_pairs(degree_objects<Maker>(bits),
                      [](const auto& a, const auto& b) { return CGAL::do_intersect(a, b); });
}

template <class Delaunay, class Point, int Dimension>
void run_delaunay(int bits)
{
  const auto points = degree_points<Point, Dimension>(n, bits, 1);
  const Delaunay triangulation(points.begin(), points.end());
}

void run_boxes(int bits)
{
  using Box = CGAL::Box_intersection_d::Box_d<Degree_number, 2,
                                              CGAL::Box_intersection_d::ID_EXPLICIT>;
  std::vector<Box> boxes;
  for(const Point_2& p : degree_points<Point_2, 2>(n, bits, 1)) {
    Degree_number low[] = {p.x(), p.y()};
    Degree_number high[] = {p.x() + radius(bits), p.y() + radius(bits)};
    boxes.emplace_back(low, high);
  }
  CGAL::Box_intersection_d::box_limits<Degree_number>::max_side = std::ldexp(1., bits + 1);
  const Call_site site("comparisons of box sides");
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [](const Box&, const Box&) {});
}

struct Algorithm
{
  std::string name;
  bool hides_doubles; // so that exact numbers decide everything
  std::function<void(int)> run;
};

std::vector<Algorithm> algorithms()
{
  return {
    {"fixed_radius_near_neighbors 2D", true, run_near_neighbors<Point_2, 2>},
    {"fixed_radius_near_neighbors 3D", true, run_near_neighbors<Point_3, 3>},
    {"fixed_radius_near_neighbors 2D, filter first", false, run_near_neighbors<Point_2, 2>},
    {"fixed_radius_near_neighbors 3D, filter first", false, run_near_neighbors<Point_3, 3>},
    {"Thick_point_traits_d 2D", true, run_point_traits<Point_2, 2>},
    {"Thick_point_traits_d 3D", true, run_point_traits<Point_3, 3>},
    {"predicates of [V03] as written 2D", false, run_paper_traits<Point_2, 2>},
    {"predicates of [V03] as written 3D", false, run_paper_traits<Point_3, 3>},
    {"Thick_ball_traits_d 2D", true, run_ball_traits<Point_2, 2>},
    {"Thick_ball_traits_d 3D", true, run_ball_traits<Point_3, 3>},
    {"disks stored by squared radius", false, run_squared_radii<Kernel::Circle_2, Point_2, 2>},
    {"balls stored by squared radius", false, run_squared_radii<Kernel::Sphere_3, Point_3, 3>},
    {"Thick_object_traits_d<Segment_2>", true, run_object_traits<Segments_2>},
    {"Thick_object_traits_d<Triangle_2>", true, run_object_traits<Triangles_2>},
    {"Thick_object_traits_d<Iso_rectangle_2>", true, run_object_traits<Rectangles_2>},
    {"Thick_object_traits_d<Segment_3>", true, run_object_traits<Segments_3>},
    {"Thick_object_traits_d<Triangle_3>", true, run_object_traits<Triangles_3>},
    {"Thick_object_traits_d<Tetrahedron_3>", true, run_object_traits<Tetrahedra_3>},
    {"Thick_object_traits_d<Iso_cuboid_3>", true, run_object_traits<Cuboids_3>},
    {"segments with radii 2D", true, run_thickened<Segments_2>},
    {"segments with radii 3D", true, run_thickened<Segments_3>},
    {"interiors(Triangle_2)", true, run_interiors<Triangles_2>},
    {"interiors(Tetrahedron_3)", true, run_interiors<Tetrahedra_3>},
    {"interiors(Polygon_2)", true, run_polygons},
    {"solids", true, run_solids},
    {"legs of common times 2D", true, run_tracks<Point_2, 2, true>},
    {"legs of common times 3D", true, run_tracks<Point_3, 3, true>},
    {"legs 2D", true, run_tracks<Point_2, 2, false>},
    {"legs 3D", true, run_tracks<Point_3, 3, false>},
    {"do_intersect(Segment_2, Segment_2)", false, run_do_intersect<Segments_2>},
    {"do_intersect(Triangle_2, Triangle_2)", false, run_do_intersect<Triangles_2>},
    {"do_intersect(Segment_3, Segment_3)", false, run_do_intersect<Segments_3>},
    {"do_intersect(Triangle_3, Triangle_3)", false, run_do_intersect<Triangles_3>},
    {"do_intersect(Tetrahedron_3, Tetrahedron_3)", false, run_do_intersect<Tetrahedra_3>},
    {"Delaunay_triangulation_2", false,
     run_delaunay<CGAL::Delaunay_triangulation_2<Delaunay_traits_2>, Point_2, 2>},
    {"Delaunay_triangulation_3", false,
     run_delaunay<CGAL::Delaunay_triangulation_3<Delaunay_traits_3>, Point_3, 3>},
    {"box_self_intersection_d 2D", false, run_boxes},
  };
}

void measure(const Algorithm& algorithm, int bits, Csv_file& csv)
{
  Degree_record& record = Degree_record::get();
  record.restart(algorithm.hides_doubles);
  algorithm.run(bits);
  const auto write = [&](const std::string& site, const Degree_tally& tally) {
    std::uint64_t signs = 0;
    for(std::uint64_t count : tally.signs)
      signs += count;
    csv.row(algorithm.name, site, bits, tally.degree(), signs, tally.signs[tally.degree()],
            tally.bits, tally.degree_in_doubles);
  };
  write("all", record.total());
  for(const auto& [site, tally] : record.tallies())
    if(!site.empty())
      write(site, tally);
  std::cout << algorithm.name << ", " << bits << " bits: degree " << record.total().degree()
            << '\n';
}

} // namespace

int main(int, char** arguments)
{
  Csv_file csv(arguments[1], "degree.csv",
               "each sign is that of a rational number, computed without error (Degree_number.h)",
               "algorithm,call_site,input_bits,degree,signs,signs_of_that_degree,"
               "longest_number_bits,degree_in_doubles");
  for(const Algorithm& algorithm : algorithms())
    for(int bits : {8, 16, 24})
      measure(algorithm, bits, csv);
}
