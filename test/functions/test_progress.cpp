// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What each function tells a progress functor: growing values, of which the last one is 1, and no
// value after it was cancelled.

#include "support/searches.h"
#include "support/unit_test.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/closest_pair.h>
#include <CGAL/external_fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_neighbor_lists.h>
#include <CGAL/periodic_closest_pair.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>
#include <CGAL/thick_mesh_self_intersections.h>

using namespace test_support;

using Kernel = Searched_kernel;
using Point = Kernel::Point_2;
using Point_3 = Kernel::Point_3;

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

const auto ignore = [](const auto&...) {};

// A search by run(np) with a functor of progress, whose pairs are ignored.
template <class Run>
Search watched(const std::string& name, const Run& run)
{
  return {name, [=](const On_pair&, const On_progress& on_progress) {
    run(CGAL::parameters::callback(on_progress));
    return true;
  }};
}

// The searches of so many points, or of as many objects, those without a callback of pairs as well.
std::vector<Search> searches_of(std::size_t size)
{
  const auto points = searched_points<2>(size);
  const auto near = CGAL::within_distance(.02), nearest = CGAL::within_distance(0.);
  std::vector<Search> searches = pair_searches<CGAL::Sequential_tag>(size);
  for(const Search& search : {
        watched("lists", [=](auto np) { CGAL::fixed_radius_neighbor_lists(points, near, np); }),
        watched("closest pair", [=](auto np) { CGAL::closest_pair(points, np); }),
        watched("close pair", [=](auto np) { CGAL::find_close_pair(points, nearest, np); }),
        watched("mesh", [=](auto np) {
          using Face = CGAL::Surface_mesh<Point_3>::Face_index;
          std::vector<std::pair<Face, Face>> pairs;
          CGAL::thick_mesh_self_intersections(mesh_of(size), std::back_inserter(pairs), np);
        }),
        watched("points on disk", [=](auto np) {
          const CGAL::Memory_budget budget(1 << 26);
          CGAL::external_fixed_radius_near_neighbors(points, near, budget, ignore, np);
        })})
    searches.push_back(search);
  return searches;
}

// The searches in a box that repeats and in a lattice, of a bound that is short beside the periods
// or longer than them.
template <class Domain>
std::vector<Search> periodic_searches_of(std::size_t size, const Domain& domain, double radius)
{
  const auto points = searched_points<2>(size), others = searched_points<2>(size / 2 + 1);
  const auto near = CGAL::within_distance(radius);
  return {
    watched("near images", [=](auto np) {
      CGAL::periodic_fixed_radius_near_neighbors(points, domain, near, ignore, np);
    }),
    watched("near images and a profile", [=](auto np) {
      CGAL::Scene_profile profile;
      CGAL::periodic_fixed_radius_near_neighbors(points, domain, near, ignore, profile, np);
    }),
    watched("near images of two ranges", [=](auto np) {
      CGAL::periodic_fixed_radius_near_neighbors(points, others, domain, near, ignore, np);
    }),
    watched("lists of images", [=](auto np) {
      CGAL::periodic_fixed_radius_neighbor_lists(points, domain, near, np);
    }),
    watched("closest images", [=](auto np) { CGAL::periodic_closest_pair(points, domain, np); })};
}

struct Failure
{};

// Another run by threads may tell less.
void check(const std::vector<Search>& searches, std::size_t least_tells = 1,
           bool is_parallel = false)
{
  const On_pair go_on = [](std::size_t, std::size_t) { return true; };
  for(const Search& search : searches)
    BOOST_TEST_CONTEXT(search.name)
    {
      std::vector<double> told;
      search.run(go_on, [&](double done) {
        told.push_back(done);
        return true;
      });
      BOOST_REQUIRE(!told.empty());
      BOOST_CHECK(std::is_sorted(told.begin(), told.end()));
      BOOST_CHECK_GE(told.front(), 0);
      BOOST_CHECK_EQUAL(std::count(told.begin(), told.end(), 1.), 1);
      BOOST_CHECK_EQUAL(told.back(), 1);
      BOOST_CHECK_GE(told.size(), least_tells);
      BOOST_CHECK_LE(told.size(), 1001u);
      const std::size_t all = is_parallel ? 1 : told.size();
      for(const std::size_t last : {std::size_t(1), all / 2 + 1, all}) {
        std::size_t calls = 0;
        search.run(go_on, [&](double) { return ++calls != last; });
        BOOST_CHECK_EQUAL(calls, last);
      }
      BOOST_CHECK_THROW(search.run(go_on, [](double) -> bool { throw Failure(); }), Failure);
    }
}

