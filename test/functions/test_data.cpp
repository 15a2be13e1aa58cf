// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Real scenes exactly as they are printed, at the radii whose pairs have been counted elsewhere,
// and their closest pairs.
// Files that are not shipped are read if a folder has them.

#include "support/check_closest_pair.h"
#include "support/data_facts.h"

#include <CGAL/Thick_ball_traits_d.h>

using namespace test_support;

namespace {

CGAL::Exact_rational rational(const Decimal_integer& x) { return exact_rational(x.str()); }

template <class Point, class NT>
void check_counts(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& bound,
                  const Fact& fact)
{
  std::size_t closed = 0, open = 0;
  CGAL::fixed_radius_near_neighbors(points, bound, [&](std::size_t, std::size_t) { ++closed; });
  CGAL::fixed_radius_near_neighbors(points, bound.open(),
                                    [&](std::size_t, std::size_t) { ++open; });
  BOOST_CHECK_EQUAL(closed, fact.closer + fact.at_radius);
  BOOST_CHECK_EQUAL(open, fact.closer);
}

// The decimals as scaled integers that doubles hold, on two kernels of doubles.
template <int Dimension>
void check_as_doubles(const Points& points, double radius, const Fact& fact)
{
  const auto bound = CGAL::within_distance(radius);
  check_counts(make_points<Cartesian_points<Epick, Dimension>>(points), bound, fact);
  check_counts(make_points<Cartesian_points<Double_kernel, Dimension>>(points), bound, fact);
}

// The scaled integers as rational numbers, divided by `unit`.
template <int Dimension>
auto as_rationals(const Decimal_points& points, const CGAL::Exact_rational& unit)
{
  using Maker = Cartesian_points<Rational_kernel, Dimension>;
  std::vector<typename Maker::Point> exact;
  for(const auto& c : points.coordinates)
    exact.push_back(Maker::Types::point([&](std::size_t axis) {
      return CGAL::Exact_rational(rational(c[axis]) / unit);
    }));
  return exact;
}

template <int Dimension>
void check_as_rationals(const Decimal_points& points, const CGAL::Exact_rational& radius,
                        const CGAL::Exact_rational& unit, const Fact& fact)
{
  check_counts(as_rationals<Dimension>(points, unit),
               CGAL::within_distance(CGAL::Exact_rational(radius / unit)), fact);
}

template <class Point>
void check_closest(const std::vector<Point>& points, const Decimal_points& decimals)
{
  const Pair expected = closest_of_integers(decimals.coordinates).pair;
  check_pair("default", expected, CGAL::closest_pair(points));
  check_pair("division", expected, closest_by_division(points));
}

template <int Dimension>
void check_fact(const Decimal_points& points, const Fact& fact, bool is_first_of_file)
{
  const Decimal_integer radius = scaled_decimal(fact.radius, points.decimals);
  if(const auto doubles = as_exact_doubles(points)) {
    check_as_doubles<Dimension>(*doubles, static_cast<double>(radius), fact);
    if(is_first_of_file)
      check_closest(make_points<Cartesian_points<Epick, Dimension>>(*doubles), points);
  }
  else {
    check_as_rationals<Dimension>(points, rational(radius), 1, fact);
    if(is_first_of_file)
      check_closest(as_rationals<Dimension>(points, 1), points);
  }
}

struct Aircraft
{
  double instant;        // seconds
  Epick::Point_3 ground; // centimetres
  double height;         // feet
};

// The interval of an instant is the instant, so aircraft of different instants do not meet.
struct Conflict_traits
{
  using Object_d = Aircraft;
  double chord;

  struct Interval_d
  {
    double half_chord;
    std::pair<double, double> operator()(const Aircraft& a, int axis) const
    {
      const double extent = axis == 0 ? 0 : axis == 4 ? 500 : half_chord;
      const double x = axis == 0 ? a.instant : axis == 4 ? a.height : a.ground[axis - 1];
      return {x - extent, x + extent};
    }
  };

  struct Do_intersect_d
  {
    double chord;
    bool operator()(const Aircraft& a, const Aircraft& b) const
    {
      return a.instant == b.instant && std::abs(a.height - b.height) < 1000
             && CGAL::compare_squared_distance(a.ground, b.ground, chord * chord) == CGAL::SMALLER;
    }
  };

  int dimension() const { return 5; }
  Interval_d interval_d_object() const { return {chord / 2 + 1}; } // more than rounding needs
  Do_intersect_d do_intersect_d_object() const { return {chord}; }
};

} // namespace

BOOST_AUTO_TEST_CASE(files_have_the_pairs_of_the_facts)
{
  std::size_t checked = 0;
  std::set<std::string> files;
  for(const Fact& fact : facts())
    if(const auto path = find_data_file(fact.file, data_folders()))
      BOOST_TEST_CONTEXT(fact)
      {
        ++checked;
        const Decimal_points points = read_view(*path, fact.view);
        BOOST_CHECK_EQUAL(points.coordinates.size(), fact.n);
        const bool is_first = files.insert(fact.file + std::to_string(fact.dimension)).second;
        if(fact.dimension == 2)
          check_fact<2>(points, fact, is_first);
        else
          check_fact<3>(points, fact, is_first);
      }
  BOOST_TEST_MESSAGE(checked << " of " << facts().size() << " facts checked");
  BOOST_CHECK_GE(checked, 18u); // those of the shipped files
}

// 45.12345 as the rational 4512345/10^5, and the radius 0.00069 as 69/10^5.
BOOST_AUTO_TEST_CASE(ships_as_decimal_fractions)
{
  const auto path = find_data_file("ships_us_2022-01-03.csv", data_folders());
  BOOST_REQUIRE(path);
  const Decimal_points ships = read_view(*path, View::plane);
  for(const Fact& fact : facts())
    if(fact.file == "ships_us_2022-01-03.csv" && fact.view == View::plane)
      check_as_rationals<2>(ships, rational(scaled_decimal(fact.radius, ships.decimals)),
                            rational(scaled_decimal("1", ships.decimals)), fact);
}

