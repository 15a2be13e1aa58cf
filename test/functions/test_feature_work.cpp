// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the search of features: the pairs of segments, and of vertices and polygons, that it
// looks at are counted where nearly all boxes meet, but are of one feature or of a known pair. Of
// interiors, it is the edges that are read where boundaries meet in many places, or in one.

#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/thick_feature_intersection_d.h>

#include <variant>

using namespace test_support;

namespace {

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
  const Counted<Insides> insides(pieces, parts, filled, test, known);
  internal::report_meeting_boxes(insides, internal::Two_sets{insides.point_count()}, take, progress,
                                 one);
  return pairs;
}

void check_work(const std::string& name, const Features& features, std::size_t expected_pairs,
                double limit)
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
    BOOST_CHECK_MESSAGE(work < limit, name << ", " << how << ": " << work);
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

BOOST_AUTO_TEST_CASE(pieces_of_one_feature_are_not_compared)
{
  for(const std::size_t n : {2000, 6000}) {
    check_work("equal points", {Polyline(n, Point(1, 1)), Polyline(1, Point(5, 5))}, 0, 8);
    check_work("a moored track", {moored_track(n, 0), Polyline(1, Point(5, 5))}, 0, 8);
    check_work("a zigzag", {zigzag(n)}, 0, 8);
    check_work("nested bands", {nested_bands(n / 4)}, 0, 8);
  }
}

BOOST_AUTO_TEST_CASE(pieces_of_known_pairs_are_not_compared)
{
  for(const std::size_t n : {2000, 6000}) {
    check_work("two tracks", {moored_track(n, 0), moored_track(n, 0)}, 1, 16);
    check_work("two zigzags", {zigzag(n), zigzag(n)}, 1, 16);
    check_work("equal bands", Features(2, nested_bands(n / 4)), 1, 16);
    check_work("many equal bands", Features(10, nested_bands(n / 40)), 45, 16);
    check_work("bands and a line across them", {nested_bands(n / 4), to_and_fro(n)}, 1, 16);
  }
}

// ---- interiors ----------------------------------------------------------------------------------

using Polygons = std::vector<Polygon>;

// Counts the segments that decisions about interiors read.
struct Counted_segments : Pieces
{
  mutable double reads = 0;

  const Pieces::Segment& operator[](std::size_t position) const
  {
    ++reads;
    return Pieces::operator[](position);
  }
};

// Returns how many segments are read for each pair of segments that is asked about.
double reads_per_test(const std::string& name, const Polygons& polygons, std::size_t expected_pairs)
{
  using Test = internal::Interiors_overlap<Counted_segments, true, true>;
  using Boundaries = internal::Feature_boundaries<Counted_segments, Test>;
  Counted_segments segments;
  segments.add_features(polygons);
  const internal::Threads one;
  const Test test(one);
  Known known(one);
  std::size_t pairs = 0;
  internal::Unwatched_progress progress;
  const Counted<Boundaries> boundaries(segments, test, known);
  tests = segments.reads = 0;
  const auto take = [&](std::size_t, std::size_t) { ++pairs; };
  internal::report_meeting_boxes(boundaries, internal::One_set(), take, progress, one);
  BOOST_CHECK_EQUAL(pairs, expected_pairs);
  const double n = static_cast<double>(segments.size());
  BOOST_TEST_MESSAGE(name << ", n = " << n << ": tests " << tests / n << " n, reads "
                          << segments.reads / tests << " of each");
  return segments.reads / tests;
}

// Petals from the origin, in every other one of 2 * count equal sectors.
Polygon rosette(std::size_t count, std::size_t first)
{
  Polygon ring;
  for(std::size_t k = 0; k < count; ++k) {
    ring.push_back(Point(0, 0));
    for(std::size_t i = 0; i < 2; ++i) {
      const double angle = 3.14159265358979 / static_cast<double>(count)
                           * static_cast<double>(2 * k + first + i);
      ring.push_back(Point(std::cos(angle), std::sin(angle)));
    }
  }
  return ring;
}

// Diameters of a circle, joined at every other one of 2 * count equal sectors. The count is odd.
Polygon star(std::size_t count, std::size_t first)
{
  Polygon ring;
  for(std::size_t k = 0; k < count; ++k) {
    const std::size_t diameter = (k + first) % count;
    const double angle = 3.14159265358979 / static_cast<double>(count)
                         * static_cast<double>(diameter);
    const double side = (k % 2 == 0) == (k + first < count) ? 1 : -1;
    for(const double along : {side, -side})
      ring.push_back(Point(along * std::cos(angle), along * std::sin(angle)));
  }
  return ring;
}