// Whatever is cancelled when, closest_pair() returns a pair that is no farther than the first two
// points, and find_close_pair() a close one or none.
template <class Tag>
std::vector<Search> closest_searches(const std::string& name, const Points& scene)
{
  const auto points = make_points<Cartesian_points<Kernel, 2>>(scene);
  const auto square_of = [=](const std::pair<std::size_t, std::size_t>& pair) {
    return internal::exact_squared_distance(points[pair.first], points[pair.second], 2);
  };
  const auto least = square_of(CGAL::closest_pair(points));
  const auto bound = CGAL::within_squared_distance(least);
  return {watched("closest pair, " + name, [=](auto np) {
            const auto pair = CGAL::closest_pair<Tag>(points, np);
            BOOST_CHECK(pair.first < pair.second && pair.second < points.size());
            BOOST_CHECK(square_of(pair) <= square_of({0, 1}));
          }),
          watched("no close pair, " + name, [=](auto np) {
            BOOST_CHECK(!CGAL::has_close_pair<Tag>(points, bound.open(), np));
            const auto pair = CGAL::find_close_pair<Tag>(points, bound);
            BOOST_CHECK(pair && square_of(*pair) == least);
          })};
}

// Cancelled at once, they have seen little; told that all is done, they have the answer.
template <class Tag>
void check_closest(const std::string& name, const Points& scene, std::size_t least_tells,
                   bool is_parallel)
{
  check(closest_searches<Tag>(name, scene), least_tells, is_parallel);
  const auto points = make_points<Cartesian_points<Kernel, 2>>(scene);
  const auto closest = CGAL::closest_pair(points);
  const auto at_once = CGAL::parameters::callback([](double) { return false; });
  BOOST_CHECK(CGAL::closest_pair<Tag>(points, at_once) != closest);
  const auto least = CGAL::within_squared_distance(
    internal::exact_squared_distance(points[closest.first], points[closest.second], 2));
  BOOST_CHECK(!CGAL::find_close_pair<Tag>(points, least, at_once));
  const auto to_the_end = CGAL::parameters::callback([](double done) { return done < 1; });
  BOOST_CHECK(CGAL::closest_pair<Tag>(points, to_the_end) == closest);
}

BOOST_AUTO_TEST_CASE(progress_of_few_ends_at_1) { check(searches_of(20)); }
BOOST_AUTO_TEST_CASE(progress_of_many_ends_at_1) { check(searches_of(3000)); }
BOOST_AUTO_TEST_CASE(progress_of_many_by_threads_ends_at_1)
{
  check(pair_searches<CGAL::Parallel_if_available_tag>(3000), 1, true);
}

BOOST_AUTO_TEST_CASE(progress_of_images_ends_at_1)
{
  const Kernel::Iso_rectangle_2 box(0, 0, 1, 1);
  for(const double radius : {.01, 1.5}) {
    check(periodic_searches_of(200, box, radius));
    check(periodic_searches_of(200, CGAL::Periodic_lattice_d(box), radius));
  }
}

// A functor that is given by value is copied once for a search, so it may count, or know when it
// was called first.
BOOST_AUTO_TEST_CASE(parts_of_a_search_of_images_call_one_functor)
{
  const Kernel::Iso_rectangle_2 box(0, 0, 1, 1);
  for(const double radius : {.01, 1.5})
    for(const Search& search : periodic_searches_of(200, box, radius))
      BOOST_TEST_CONTEXT(search.name)
      {
        std::size_t calls = 0;
        const auto count = [&calls, own = std::size_t(0)](double) mutable {
          BOOST_CHECK_EQUAL(++own, ++calls);
          return true;
        };
        search.run({}, count);
        BOOST_CHECK_GT(calls, 1u);
      }
}

