// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The pieces and parts of features of each kind, and what is wrong with some.

#include "support/error_messages.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/features/Feature_pieces.h>

BOOST_AUTO_TEST_SUITE(Feature_pieces)

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Polyline = std::list<Point>;
using Polygon = CGAL::Polygon_2<Kernel>;
using With_holes = CGAL::Polygon_with_holes_2<Kernel>;
using Polygons = std::vector<Polygon>;
using Feature = std::variant<Point, Polyline, Polygon, With_holes, Polygons>;
using Pieces = internal::Feature_pieces<Kernel::Segment_2>;
using Ends = std::vector<std::pair<Point, Point>>;
using internal::Place;

Polygon square(double x, double side)
{
  const Point corners[] = {{x, x}, {x + side, x}, {x + side, x + side}, {x, x + side}};
  return Polygon(corners, corners + 4);
}

With_holes frame(double x, double side)
{
  With_holes frame(square(x, side));
  frame.add_hole(Polygon());
  for(const double at : {x + 1, x + side / 2})
    frame.add_hole(square(at, side / 4));
  return frame;
}

Ends ends_of(const Pieces& pieces, std::size_t first = 0)
{
  Ends ends;
  for(std::size_t i = first; i < pieces.size(); ++i)
    ends.emplace_back(pieces[i].source(), pieces[i].target());
  return ends;
}

BOOST_AUTO_TEST_CASE(polylines_are_open_and_polygons_are_closed)
{
  const Point p(0, 0), q(1, 0), r(0, 1);
  const Point corners[] = {p, q, r};
  const std::vector<Feature> features
    = {p, Polyline(), Polyline{q}, Polyline{p, q, r}, Polygon(corners, corners + 3), Polygon(),
       Polygon(corners, corners + 1)};
  Pieces pieces;
  pieces.add_features(features);
  BOOST_CHECK((ends_of(pieces)
               == Ends{{p, p}, {q, q}, {p, q}, {q, r}, {p, q}, {q, r}, {r, p}, {p, p}}));
  BOOST_CHECK_EQUAL(pieces.feature_count(), 7u);
  BOOST_CHECK_EQUAL(pieces.part_count(), 5u);
  std::vector<Place> lasts;
  for(std::size_t part = 0; part < pieces.part_count(); ++part)
    lasts.push_back(pieces.last_segment(part));
  BOOST_CHECK((lasts == std::vector<Place>{1, 2, 4, 7, 8}));
  BOOST_REQUIRE_EQUAL(pieces.filled_count(), 2u);
  const std::size_t feature_of_segment[] = {0, 2, 3, 3, 4, 4, 4, 6};
  for(std::size_t i = 0; i < 8; ++i)
    BOOST_CHECK_EQUAL(pieces.feature_of(i), feature_of_segment[i]);
  BOOST_CHECK_EQUAL(pieces.filled(0).tree.first, 4u);
  BOOST_CHECK_EQUAL(pieces.filled(0).tree.last, 7u);
  BOOST_CHECK_EQUAL(pieces.part(pieces.filled(1).part).feature, 6u);
}

BOOST_AUTO_TEST_CASE(each_polygon_of_a_range_is_a_part)
{
  const std::vector<Feature> features = {square(0, 1), Polygons{square(5, 1), square(9, 1)}};
  Pieces pieces;
  pieces.add_features(features);
  BOOST_REQUIRE_EQUAL(pieces.part_count(), 3u);
  BOOST_CHECK_EQUAL(pieces.part(2).feature, 1u);
  BOOST_CHECK_EQUAL(pieces.part(2).piece, 8u);
  BOOST_CHECK_EQUAL(pieces.box_of_filled(2).xmin(), 9);
}

