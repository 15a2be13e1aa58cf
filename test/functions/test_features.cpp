// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polylines and polygons that are near each other, and what the functions for features promise
// besides.

#include "support/check_features.h"

using namespace test_support;

using Point = Epick::Point_2;
using Polyline = std::vector<Point>;
using Polygon = CGAL::Polygon_2<Epick>;
using With_holes = CGAL::Polygon_with_holes_2<Epick>;

namespace {

Polygon polygon(const Chain& chain)
{
  const Polyline points = Features_2<Epick>::points(chain, Scale::ONE);
  return Polygon(points.begin(), points.end());
}

template <class Features>
Pairs pairs_of(const Features& features)
{
  return sorted(reported([&](auto collect) {
    CGAL::thick_feature_self_intersection_d(features, collect);
  }));
}

} // namespace

BOOST_AUTO_TEST_CASE(near_features_of_doubles)
{
  check_near_features<Features_2, Epick>(2, 4, false);
  check_near_features<Features_2, Epick>(2, 4, true);
  check_near_features<Features_2, Epick>(2, 5, false);
  check_near_features<Features_2, Epick>(2, 0, false);
  check_near_features<Features_3, Epick>(3, 5, false);
}

BOOST_AUTO_TEST_CASE(nothing_is_closer_than_zero)
{
  const std::vector<Polygon> polygons = {polygon(square(0, 0, 9)), polygon(square(3, 3, 3))};
  CGAL::fixed_radius_near_features(polygons, CGAL::within_distance(0).open(),
                                   [](std::size_t, std::size_t) { BOOST_ERROR("a pair"); });
}

BOOST_AUTO_TEST_CASE(two_ranges_hold_features_of_different_kinds)
{
  const std::list<Polygon> polygons = {polygon(square(0, 0, 9)), polygon(square(20, 0, 9))};
  const std::vector<Point> points = {Point(9, 9), Point(10, 10), Point(21, 1)};
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  CGAL::thick_feature_intersection_d(points, polygons, std::back_inserter(pairs));
  BOOST_CHECK(sorted(pairs) == Pairs({{0, 0}, {2, 1}}));
  std::vector<std::pair<Polygon, Point>> elements;
  CGAL::thick_feature_intersection_d(polygons, points,
                                     CGAL::with_elements(std::back_inserter(elements)));
  BOOST_REQUIRE_EQUAL(elements.size(), 2u);
  for(const auto& [a, p] : elements)
    BOOST_CHECK(!a.has_on_unbounded_side(p));
}

BOOST_AUTO_TEST_CASE(each_pair_is_reported_once_however_many_segments_meet)
{
  Polyline zigzag, line = {Point(-1, 0), Point(1001, 0)};
  for(int i = 0; i <= 1000; ++i)
    zigzag.emplace_back(i, i % 2 == 0 ? 1 : -1);
  const std::vector<Polyline> lines = {zigzag, line};
  BOOST_CHECK(pairs_of(lines) == Pairs({{0, 1}}));
  std::atomic<std::size_t> count = 0;
  CGAL::thick_feature_self_intersection_d<CGAL::Parallel_tag>(
    lines, [&](std::size_t, std::size_t) { ++count; });
  BOOST_CHECK_EQUAL(count, 1u);
}

BOOST_AUTO_TEST_CASE(a_pair_is_reported_once_however_many_parts_are_inside)
{
  using Union = std::vector<With_holes>;
  const Union parts = {With_holes(polygon(square(2, 2, 1))), With_holes(polygon(square(5, 5, 1)))};
  const std::vector<Union> unions = {parts, {With_holes(polygon(square(0, 0, 9)))}};
  BOOST_CHECK(pairs_of(unions) == Pairs({{0, 1}}));
}

BOOST_AUTO_TEST_CASE(callback_and_progress_stop_the_search)
{
  const std::vector<Polygon> polygons(20, polygon(square(0, 0, 9)));
  std::size_t count = 0;
  BOOST_CHECK(!CGAL::thick_feature_self_intersection_d(
    polygons, [&](std::size_t, std::size_t) { return ++count < 7; }));
  BOOST_CHECK_EQUAL(count, 7u);
  std::vector<Polygon> nested;
  for(int i = 0; i < 20; ++i)
    nested.push_back(polygon(square(i, i, 100 - 2 * i)));
  count = 0;
  BOOST_CHECK(!CGAL::thick_feature_self_intersection_d(
    nested, [&](std::size_t, std::size_t) { return ++count < 7; }));
  BOOST_CHECK_EQUAL(count, 7u);
  double last = 0, last_before_pairs = 1;
  BOOST_CHECK(CGAL::thick_feature_self_intersection_d(
    nested,
    [&](std::size_t, std::size_t) { last_before_pairs = (std::min)(last_before_pairs, last); },
    CGAL::parameters::callback([&](double done) {
      last = done;
      return true;
    })));
  BOOST_CHECK_EQUAL(last, 1);
  // No boundaries meet: all pairs are found when these are done, and what is inside is not.
  BOOST_CHECK(last_before_pairs > .5 && last_before_pairs < .9);
  BOOST_CHECK(!CGAL::thick_feature_self_intersection_d(
    nested, [](std::size_t, std::size_t) {},
    CGAL::parameters::callback([](double) { return false; })));
}

BOOST_AUTO_TEST_CASE(errors_name_the_feature)
{
  const std::vector<With_holes> polygons = {With_holes(polygon(square(0, 0, 1))), With_holes()};
  BOOST_CHECK_EQUAL(refusal([&] { pairs_of(polygons); }), "Feature 1 has no outer boundary.");
}

// Features of very many segments whose boxes meet: tracks that stay, zigzags, bands, and points.
BOOST_AUTO_TEST_CASE(crowded_features)
{
  for(const Feature_scene& scene : crowded_feature_scenes()) {
    std::vector<Features_2<Epick>::Feature> features;
    for(const Lattice_feature& feature : scene.features)
      features.push_back(Features_2<Epick>::make(feature, Scale::ONE));
    const Pairs pairs = intersecting_pairs(scene.features);
    BOOST_CHECK(!pairs.empty() && pairs.size() < features.size() * (features.size() - 1) / 2);
    BOOST_TEST_CONTEXT(scene.name)
    {
      check_features<CGAL::Sequential_tag, Features_2<Epick>>(features, pairs, "in sequence");
      check_features<CGAL::Parallel_tag, Features_2<Epick>>(features, pairs, "in parallel");
    }
    check_near_features_on_kernel<Features_2, Epick>(
      scene, near_feature_pairs(scene.features, 4, false), 4, false, Scale::ONE);
  }
}

BOOST_AUTO_TEST_CASE(features_without_points_are_in_no_pair)
{
  const std::vector<std::variant<Polyline, Polygon>> features
    = {Polyline(), Polygon(), polygon(square(0, 0, 1)), Polyline(1, Point(0, 0))};
  BOOST_CHECK(pairs_of(features) == Pairs({{2, 3}}));
}