// Such a star, of diameters that are within ten degrees. Between the last one and the first one, it
// goes to and fro so many times, in the boxes of all diameters, and never at the height of the
// origin.
Polygon star_with_rim(std::size_t count, std::size_t first, std::size_t rim)
{
  const auto at = [&](double diameter, double radius) {
    const double angle = 0.7 + 0.17 / static_cast<double>(count) * diameter;
    return Point(radius * std::cos(angle), radius * std::sin(angle));
  };
  Polygon ring;
  for(std::size_t i = 0; i < rim; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(rim);
    ring.push_back(at(static_cast<double>(first) + .2 + .6 * part, (i % 2 ? .8 : .6) + .05 * part));
  }
  for(std::size_t k = 1; k <= count; ++k) {
    const std::size_t diameter = (k % count + first) % count;
    const double side = (k % count % 2 == 0) == (k % count + first < count) ? -1 : 1;
    for(const double along : {side, -side})
      ring.push_back(at(static_cast<double>(diameter), along));
  }
  return ring;
}

// The teeth of a comb touch a long edge.
Polygons comb_on_line(std::size_t teeth)
{
  Polygon comb;
  for(std::size_t k = 0; k < teeth; ++k) {
    comb.push_back(Point(2. * static_cast<double>(k), 0));
    comb.push_back(Point(2. * static_cast<double>(k) + 1, 5));
  }
  const double end = 2. * static_cast<double>(teeth);
  comb.push_back(Point(end, 9));
  comb.push_back(Point(-1, 9));
  const Point below[] = {{-5, -5}, {end, -5}, {end, 0}, {-5, 0}};
  return {comb, Polygon(below, below + 4)};
}

// Two bands along a zigzag, with a border of so many edges in common.
Polygons bands_of_common_border(std::size_t size)
{
  Polygons bands(2);
  for(std::size_t k = 0; k < size; ++k) {
    const Point p(static_cast<double>(k), k % 2 ? .5 : 0);
    bands[0].push_back(p);
    bands[1].insert(bands[1].vertices_begin(), p);
  }
  const double end = static_cast<double>(size - 1);
  bands[0].push_back(Point(end, 9));
  bands[0].push_back(Point(0, 9));
  bands[1].push_back(Point(0, -9));
  bands[1].push_back(Point(end, -9));
  return bands;
}

// A chain passed to and fro crosses the border of a square all the time.
Polygons antenna_across_border(std::size_t crossings)
{
  Polygon ring;
  const Point triangle[] = {{0, -9}, {1, -9}, {0, -8}};
  for(const Point& p : triangle)
    ring.push_back(p);
  std::vector<Point> chain;
  for(std::size_t k = 1; k <= crossings; ++k)
    chain.emplace_back(static_cast<double>(k), k % 2 ? 1.5 : -1.25);
  for(const Point& p : chain)
    ring.push_back(p);
  for(std::size_t k = chain.size() - 1; k-- > 0; )
    ring.push_back(chain[k]);
  ring.push_back(triangle[2]);
  const double end = static_cast<double>(crossings) + 5;
  const Point large[] = {{-5, 0}, {end, 0}, {end, 9}, {-5, 9}};
  return {ring, Polygon(large, large + 4)};
}

BOOST_AUTO_TEST_CASE(edges_where_boundaries_meet_are_read_a_few_times)
{
  for(const std::size_t n : {200, 800}) {
    BOOST_CHECK_LT(reads_per_test("a common border", bands_of_common_border(n), 0), 40);
    BOOST_CHECK_LT(reads_per_test("a comb on a line", comb_on_line(n), 0), 60);
    BOOST_CHECK_LT(reads_per_test("rosettes", {rosette(n / 4, 0), rosette(n / 4, 1)}, 0), 25);
    BOOST_CHECK_LT(reads_per_test("stars", {star(n / 4 + 1, 0), star(n / 4 + 1, 1)}, 0), 40);
    BOOST_CHECK_LT(reads_per_test("an antenna", antenna_across_border(n), 0), 150);
  }
}

BOOST_AUTO_TEST_CASE(edges_far_from_where_boundaries_cross_are_read_a_few_times)
{
  const Polygons stars = {star_with_rim(31, 0, 8000), star_with_rim(31, 1, 0)};
  BOOST_CHECK_LT(reads_per_test("a star with a rim", stars, 0), 30);
}

} // namespace
