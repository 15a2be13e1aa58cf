// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What each function tells a progress functor: growing values, of which the last one is 1, and no
// value after it was cancelled.

#define BOOST_TEST_MODULE progress
#include "support/point_generators.h"

#include <CGAL/Memory_budget.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/closest_pair.h>
#include <CGAL/external_fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_neighbor_lists.h>
#include <CGAL/periodic_closest_pair.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>
#include <CGAL/thick_mesh_self_intersections.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Segment = Kernel::Segment_2;
using Functor = std::function<bool(double)>;

std::vector<Point> points_of(std::size_t size)
{
  std::vector<Point> points;
  for(const Coordinates& c : uniform_points(2, size, 0, 1, 1))
    points.emplace_back(c[0], c[1]);
  return points;
}

std::vector<Segment> segments_of(std::size_t size, double length)
{
  std::vector<Segment> segments;
  for(const Point& p : points_of(size))
    segments.emplace_back(p, p + Kernel::Vector_2(length, length / 2));
  return segments;
}

// A row of triangles, each of which shares an edge with the next one.
CGAL::Surface_mesh<Point_3> mesh_of(std::size_t size)
{
  CGAL::Surface_mesh<Point_3> mesh;
  auto a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(0, 1, 0));
  for(std::size_t i = 1; i <= size; ++i) {
    const auto c = mesh.add_vertex(Point_3(static_cast<double>(i), static_cast<double>(i % 2), 0));
    if(i % 2 == 1)
      mesh.add_face(a, c, b);
    else
      mesh.add_face(a, b, c);
    a = std::exchange(b, c);
  }
  return mesh;
}

struct Search
{
  std::string name;
  std::function<void(const Functor&)> search;
};

const auto ignore = [](const auto&...) {};

// The searches of so many points, or of as many objects.
std::vector<Search> searches_of(std::size_t size)
{
  const auto points = points_of(size), others = points_of(size / 2 + 1);
  const auto segments = segments_of(size, .01);
  const auto np = [](const Functor& functor) { return CGAL::parameters::callback(functor); };
  const auto near = CGAL::within_distance(.02), nearest = CGAL::within_distance(0.);
  return {
    {"near pairs", [=](const Functor& f) {
       CGAL::fixed_radius_near_neighbors(points, near, ignore, np(f));
     }},
    {"near pairs of two ranges", [=](const Functor& f) {
       CGAL::fixed_radius_near_neighbors(points, others, near, ignore, np(f));
     }},
    {"near objects", [=](const Functor& f) {
       CGAL::fixed_radius_near_neighbors(segments, near, ignore, np(f));
     }},
    {"lists", [=](const Functor& f) { CGAL::fixed_radius_neighbor_lists(points, near, np(f)); }},
    {"closest pair", [=](const Functor& f) { CGAL::closest_pair(points, np(f)); }},
    {"close pair", [=](const Functor& f) { CGAL::find_close_pair(points, nearest, np(f)); }},
    {"objects", [=](const Functor& f) {
       CGAL::thick_self_intersection_d(segments, ignore, np(f));
     }},
    {"objects of two types", [=](const Functor& f) {
       CGAL::thick_intersection_d(segments, points, ignore, np(f));
     }},
    {"long objects", [=](const Functor& f) {
       CGAL::thick_intersection_d(segments_of(size, .9), segments, ignore, np(f));
     }},
    {"features", [=](const Functor& f) {
       std::vector<std::vector<Point>> features;
       for(const Segment& s : segments)
         features.push_back({s.source(), s.target()});
       CGAL::thick_feature_self_intersection_d(features, ignore, np(f));
     }},
    {"mesh", [=](const Functor& f) {
       const auto mesh = mesh_of(size);
       std::vector<std::pair<CGAL::Surface_mesh<Point_3>::Face_index,
                             CGAL::Surface_mesh<Point_3>::Face_index>> pairs;
       CGAL::thick_mesh_self_intersections(mesh, std::back_inserter(pairs), np(f));
     }},
    {"points on disk", [=](const Functor& f) {
       CGAL::external_fixed_radius_near_neighbors(points, near, CGAL::Memory_budget(1 << 26),
                                                  ignore, np(f));
     }}};
}

// The searches in a box that repeats and in a lattice, of a bound that is short beside the periods
// or longer than them.
template <class Domain>
std::vector<Search> periodic_searches_of(std::size_t size, const Domain& domain, double radius)
{
  const auto points = points_of(size), others = points_of(size / 2 + 1);
  const auto np = [](const Functor& functor) { return CGAL::parameters::callback(functor); };
  const auto near = CGAL::within_distance(radius);
  return {
    {"near images", [=](const Functor& f) {
       CGAL::periodic_fixed_radius_near_neighbors(points, domain, near, ignore, np(f));
     }},
    {"near images and a profile", [=](const Functor& f) {
       CGAL::Scene_profile profile;
       CGAL::periodic_fixed_radius_near_neighbors(points, domain, near, ignore, profile, np(f));
     }},
    {"near images of two ranges", [=](const Functor& f) {
       CGAL::periodic_fixed_radius_near_neighbors(points, others, domain, near, ignore, np(f));
     }},
    {"lists of images", [=](const Functor& f) {
       CGAL::periodic_fixed_radius_neighbor_lists(points, domain, near, np(f));
     }},
    {"closest images", [=](const Functor& f) {
       CGAL::periodic_closest_pair(points, domain, np(f));
     }}};
}

void check(const std::vector<Search>& searches)
{
  for(const Search& search : searches)
    BOOST_TEST_CONTEXT(search.name)
    {
      std::vector<double> told;
      search.search([&](double done) {
        told.push_back(done);
        return true;
      });
      BOOST_REQUIRE(!told.empty());
      BOOST_CHECK(std::is_sorted(told.begin(), told.end()));
      BOOST_CHECK_EQUAL(told.back(), 1);
      const std::size_t all = told.size();
      for(const std::size_t last : {std::size_t(1), all / 2 + 1, all}) {
        std::size_t calls = 0;
        search.search([&](double) { return ++calls != last; });
        BOOST_CHECK_EQUAL(calls, last);
      }
    }
}

BOOST_AUTO_TEST_CASE(progress_of_few_ends_at_1) { check(searches_of(20)); }
BOOST_AUTO_TEST_CASE(progress_of_many_ends_at_1) { check(searches_of(3000)); }

BOOST_AUTO_TEST_CASE(progress_of_images_ends_at_1)
{
  const Kernel::Iso_rectangle_2 box(0, 0, 1, 1);
  for(const double radius : {.01, 1.5}) {
    check(periodic_searches_of(200, box, radius));
    check(periodic_searches_of(200, CGAL::Periodic_lattice_d(box), radius));
  }
}

// The closest pair is across the boundary, or within it.
BOOST_AUTO_TEST_CASE(progress_of_the_closest_images_ends_at_1)
{
  const Kernel::Iso_rectangle_2 box(0, 0, 1, 1);
  for(const double x : {.9375, .125}) {
    const std::vector<Point> points = {{.0625, .5}, {x, .5}};
    check({{"two points", [&](const Functor& f) {
              CGAL::periodic_closest_pair(points, box, CGAL::parameters::callback(f));
            }}});
  }
}
