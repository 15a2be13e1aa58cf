// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the functions refuse: numbers that are not finite, negative radii, empty boxes, and bad
// bounds. The error names the first position, in two ranges as in one, whatever the size and by
// threads as well, and nothing is reported before.

#include "support/interval_traits.h"
#include "support/usual_kernels.h"

#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_tracks.h>
#include <CGAL/thick_box_intersection_d.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

using namespace test_support;

namespace {

using Point = Epick::Point_2;
using Segment = Epick::Segment_2;
using Ball = std::pair<Point, double>;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
const double bad_coordinates[] = {nan_value, infinity, -infinity};

// One type of callback, because compilers make a search for each.
using Callback = std::function<void(std::size_t, std::size_t)>;
const Callback fail = [](std::size_t, std::size_t) { BOOST_ERROR("a pair before an error"); };

// Two elements are bad.
template <class T>
std::vector<T> with_bad(std::size_t size, std::size_t position, const T& good, const T& bad)
{
  std::vector<T> all(size, good);
  all[position] = all.back() = bad;
  return all;
}

void check_errors(const std::string& text, const std::vector<std::function<void()>>& searches)
{
  for(std::size_t k = 0; k < searches.size(); ++k) {
    const std::string error = refusal(searches[k]);
    BOOST_CHECK_MESSAGE(contains(error, text), "search " << k << ": " << error << ", not " << text);
  }
}

template <class Tag, class Points>
void check_points(const Points& points, const std::string& text)
{
  const auto bound = CGAL::within_distance(1.);
  const auto [a, b] = split(points, 1);
  CGAL::Scene_profile profile;
  check_errors(text, {
    [&] { CGAL::fixed_radius_near_neighbors<Tag>(points, bound, fail); },
    [&] { CGAL::fixed_radius_near_neighbors<Tag>(points, bound, fail, profile); },
    [&, &a = a, &b = b] { CGAL::fixed_radius_near_neighbors<Tag>(a, b, bound, fail); },
    [&] { CGAL::fixed_radius_neighbor_lists<Tag>(points, bound); },
    [&] { CGAL::closest_pair<Tag>(points); },
    [&] { CGAL::find_close_pair<Tag>(points, bound); },
    [&] { CGAL::profile_scene(points, bound); }});
}

template <class Tag, class Object>
void check_objects(const std::vector<Object>& objects, const std::string& text)
{
  const auto bound = CGAL::within_distance(1.);
  const auto [first, second] = split(objects, 1);
  const auto &a = first, &b = second;
  CGAL::Scene_profile profile;
  check_errors(text, {
    [&] { CGAL::thick_self_intersection_d<Tag>(objects, fail); },
    [&] { CGAL::thick_self_intersection_d<Tag>(objects, fail, profile); },
    [&] { CGAL::thick_intersection_d<Tag>(a, b, fail); },
    [&] { CGAL::thick_intersection_d<Tag>(a, b, fail, profile); },
    [&] { CGAL::fixed_radius_near_neighbors<Tag>(objects, bound, fail); },
    [&] { CGAL::fixed_radius_near_neighbors<Tag>(a, b, bound, fail); }});
}

template <class Tag>
void check_kinds(std::size_t size, std::size_t position)
{
  const Point origin(0, 0), one(1, 1);
  const std::string object = " of object " + std::to_string(position) + " is ";
  for(const double x : bad_coordinates) {
    const Point bad(1, x);
    const Segment segment(origin, one), bad_segment(origin, bad);
    check_objects<Tag>(with_bad(size, position, segment, bad_segment),
                       "Coordinate 1 of vertex" + object);
    check_objects<Tag>(with_bad<std::variant<Segment, Ball>>(size, position, Ball(one, 1),
                                                             bad_segment), "vertex" + object);
    check_objects<Tag>(with_bad<Epick::Iso_rectangle_2>(size, position, {origin, one},
                                                        {origin, bad}), "vertex" + object);
  }
  for(const double r : {-1., nan_value, infinity})
    check_objects<Tag>(with_bad(size, position, Ball(origin, 1), Ball(origin, r)),
                       "radius" + object);
  for(const CGAL::Bbox_3& bad : {CGAL::Bbox_3(), CGAL::Bbox_3(0, 0, 0, 1, infinity, 1)})
    check_objects<Tag>(with_bad(size, position, CGAL::Bbox_3(0, 0, 0, 1, 1, 1), bad),
                       "The bounding box" + object + "empty or not finite.");
}

template <class Tag>
void check_intervals(std::size_t size, std::size_t position)
{
  for(const internal::Interval& bad :
      {internal::Interval{1, 0}, internal::Interval{nan_value, 0},
       internal::Interval{0, nan_value}, internal::Interval{infinity, -infinity}})
    for(const int dimension : {1, 2, 5}) {
      Number_box good;
      good.fill({0, 1});
      Number_box wrong = good;
      wrong[static_cast<std::size_t>(dimension - 1)] = bad;
      const Number_boxes boxes = with_bad(size, position, good, wrong);
      Call_count calls = 0;
      const Interval_traits traits(dimension, calls);
      const auto np = CGAL::parameters::geom_traits(traits);
      const auto [first, second] = split(boxes, 1);
      const auto objects = colored(boxes), a = colored(first), b = colored(second);
      check_errors("object " + std::to_string(position) + " along axis "
                     + std::to_string(dimension - 1),
                   {[&] { CGAL::thick_self_intersection_d<Tag>(objects, fail, np); },
                    [&] { CGAL::thick_intersection_d<Tag>(a, b, fail, np); }});
    }
}

// Of boxes, and of features.
template <class Tag>
void check_ranges(std::size_t size, std::size_t position)
{
  using Box = CGAL::Bbox_2;
  struct Coordinates : Box
  {
    using Box::Box;
    static constexpr int dimension() { return 2; }
    double min_coord(int i) const { return (this->min)(i); }
    double max_coord(int i) const { return (this->max)(i); }
  };
  const auto boxes = with_bad(size, position, Coordinates(0, 0, 1, 1),
                              Coordinates(0, nan_value, 1, nan_value));
  const auto ignore = [](const Coordinates&, const Coordinates&) { fail(0, 0); };
  const auto begin = boxes.begin(), end = boxes.end();
  check_errors("Coordinate 1 of box " + std::to_string(position) + " is NaN.",
               {[&] { CGAL::thick_box_self_intersection_d<Tag>(begin, end, ignore); },
                [&] { CGAL::thick_box_intersection_d<Tag>(begin, begin + 1, begin + 1, end,
                                                          ignore); }});
  const std::vector<Point> good = {Point(0, 0)}, bad = {Point(0, 0), Point(0, nan_value)};
  const auto features = with_bad(size, position, good, bad);
  const auto bound = CGAL::within_distance(1.);
  check_errors("Coordinate 1 of vertex of feature " + std::to_string(position) + " is NaN",
               {[&] { CGAL::thick_feature_self_intersection_d<Tag>(features, fail); },
                [&] { CGAL::fixed_radius_near_features<Tag>(features, bound, fail); }});
}

// Of tracks: a fix is wrong, or its time.
template <class Tag>
void check_tracks(std::size_t size, std::size_t position)
{
  using Track = std::vector<std::pair<double, Point>>;
  const Track good = {{0, Point(0, 0)}, {1, Point(1, 0)}};
  const std::string of_fix = " fix 1 of track " + std::to_string(position);
  const auto check = [&](const std::pair<double, Point>& fix, const std::string& text) {
    const auto tracks = with_bad(size, position, good, Track{good[0], fix});
    const auto [a, b] = split(tracks, 1);
    const auto bound = CGAL::within_distance(1.);
    check_errors(text, {[&] { CGAL::fixed_radius_near_tracks<Tag>(tracks, bound, fail); },
                        [&, &a = a, &b = b] {
                          CGAL::fixed_radius_near_tracks<Tag>(a, b, bound, fail);
                        },
                        [&] { CGAL::fixed_radius_track_lists<Tag>(tracks, bound); }});
  };
  for(const double bad : bad_coordinates) {
    check({1, Point(0, bad)}, "Coordinate 1 of" + of_fix + " is NaN or infinite.");
    check({bad, Point(0, 0)}, "The time of" + of_fix + " is NaN or infinite.");
  }
  for(const double bad : {0., -1.})
    check({bad, Point(0, 0)},
          "The time of" + of_fix + " is not later than that of the fix before.");
}

} // namespace

