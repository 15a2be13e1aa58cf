// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The wrong pairs of whole algorithms against the precision of their number type: all pairs, the
// book route on the predicates of [V03] evaluated in rounded numbers, a rounded Delaunay
// triangulation that is searched exactly, and this package. Besides, the wrong edges of that
// triangulation.
//
//   staircase_runs <folder for staircase_runs.csv>

#include "measuring/Csv_file.h"
#include "paper_traits.h"
#include "run_in_child.h"
#include "staircase.h"

#include "support/brute_force.h"
#include "support/kernels.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <iostream>

namespace {

using namespace test_support;

template <unsigned Digits>
using Kernel = CGAL::Simple_cartesian<Mpfr_number<Digits>>;

template <class Kernel>
std::vector<typename Kernel::Point_2> rounded(const Points& points)
{
  return make_points<Cartesian_points<Kernel, 2>>(points);
}

template <class Kernel>
Pairs all_pairs(const Point_scene& scene)
{
  const auto points = rounded<Kernel>(scene.points);
  const typename lab::Paper_point_traits<typename Kernel::Point_2, 2>::Do_intersect_d is_near{
    typename Kernel::FT(*scene.radius.length())};
  Pairs pairs;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = i + 1; j < points.size(); ++j)
      if(is_near(points[i], points[j]))
        pairs.emplace_back(i, j);
  return pairs;
}

template <class Kernel>
Pairs book_route(const Point_scene& scene)
{
  using Traits = lab::Paper_point_traits<typename Kernel::Point_2, 2>;
  Pairs pairs;
  CGAL::thick_self_intersection_d(
    rounded<Kernel>(scene.points),
    [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); },
    CGAL::parameters::geom_traits(Traits(typename Kernel::FT(*scene.radius.length()))));
  return pairs;
}

template <class Kernel>
using Triangulation = CGAL::Delaunay_triangulation_2<
  Kernel, CGAL::Triangulation_data_structure_2<
            CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>>>;

template <class Kernel>
Triangulation<Kernel> triangulate(const Points& points)
{
  std::vector<std::pair<typename Kernel::Point_2, std::size_t>> vertices;
  for(const auto& p : rounded<Kernel>(points))
    vertices.emplace_back(p, vertices.size());
  return Triangulation<Kernel>(vertices.begin(), vertices.end());
}

// From each vertex of a triangulation that rounded predicates built, a walk along its edges as long
// as exact distances are within the radius. [Dickerson and Eppstein 1996]
template <class Kernel>
Pairs delaunay(const Point_scene& scene)
{
  const std::size_t n = scene.points.size();
  std::vector<std::vector<std::size_t>> neighbours(n);
  const Triangulation<Kernel> triangulation = triangulate<Kernel>(scene.points);
  for(const auto& edge : triangulation.finite_edges()) {
    const std::size_t u = edge.first->vertex(triangulation.cw(edge.second))->info();
    const std::size_t v = edge.first->vertex(triangulation.ccw(edge.second))->info();
    neighbours[u].push_back(v);
    neighbours[v].push_back(u);
  }

  const Exact_points exact(scene.points, scene.radius);
  Pairs pairs;
  for(std::size_t source = 0; source < n; ++source) {
    std::vector<std::size_t> reached(1, source);
    std::vector<bool> is_seen(n);
    is_seen[source] = true;
    for(std::size_t next = 0; next < reached.size(); ++next)
      for(std::size_t v : neighbours[reached[next]])
        if(!is_seen[v]) {
          is_seen[v] = true;
          if(exact.are_within_radius(source, v))
            reached.push_back(v);
        }
    for(std::size_t v : reached)
      if(source < v)
        pairs.emplace_back(source, v);
  }
  return pairs;
}

// The edges of the same triangulation that are not Delaunay: the circle through the three corners
// on one side contains the fourth corner, or the three are not in counterclockwise order.
template <class Kernel>
Pairs wrong_edges(const Point_scene& scene)
{
  Pairs wrong;
  const Triangulation<Kernel> triangulation = triangulate<Kernel>(scene.points);
  const auto corner = [&](const auto& face, int i) {
    const Coordinates& c = scene.points[face->vertex(i)->info()];
    return std::array<lab::Exact_integer, 2>{lab::Exact_integer(c[0]), lab::Exact_integer(c[1])};
  };
  for(const auto& [face, i] : triangulation.finite_edges()) {
    const auto [other, j] = triangulation.mirror_edge({face, i});
    if(triangulation.is_infinite(face) || triangulation.is_infinite(other))
      continue;
    const auto p = corner(face, 0), q = corner(face, 1), r = corner(face, 2), s = corner(other, j);
    if(CGAL::orientationC2(p[0], p[1], q[0], q[1], r[0], r[1]) != CGAL::LEFT_TURN
       || CGAL::side_of_oriented_circleC2(p[0], p[1], q[0], q[1], r[0], r[1], s[0], s[1])
            == CGAL::ON_POSITIVE_SIDE)
      wrong.emplace_back(face->vertex(triangulation.cw(i))->info(),
                         face->vertex(triangulation.ccw(i))->info());
  }
  return wrong;
}

