// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the search of features: the pairs of segments, and of vertices and polygons, that it
// looks at are counted where nearly all boxes meet, but are of one feature or of a known pair.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/thick_feature_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace internal = CGAL::Thick_intersection_d::internal;

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Epick::Point_2;
using Polyline = std::vector<Point>;
using Polygon = CGAL::Polygon_2<Epick>;
using With_holes = CGAL::Polygon_with_holes_2<Epick>;
using Bands = std::vector<With_holes>;
using Feature = std::variant<Polyline, Bands>;
using Features = std::vector<Feature>;
using Pieces = internal::Feature_pieces<Epick::Segment_2>;
using Known = internal::Known_pairs;

double looks = 0, tests = 0;

// Counts what the box route asks.
template <class Objects>
struct Counted : Objects
{
  using Objects::Objects;

  bool is_wanted(std::size_t i, std::size_t j) const
  {
    ++looks;
    return Objects::is_wanted(i, j);
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    ++tests;
    return Objects::do_intersect(i, j);
  }
};

// Searches the boundaries, and then the insides. Returns the number of pairs. `test` is as for
// Feature_boundaries.
template <class Test>
std::size_t count_pairs(const Pieces& pieces, const Test& test)
{
  const internal::Threads one;
  Known known(one);
  std::size_t pairs = 0;
  const auto take = [&](std::size_t, std::size_t) { ++pairs; };
  internal::Unwatched_progress progress;
  using Boundaries = internal::Feature_boundaries<Pieces, Test>;
  const Counted<Boundaries> boundaries(pieces, test, known);
  internal::report_meeting_boxes(boundaries, internal::One_set(), take, progress, one);
  const internal::Part_range parts = {0, pieces.part_count()};
  const internal::Part_range filled = {0, pieces.filled_count()};
  using Insides = internal::Feature_insides<Pieces, Test>;
  const Counted<Insides> insides(pieces, test, parts, filled, known);
  internal::report_meeting_boxes(insides, internal::Two_sets{insides.point_count()}, take, progress,
                                 one);
  return pairs;
}

void check_work(const std::string& name, const Features& features, std::size_t expected_pairs)
{
  Pieces pieces;
  pieces.add_features(features);
  const double n = static_cast<double>(pieces.size());
  const auto check = [&](const std::string& how, const auto& test) {
    looks = tests = 0;
    BOOST_CHECK_EQUAL(count_pairs(pieces, test), expected_pairs);
    const double work = (looks - tests) / (n * std::log2(n));
    BOOST_TEST_MESSAGE(name << ", " << how << ", n = " << n << ": looks " << looks / n
                            << " n, tests " << tests / n << " n, work " << work);
    BOOST_CHECK_MESSAGE(work < 20, name << ", " << how << ": " << work);
    BOOST_CHECK_LT(tests, n);
  };
  check("intersecting", internal::Pieces_intersect());
  check("near", internal::Pieces_near<Epick::Segment_2>(CGAL::within_distance(1e-3)));
}

Polygon square(double half)
{
  const Point corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  return Polygon(corners, corners + 4);
}

Bands nested_bands(std::size_t count)
{
  Bands bands;
  for(std::size_t i = 1; i <= count; ++i) {
    bands.emplace_back(square(4. * static_cast<double>(i)));
    bands.back().add_hole(square(4. * static_cast<double>(i) - 2));
  }
  return bands;
}

Polyline zigzag(std::size_t size)
{
  Polyline line;
  for(std::size_t i = 0; i < size; ++i) {
    const double x = static_cast<double>(i), far = 1e6 + x;
    line.push_back(i % 2 ? Point(x, far) : Point(far, x));
  }
  return line;
}

// All of its segments go through all of the bands.
Polyline to_and_fro(std::size_t size)
{
  Polyline line;
  for(std::size_t i = 0; i < size; ++i)
    line.emplace_back(i % 2 ? -1e6 : 1e6, 1e-6 * static_cast<double>(i));
  return line;
}

Polyline moored_track(std::size_t size, double x)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> about(-1e-6, 1e-6);
  Polyline track;
  for(std::size_t i = 0; i < size; ++i)
    track.emplace_back(x + about(random), about(random));
  return track;
}

} // namespace

BOOST_AUTO_TEST_CASE(pieces_of_one_feature_are_not_compared)
{
  for(const std::size_t n : {2000, 6000}) {
    check_work("equal points", {Polyline(n, Point(1, 1)), Polyline(1, Point(5, 5))}, 0);
    check_work("a moored track", {moored_track(n, 0), Polyline(1, Point(5, 5))}, 0);
    check_work("a zigzag", {zigzag(n)}, 0);
    check_work("nested bands", {nested_bands(n / 4)}, 0);
  }
}

BOOST_AUTO_TEST_CASE(pieces_of_known_pairs_are_not_compared)
{
  for(const std::size_t n : {2000, 6000}) {
    check_work("two tracks", {moored_track(n, 0), moored_track(n, 0)}, 1);
    check_work("two zigzags", {zigzag(n), zigzag(n)}, 1);
    check_work("equal bands", Features(2, nested_bands(n / 4)), 1);
    check_work("many equal bands", Features(10, nested_bands(n / 40)), 45);
    check_work("bands and a line across them", {nested_bands(n / 4), to_and_fro(n)}, 1);
  }
}