// Few points are searched in a way of their own, which takes eight or more of them in lanes.
BOOST_AUTO_TEST_CASE(points_that_are_not_finite)
{
  for(const std::size_t size : {2, 8, 9, 64, 200, 256, 3000})
    for(const double bad : bad_coordinates)
      for(const std::size_t position : {std::size_t(1), size / 2, size - 1})
        for(const std::size_t axis : {0, 1, 2}) {
          double c[3] = {1, 1, 1};
          c[axis] = bad;
          const auto points = with_bad(size, position, Epick::Point_3(1, 1, 1),
                                       Epick::Point_3(c[0], c[1], c[2]));
          const std::string text = "Coordinate " + std::to_string(axis) + " of point "
                                   + std::to_string(position) + " is NaN or infinite.";
          check_points<CGAL::Sequential_tag>(points, text);
          check_points<CGAL::Parallel_if_available_tag>(points, text);
        }
}

BOOST_AUTO_TEST_CASE(objects_that_are_not_finite)
{
  for(const std::size_t size : {3, 70, 3000})
    for(const std::size_t position : {std::size_t(1), size / 2}) {
      check_kinds<CGAL::Sequential_tag>(size, position);
      check_kinds<CGAL::Parallel_if_available_tag>(size, position);
      check_intervals<CGAL::Sequential_tag>(size, position);
      check_intervals<CGAL::Parallel_if_available_tag>(size, position);
      check_ranges<CGAL::Sequential_tag>(size, position);
      check_ranges<CGAL::Parallel_if_available_tag>(size, position);
      check_tracks<CGAL::Sequential_tag>(size, position);
      check_tracks<CGAL::Parallel_if_available_tag>(size, position);
    }
}

