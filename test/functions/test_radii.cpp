// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which objects of all kinds with radii of their own intersect, and which are near, beside segments
// without a radius, on the usual kernels; and polylines and polygons with a radius each.

#include "support/check_features.h"
#include "support/check_kinds.h"
#include "support/usual_kernels.h"

using namespace test_support;

BOOST_AUTO_TEST_CASE(epick_2) { check_all_kinds<Thickened_kinds<Epick, 2>>(); }
BOOST_AUTO_TEST_CASE(epeck_3) { check_all_kinds<Thickened_kinds<Epeck, 3>>(); }
BOOST_AUTO_TEST_CASE(doubles_3) { check_all_kinds<Thickened_kinds<Double_kernel, 3>>(); }
BOOST_AUTO_TEST_CASE(rationals_2) { check_all_kinds<Thickened_kinds<Rational_kernel, 2>>(); }

// So many points are near each that the search cuts the segments.
BOOST_AUTO_TEST_CASE(long_capsules_are_searched_in_stretches)
{
  using Capsule = std::pair<Epick::Segment_2, double>;
  Random random(1);
  const auto place = [&](std::size_t side) {
    const auto coordinate = [&] { return static_cast<std::int64_t>(random.below(2 * side + 1)); };
    return Place{coordinate() - std::int64_t(side), coordinate() - std::int64_t(side), 0};
  };
  const auto point = [](const Place& p) {
    return Epick::Point_2(static_cast<double>(p[0]), static_cast<double>(p[1]));
  };
  std::vector<Kind_object> segments, centers;
  std::vector<Capsule> capsules;
  std::vector<Epick::Point_2> points;
  for(std::int64_t radius = 0; radius < 20; ++radius) {
    segments.push_back({Kind::SEGMENT, {{-120, -120, 0}, place(120)}, radius});
    capsules.emplace_back(Epick::Segment_2(point(segments.back().points[0]),
                                           point(segments.back().points[1])),
                          static_cast<double>(radius));
  }
  for(int i = 0; i < 5000; ++i) {
    centers.push_back({Kind::POINT, {place(120)}, 0});
    points.push_back(point(centers.back().points[0]));
  }
  Pairs expected, found;
  for(std::size_t i = 0; i < segments.size(); ++i)
    for(std::size_t j = 0; j < centers.size(); ++j)
      if(squared_distance(segments[i], centers[j]) <= segments[i].radius * segments[i].radius)
        expected.emplace_back(i, j);
  CGAL::thick_intersection_d(capsules, points, std::back_inserter(found));
  BOOST_TEST(compare(expected, found).empty());
}

// Features with a radius of 0, 1 or 2 are near if those without are within the sum.
template <template <class> class Features, class Kernel>
void check_thick_features(int dimension, int bound)
{
  using Feature = typename Features<Kernel>::Feature;
  for(const Feature_scene& scene : feature_scenes(dimension)) {
    const auto radius = [](std::size_t i) { return static_cast<int>(i % 3); };
    std::vector<std::pair<Feature, typename Kernel::FT>> features;
    for(std::size_t i = 0; i < scene.features.size(); ++i)
      features.emplace_back(Features<Kernel>::make(scene.features[i], Scale::ONE), radius(i));
    Pairs expected;
    for(int sum = 0; sum <= 4; ++sum)
      for(const Pair& pair : near_feature_pairs(scene.features, (sum + bound) * (sum + bound),
                                                false))
        if(radius(pair.first) + radius(pair.second) == sum)
          expected.push_back(pair);
    const auto ranges = split(features, first_set_size(features.size()));
    const Pairs of_one = collected([&](const Callback& callback) {
      if(bound == 0)
        CGAL::thick_feature_self_intersection_d<CGAL::Parallel_tag>(features, callback);
      else
        CGAL::fixed_radius_near_features(features, CGAL::within_distance(bound), callback);
    });
    const Pairs of_two = collected([&](const Callback& callback) {
      if(bound == 0)
        CGAL::thick_feature_intersection_d(ranges.first, ranges.second, callback);
      else
        CGAL::fixed_radius_near_features<CGAL::Parallel_tag>(
          ranges.first, ranges.second, CGAL::within_distance(bound), callback);
    });
    check_pairs(scene.name, sorted(expected), of_one, of_two, ranges.first.size());
  }
}

BOOST_AUTO_TEST_CASE(polylines_and_polygons_with_radii)
{
  for(const int bound : {0, 1}) {
    check_thick_features<Features_2, Epick>(2, bound);
    check_thick_features<Features_2, Rational_kernel>(2, bound);
    check_thick_features<Features_3, Epeck>(3, bound);
  }
}

// The box of a solid and that of a pipe are apart by the radius.
BOOST_AUTO_TEST_CASE(pipes_touch_solids)
{
  using Point = Epick::Point_3;
  using Pipe = std::pair<std::vector<Point>, double>;
  using Soup = std::pair<std::vector<Point>, std::vector<std::array<std::size_t, 3>>>;
  const Soup solid = {{Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0), Point(0, 0, 4)},
                      {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}};
  const std::vector<std::variant<Pipe, Soup>> features
    = {Pipe({Point(-9, 0, 5), Point(9, 0, 5)}, 1), solid, Pipe({Point(1, 1, 1)}, 0),
       Pipe({Point(-9, 0, 6), Point(9, 0, 6)}, std::nextafter(2., 0.))};
  Pairs pairs;
  CGAL::thick_feature_self_intersection_d(features, std::back_inserter(pairs));
  BOOST_CHECK(sorted(pairs) == Pairs({{0, 1}, {0, 3}, {1, 2}}));
}

template <class Object>
void check_refused(const Object& object, const char* message)
{
  const std::vector<Object> objects(3, object);
  const auto report = [](std::size_t, std::size_t) { BOOST_ERROR("a pair is reported"); };
  const auto is_it = [&](const std::exception& e) { return std::string(e.what()) == message; };
  BOOST_CHECK_EXCEPTION(CGAL::thick_self_intersection_d(objects, report), std::invalid_argument,
                        is_it);
  BOOST_CHECK_EXCEPTION(
    CGAL::fixed_radius_near_neighbors(objects, CGAL::within_distance(1), report),
    std::invalid_argument, is_it);
}

BOOST_AUTO_TEST_CASE(what_is_no_radius_is_refused)
{
  const Epick::Segment_2 segment(Epick::Point_2(0, 0), Epick::Point_2(1, 0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double radius : {-1., -std::numeric_limits<double>::denorm_min(), nan, infinity})
    check_refused(std::pair(segment, radius),
                  "The radius of object 0 is negative, NaN or infinite.");
  const std::vector<std::pair<std::vector<Epick::Point_2>, double>> polylines
    = {{{Epick::Point_2(0, 0)}, 1}, {{Epick::Point_2(0, 0)}, -1}};
  BOOST_CHECK_EXCEPTION(
    CGAL::thick_feature_self_intersection_d(polylines, [](std::size_t, std::size_t) {}),
    std::invalid_argument, [](const std::exception& e) {
      return std::string(e.what()) == "The radius of feature 1 is negative, NaN or infinite.";
    });
  check_refused(std::pair(CGAL::Bbox_2(1, 0, 0, 1), 1.),
                "The bounding box of object 0 is empty or not finite.");
  check_refused(std::pair(Epick::Segment_2(Epick::Point_2(0, 0), Epick::Point_2(nan, 0)), 1.),
                "Coordinate 0 of vertex of object 0 is NaN or infinite.");
}