BOOST_AUTO_TEST_CASE(holes_are_rings_of_the_same_part)
{
  Pieces pieces;
  pieces.add_features(std::vector<Feature>{square(0, 9), frame(0, 80), square(-9, 9)});
  BOOST_CHECK_EQUAL(pieces.size(), 20u);
  BOOST_REQUIRE_EQUAL(pieces.part_count(), 3u);
  BOOST_CHECK_EQUAL(pieces.box_of_filled(1).xmax(), 80);

  const double at[] = {0.5, 1.5, 20, 22, 41, 61, 79, 81};
  const bool is_in_frame[] = {true, false, false, true, false, true, true, false};
  for(std::size_t k = 0; k < 8; ++k) {
    Pieces points;
    points.add_features(std::vector<Feature>{frame(0, 80), Point(at[k], at[k]), square(200, 9)});
    BOOST_CHECK_EQUAL(points.is_inside(points.first_piece(1), 0), is_in_frame[k]);
    BOOST_CHECK(!points.is_inside(points.first_piece(1), 1));
  }
}

// The tree of the frame has several leaves, and a box of several rings may be right of a point.
BOOST_AUTO_TEST_CASE(many_holes)
{
  With_holes sieve(square(0, 100));
  for(int x = 1; x < 100; x += 2)
    sieve.add_hole(square(x, 1));
  Pieces pieces;
  pieces.add_features(std::vector<Feature>{sieve});
  BOOST_CHECK_EQUAL(pieces.size(), 4u * 51u);
  for(int x = 0; x < 100; ++x) {
    Pieces points;
    points.add_features(std::vector<Feature>{sieve, Point(x + .5, x + .25), Point(-1, x + .25)});
    BOOST_CHECK_EQUAL(points.is_inside(points.first_piece(1), 0), x % 2 == 0);
    BOOST_CHECK(!points.is_inside(points.first_piece(2), 0));
  }
}

template <class Error = std::invalid_argument, class Feature, class... Limit>
std::string message_of(const std::vector<Feature>& features, Limit... limit)
{
  Pieces pieces{limit...};
  return error_message<Error>([&] { pieces.add_features(features); });
}

BOOST_AUTO_TEST_CASE(errors_name_the_feature)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point p(0, 0), q(0, nan);
  const std::string message = "Coordinate 1 of vertex of feature 1 is NaN or infinite.";
  BOOST_CHECK_EQUAL(message_of(std::vector<Polyline>{{}, {q, p}}), message);
  BOOST_CHECK_EQUAL(message_of(std::vector<Polyline>{{p}, {p, q}}), message);
  BOOST_CHECK_EQUAL(message_of(std::vector<Point>{p, q}), message);
  BOOST_CHECK_EQUAL(message_of(std::vector<With_holes>{frame(0, 8), With_holes()}),
                    "Feature 1 has no outer boundary.");
  BOOST_CHECK_EQUAL(message_of(std::vector<Polyline>{{p}}), "");
}

// Before the numbers of 32 bits run out: a small limit stands for theirs.
BOOST_AUTO_TEST_CASE(too_many_features_or_segments_are_refused)
{
  const auto message = [](std::size_t limit, const std::vector<Feature>& features) {
    return message_of<std::length_error>(features, limit);
  };
  const Point p(0, 0);
  BOOST_CHECK_EQUAL(message(5, {p, p, p, p}), "");
  BOOST_CHECK_EQUAL(message(4, {Polyline(), Polyline(), p, Polyline()}),
                    "There are too many features: 4 or more.");
  BOOST_CHECK_EQUAL(message(5, {square(0, 1)}), "");
  BOOST_CHECK_EQUAL(message(4, {square(0, 1)}),
                    "There are too many segments and faces of features: 4 or more.");

  // A polygon of one vertex is a part, a polygon, and one segment.
  const Polygon point(&p, &p + 1);
  const std::string parts = "There are too many parts of features, polygons and closed meshes: "
                            "4 or more.";
  BOOST_CHECK_EQUAL(message(5, {point, point}), "");
  BOOST_CHECK_EQUAL(message(4, {point, point}), parts);
  BOOST_CHECK_EQUAL(message(4, {point, p, p}), parts);
}

BOOST_AUTO_TEST_SUITE_END()