// Even without points, and whether there are few of them or not.
BOOST_AUTO_TEST_CASE(bounds_that_are_negative_or_nan)
{
  const auto check = [](const auto& bound, const std::string& text) {
    for(const std::size_t size : {0, 2, 3000}) {
      const std::vector<Point> points(size, Point(0, 0));
      const std::vector<Segment> segments(size, Segment(Point(0, 0), Point(1, 1)));
      check_errors(text, {
        [&] { CGAL::fixed_radius_near_neighbors(points, bound, fail); },
        [&] { CGAL::fixed_radius_near_neighbors(points, points, bound, fail); },
        [&] { CGAL::fixed_radius_near_neighbors(segments, bound, fail); },
        [&] { CGAL::fixed_radius_near_neighbors(points, segments, bound, fail); },
        [&] { CGAL::fixed_radius_near_features(points, bound, fail); },
        [&] {
          const std::vector<std::pair<int, Point>> tracks[] = {{{0, Point(0, 0)}}};
          CGAL::fixed_radius_near_tracks(tracks, bound, fail);
        },
        [&] { CGAL::fixed_radius_neighbor_lists(points, bound); },
        [&] { CGAL::find_close_pair(points, bound); }});
    }
  };
  const std::string text = "The distance bound is negative or NaN.";
  for(const double bad : {-1., -5e-324, -infinity, nan_value})
    for(const bool is_squared : {false, true})
      check(CGAL::Distance_bound<double>(bad, is_squared), text);
  check(CGAL::within_distance(CGAL::Exact_rational(-1) / 3), text);
  const std::vector<Point> none;
  BOOST_CHECK_EQUAL(refusal([&] {
    CGAL::fixed_radius_near_neighbors(none, CGAL::within_distance(-0.), fail);
  }), "");
}

BOOST_AUTO_TEST_CASE(fewer_than_two_points_have_no_closest_pair)
{
  for(const std::size_t size : {0, 1}) {
    const std::vector<Point> points(size, Point(1, 2));
    BOOST_CHECK_EQUAL(refusal([&] { CGAL::closest_pair(points); }),
                      "There is no closest pair of fewer than two points.");
    BOOST_CHECK(!CGAL::has_close_pair(points, CGAL::within_distance(infinity)));
  }
}