template <class Kernel>
Pairs this_package(const Point_scene& scene)
{
  using FT = typename Kernel::FT;
  return near_pairs(rounded<Kernel>(scene.points),
                    CGAL::within_distance(FT(*scene.radius.length())));
}

// Distinct points on a lattice of step h, some of them one unit off it, and 5 h as the radius: ties
// off the axes, near misses, and four points on a circle everywhere.
Point_scene near_degenerate_scene(int bits)
{
  Random random(bits);
  const double step = std::ldexp(1., bits - 5) - 1;
  Points points;
  for(int i = 0; i < 24; ++i)
    for(int j = 0; j < 24; ++j) {
      const double off = static_cast<double>(random.below(4) == 0);
      points.push_back({i * step + off, j * step});
    }
  return {"", 2, shuffled(points, bits), Radius::of_length(5 * step), std::nullopt};
}

// Points on a circle, a third of them moved inwards or outwards by one unit; r makes no ties.
Point_scene circle_scene(int bits)
{
  Random random(bits + 200);
  const std::int64_t range = std::int64_t(1) << bits;
  Points points;
  for(const lab::Place_2& p : lab::lattice_circle(range)) {
    const double off = static_cast<double>(random.below(6)) - 1;
    points.push_back({static_cast<double>(p[0]) + (off > 1 ? 0 : off), static_cast<double>(p[1])});
  }
  return {"", 2, shuffled(points, bits), Radius::of_length(static_cast<double>(range / 8)),
          std::nullopt};
}

Point_scene random_scene(int bits)
{
  Random random(bits + 100);
  const double range = std::ldexp(1., bits);
  Points points;
  for(int i = 0; i < 576; ++i)
    points.push_back({range * random.fixed_point(bits), range * random.fixed_point(bits)});
  return {"", 2, points, Radius::of_length(5 * range / 32), std::nullopt};
}

// The runs on one scene.
class Scene_runs
{
public:
  Scene_runs(const Point_scene& scene, int input_bits, const std::string& set, lab::Csv_file& csv)
    : scene_(scene), truth_(brute_force(scene.points, scene.radius).pairs),
      input_bits_(input_bits), set_(set), csv_(csv)
  {}

  template <unsigned... Digits>
  void with_precisions()
  {
    (with_precision<Digits>(), ...);
  }

private:
  template <unsigned Digits>
  void with_precision()
  {
    using K = Kernel<Digits>;
    const int precision = lab::bits_of<Digits>();
    run("all pairs", 2, precision, truth_, all_pairs<K>);
    run("[V03] in rounded numbers", 2, precision, truth_, book_route<K>);
    run("rounded Delaunay, searched exactly", 4, precision, truth_, delaunay<K>);
    run("wrong edges of the rounded Delaunay", 4, precision, {}, wrong_edges<K>);
    run("this package", 2, precision, truth_, this_package<K>);
  }

  void run(const char* name, int degree, int precision, const Pairs& expected,
           Pairs (*method)(const Point_scene&))
  {
    const auto result = lab::run_in_child(20, [&] { return method(scene_); });
    const Pairs_difference wrong = compare(expected, result.values);
    csv_.row(name, degree, input_bits_, set_, precision, truth_.size(), wrong.missing.size(),
             wrong.extra.size(), result.status);
  }

  const Point_scene scene_;
  const Pairs truth_;
  const int input_bits_;
  const std::string set_;
  lab::Csv_file& csv_;
};

} // namespace

int main(int, char** arguments)
{
  lab::Csv_file csv(std::string(arguments[1]) + "/staircase_runs.csv",
                    "all pairs in GMP integers (test/support/brute_force.h, brute_force)",
                    "algorithm,degree,input_bits,set,precision,true_pairs,missing,extra,status");
  for(int bits : {10, 16, 24}) {
    const auto run = [&](const Point_scene& scene, const char* set) {
      Scene_runs(scene, bits, set, csv).with_precisions<3, 5, 7, 9, 12, 14, 16, 20, 24, 29>();
    };
    run(near_degenerate_scene(bits), "near a lattice");
    run(circle_scene(bits), "near a circle");
    run(random_scene(bits), "random");
  }
}
