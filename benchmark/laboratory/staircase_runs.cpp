// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The wrong pairs of whole algorithms against the precision of their number type: all pairs, the
// recursive route on the predicates of [V03] evaluated in rounded numbers, a rounded Delaunay
// triangulation that is searched exactly, and this package. Besides, the wrong edges of that
// triangulation.
//
//   staircase_runs <folder for staircase_runs.csv>

#include "paper_traits.h"
#include "staircase.h"
#include "wrong_pairs.h"

#include "measuring/Csv_file.h"
#include "methods/all_pairs.h"
#include "methods/delaunay.h"

#include "support/brute_force.h"
#include "support/kernels.h"

#include <CGAL/Simple_cartesian.h>

namespace {

using namespace lab;
using test_support::Random;

template <unsigned Digits>
using Kernel = CGAL::Simple_cartesian<test_support::Mpfr_number<Digits>>;

template <class Kernel>
Found by_all_pairs(const Scene& scene)
{
  const auto points = make_points<Kernel, 2>(scene);
  const typename Paper_point_traits<typename Kernel::Point_2, 2>::Do_intersect_d is_near{
    typename Kernel::FT(scene.r)};
  Found found;
  all_pairs(
    points.size(),
    [&](std::size_t i, std::size_t j) { return is_near(points[i], points[j]); }, found);
  return found;
}

template <class Kernel>
Found by_paper_traits(const Scene& scene)
{
  using Traits = Paper_point_traits<typename Kernel::Point_2, 2>;
  Found found;
  CGAL::thick_self_intersection_d(
    make_points<Kernel, 2>(scene), found,
    CGAL::parameters::geom_traits(Traits(typename Kernel::FT(scene.r))));
  return found;
}

// A triangulation that rounded predicates built, searched exactly.
template <class Kernel>
Found by_delaunay(const Scene& scene)
{
  const test_support::Exact_points exact = exact_points(scene);
  const auto is_near = [&](std::size_t i, std::size_t j) { return exact.are_within_radius(i, j); };
  Found found;
  delaunay_search<Kernel>(make_points<Kernel, 2>(scene), is_near, found);
  return found;
}

// The edges of the same triangulation that are not Delaunay: the circle through the three corners
// on one side contains the fourth corner, or the three are not in counterclockwise order.
template <class Kernel>
Found wrong_edges(const Scene& scene)
{
  Found wrong;
  const auto triangulation = triangulate<Kernel>(make_points<Kernel, 2>(scene));
  const auto corner = [&](const auto& face, int i) {
    const double* c = scene.point(face->vertex(i)->info());
    return std::array<Exact_integer, 2>{Exact_integer(c[0]), Exact_integer(c[1])};
  };
  for(const auto& [face, i] : triangulation.finite_edges()) {
    const auto [other, j] = triangulation.mirror_edge({face, i});
    if(triangulation.is_infinite(face) || triangulation.is_infinite(other))
      continue;
    const auto p = corner(face, 0), q = corner(face, 1), r = corner(face, 2), s = corner(other, j);
    if(CGAL::orientationC2(p[0], p[1], q[0], q[1], r[0], r[1]) != CGAL::LEFT_TURN
       || CGAL::side_of_oriented_circleC2(p[0], p[1], q[0], q[1], r[0], r[1], s[0], s[1])
            == CGAL::ON_POSITIVE_SIDE)
      wrong(face->vertex(triangulation.cw(i))->info(), face->vertex(triangulation.ccw(i))->info());
  }
  return wrong;
}

template <class Kernel>
Found by_package(const Scene& scene)
{
  Found found;
  CGAL::fixed_radius_near_neighbors(
    make_points<Kernel, 2>(scene), CGAL::within_distance(typename Kernel::FT(scene.r)), found);
  return found;
}

Scene shuffled_scene(const test_support::Points& points, double r, int seed)
{
  return scene_of("", test_support::shuffled(points, static_cast<std::uint64_t>(seed)), r, 2);
}

// Distinct points on a lattice of step h, some of them one unit off it, and 5 h as the radius: ties
// off the axes, near misses, and four points on a circle everywhere.
Scene near_degenerate_scene(int bits)
{
  Random random(bits);
  const double step = std::ldexp(1., bits - 5) - 1;
  test_support::Points points;
  for(int i = 0; i < 24; ++i)
    for(int j = 0; j < 24; ++j) {
      const double off = static_cast<double>(random.below(4) == 0);
      points.push_back({i * step + off, j * step});
    }
  return shuffled_scene(points, 5 * step, bits);
}

// Points on a circle, a third of them moved inwards or outwards by one unit; r makes no ties.
Scene circle_scene(int bits)
{
  Random random(bits + 200);
  const std::int64_t range = std::int64_t(1) << bits;
  test_support::Points points;
  for(const Place_2& p : lattice_circle(range)) {
    const double off = static_cast<double>(random.below(6)) - 1;
    points.push_back({static_cast<double>(p[0]) + (off > 1 ? 0 : off), static_cast<double>(p[1])});
  }
  return shuffled_scene(points, static_cast<double>(range / 8), bits);
}

Scene random_scene(int bits)
{
  Random random(bits + 100);
  const double range = std::ldexp(1., bits);
  test_support::Points points;
  for(int i = 0; i < 576; ++i)
    points.push_back({range * random.fixed_point(bits), range * random.fixed_point(bits)});
  return scene_of("", points, 5 * range / 32, 2);
}

// The runs on one scene.
class Scene_runs
{
public:
  Scene_runs(const Scene& scene, int input_bits, const std::string& set, Csv_file& csv)
    : scene_(scene),
      truth_(test_support::brute_force(points_of(scene), radius_of(scene)).pairs),
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
    const int precision = bits_of<Digits>();
    run("all pairs", 2, precision, truth_, by_all_pairs<K>);
    run("[V03] in rounded numbers", 2, precision, truth_, by_paper_traits<K>);
    run("rounded Delaunay, searched exactly", 4, precision, truth_, by_delaunay<K>);
    run("wrong edges of the rounded Delaunay", 4, precision, {}, wrong_edges<K>);
    run("this package", 2, precision, truth_, by_package<K>);
  }

  void run(const char* name, int degree, int precision, const Pairs& expected,
           Found (*method)(const Scene&))
  {
    const auto result = run_in_child(20, [&] { return reported(method(scene_)); });
    const test_support::Pairs_difference wrong = test_support::compare(expected, result.values);
    csv_.row(name, degree, input_bits_, set_, precision, truth_.size(), wrong.missing.size(),
             wrong.extra.size(), result.status);
  }

  const Scene scene_;
  const Pairs truth_;
  const int input_bits_;
  const std::string set_;
  Csv_file& csv_;
};

} // namespace

int main(int, char** arguments)
{
  Csv_file csv(arguments[1], "staircase_runs.csv",
               "all pairs in GMP integers (test/support/brute_force.h, brute_force)",
               "algorithm,degree,input_bits,set,precision,true_pairs,missing,extra,status");
  for(int bits : {10, 16, 24}) {
    const auto run = [&](const Scene& scene, const char* set) {
      Scene_runs(scene, bits, set, csv).with_precisions<3, 5, 7, 9, 12, 14, 16, 20, 24, 29>();
    };
    run(near_degenerate_scene(bits), "near a lattice");
    run(circle_scene(bits), "near a circle");
    run(random_scene(bits), "random");
  }
}