BOOST_AUTO_TEST_CASE(atoms_overlap_as_the_facts_say)
{
  using Ball = std::pair<Epick::Point_3, double>;
  for(const Ball_fact& fact : ball_facts())
    if(const auto path = find_data_file(fact.file, data_folders())) {
      const Atoms atoms = read_pdb(*path);
      const auto centres = as_exact_doubles(atoms.centres);
      BOOST_REQUIRE(centres);
      std::vector<Ball> balls;
      for(std::size_t i = 0; i < centres->size(); ++i)
        balls.emplace_back(Cartesian_points<Epick, 3>::make((*centres)[i]),
                           static_cast<double>(atoms.radii[i]));
      std::size_t pairs = 0;
      CGAL::thick_self_intersection_d(
        balls, [&](std::size_t, std::size_t) { ++pairs; },
        CGAL::parameters::geom_traits(CGAL::Thick_ball_traits_d<Epick::Point_3>(balls)));
      BOOST_CHECK_MESSAGE(pairs == fact.overlapping + fact.touching,
                          fact.file << ": " << pairs << " pairs");
    }
}

// Pairs at the same instant, closer than 5 nautical miles over ground and than 1000 feet in height:
// near points of one instant after another, and all instants at once.
BOOST_AUTO_TEST_CASE(aircraft_are_too_close_as_the_facts_say)
{
  const Separation_fact fact;
  const auto path = find_data_file(fact.file, data_folders());
  if(!path)
    return; // not shipped
  const Csv_table table(*path);
  const Text_rows instants = table.columns({"t_s"});
  const Text_rows heights = table.columns({"alt_ft"});
  const auto ground = as_exact_doubles(sphere_points(table.columns({"lat_deg", "lon_deg"})));
  BOOST_REQUIRE(ground);
  const double diameter = 2 * 637100880.; // centimetres, as the points
  const Conflict_traits traits = {diameter * std::sin(926000 / diameter)};

  std::vector<Aircraft> aircraft;
  std::map<double, std::vector<std::size_t>> rows; // at each instant
  for(std::size_t i = 0; i < instants.size(); ++i) {
    aircraft.push_back({std::stod(instants[i][0]),
                        Cartesian_points<Epick, 3>::make((*ground)[i]), std::stod(heights[i][0])});
    rows[aircraft[i].instant].push_back(i);
  }
  std::size_t pairs = 0;
  for(const auto& at_once : rows) {
    const std::vector<std::size_t>& row = at_once.second;
    std::vector<Epick::Point_3> points;
    for(const std::size_t i : row)
      points.push_back(aircraft[i].ground);
    CGAL::fixed_radius_near_neighbors(
      points, CGAL::within_distance(traits.chord).open(), [&](std::size_t i, std::size_t j) {
        pairs += std::abs(aircraft[row[i]].height - aircraft[row[j]].height) < 1000;
      });
  }
  BOOST_CHECK_EQUAL(rows.size(), fact.instants);
  BOOST_CHECK_EQUAL(pairs, fact.pairs);

  std::size_t pairs_by_traits = 0;
  CGAL::thick_self_intersection_d(
    aircraft, [&](std::size_t, std::size_t) { ++pairs_by_traits; },
    CGAL::parameters::geom_traits(traits));
  BOOST_CHECK_EQUAL(pairs_by_traits, fact.pairs);
}

// Runways of one airport cross, or touch; those of different airports are not asked about.
BOOST_AUTO_TEST_CASE(runways_meet_as_the_facts_say)
{
  const auto path = find_data_file("runways.csv", data_folders());
  BOOST_REQUIRE(path);
  const Runways runways = read_runways(*path);
  const std::size_t n = runways.airports.size();
  const auto end = [&](std::size_t i) {
    const auto& c = runways.ends.coordinates[i];
    return Rational_kernel::Point_2(rational(c[0]), rational(c[1]));
  };
  std::vector<Rational_kernel::Segment_2> segments;
  for(std::size_t i = 0; i < n; ++i)
    segments.emplace_back(end(i), end(i + n));
  std::size_t pairs = 0;
  CGAL::thick_self_intersection_d(segments, [&](std::size_t i, std::size_t j) {
    pairs += runways.airports[i] == runways.airports[j];
  });
  BOOST_CHECK_EQUAL(pairs, crossing_runways + touching_runways);
}

BOOST_AUTO_TEST_CASE(boxes_of_triangles_meet_as_the_facts_say)
{
  const auto path = find_data_file("spot.obj", data_folders());
  BOOST_REQUIRE(path);
  const Mesh mesh = read_obj(*path);
  std::vector<Rational_kernel::Iso_cuboid_3> boxes;
  for(const auto& triangle : mesh.triangles) {
    CGAL::Exact_rational low[3], high[3];
    for(int axis = 0; axis < 3; ++axis) {
      const auto x = [&](int v) { return mesh.vertices.coordinates[triangle[v]][axis]; };
      low[axis] = rational((std::min)({x(0), x(1), x(2)}));
      high[axis] = rational((std::max)({x(0), x(1), x(2)}));
    }
    boxes.emplace_back(Rational_kernel::Point_3(low[0], low[1], low[2]),
                       Rational_kernel::Point_3(high[0], high[1], high[2]));
  }
  std::size_t pairs = 0;
  CGAL::thick_self_intersection_d(boxes, [&](std::size_t, std::size_t) { ++pairs; });
  BOOST_CHECK_EQUAL(pairs, meeting_boxes_of_spot);
}