// By the join, by comparing few points, and by slabs.
BOOST_AUTO_TEST_CASE(progress_of_closest_pairs_ends_at_1)
{
  const auto check_both = [](const std::string& name, const Points& scene, std::size_t least) {
    check_closest<CGAL::Sequential_tag>(name, scene, least, false);
    check_closest<CGAL::Parallel_if_available_tag>(name, scene, least, true);
  };
  const Points uniform = uniform_points(2, 20000, 0, 1, 17);
  check_both("uniform", uniform, 40);
  check_both("few", uniform_points(2, 300, 0, 1, 18), 2);
  check_both("crowded", clustered_points(2, 20000, 3, 1. / 1048576, 19), 40);
  check_both("huge", uniform_points(2, 20000, 0, 1e200, 17), 40);
}

// The last step of a search that finds a pair early, and of one that has nothing to do.
BOOST_AUTO_TEST_CASE(progress_of_early_ends_is_1)
{
  const std::vector<Point> same(5000, Point(1, 2)), none;
  const auto near = CGAL::within_distance(0.1);
  for(const auto& points : {searched_points<2>(20000), same, none})
    check({watched("close pair", [=](auto np) { CGAL::find_close_pair(points, near, np); })});
  check({watched("equal points", [=](auto np) { CGAL::closest_pair(same, np); })});
}

// By other ways than that of few points.
BOOST_AUTO_TEST_CASE(progress_of_no_points_is_1)
{
  const std::vector<Point> none;
  const auto near = CGAL::within_distance(0.1);
  check({watched("points on disk", [=](auto np) {
           const CGAL::Memory_budget budget(1 << 26);
           CGAL::external_fixed_radius_near_neighbors(none, near, budget, ignore, np);
         }),
         watched("points and a profile", [=](auto np) {
           CGAL::Scene_profile profile;
           CGAL::fixed_radius_near_neighbors(none, near, ignore, profile, np);
         })});
}

// The closest pair is across the boundary, or within it.
BOOST_AUTO_TEST_CASE(progress_of_the_closest_images_ends_at_1)
{
  const Kernel::Iso_rectangle_2 box(0, 0, 1, 1);
  for(const double x : {.9375, .125}) {
    const std::vector<Point> points = {{.0625, .5}, {x, .5}};
    check({watched("two points", [=](auto np) { CGAL::periodic_closest_pair(points, box, np); })});
  }
}

// Cancelled halfway, a search has found some pairs. Of the crowd, all but one of the points are in
// one slab.
BOOST_AUTO_TEST_CASE(progress_of_very_many_is_told_often)
{
  using Tag = CGAL::Sequential_tag;
  std::vector<Point> crowd(10000, Point(1, 2));
  crowd.emplace_back(1000, 1000);
  const CGAL::Thick_object_traits_d<CGAL::Bbox_3> traits;
  const std::vector<std::pair<Search, std::size_t>> least_tells
    = {{near_search<Tag>("points", .01, searched_points<2>(20000)), 20},
       {search_by_traits<Tag>("boxes", searched_boxes(20000), traits), 10},
       {near_search<Tag>("crowd", 1, crowd), 3}};
  for(const auto& [search, least] : least_tells)
    BOOST_TEST_CONTEXT(search.name)
    {
      std::size_t pairs = 0, told = 0;
      const On_pair count = [&](std::size_t, std::size_t) { return ++pairs > 0; };
      BOOST_CHECK(search.run(count, [&](double) { return ++told > 0; }));
      BOOST_CHECK_GE(told, least);
      const std::size_t all = std::exchange(pairs, 0);
      BOOST_CHECK(!search.run(count, [](double done) { return done < .5; }));
      BOOST_CHECK_GT(pairs, 0u);
      BOOST_CHECK_LT(pairs, all);
    }
}
