// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// No more than a scene needs, and the same pairs: every tier that is exact for a scene, up to its
// limit and in every rounding mode; the counts of decisions. That axes and radii are not stored is
// in test_work.
//
// Compiled twice: the second time with fused multiplication wherever the compiler finds a use.

#include "support/brute_force.h"
#include "support/check_pairs.h"
#include "support/kernels.h"
#include "support/rounding_mode.h"

#include <CGAL/Cartesian_d.h>

using namespace test_support;
using CGAL::Arithmetic_tier;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Plane = Cartesian_points<Kernel, 2>;
using Space = Cartesian_points<Kernel, 3>;
using Rational_plane = Cartesian_points<CGAL::Simple_cartesian<CGAL::Exact_rational>, 2>;

constexpr Arithmetic_tier all_tiers[] = {Arithmetic_tier::DOUBLE, Arithmetic_tier::INT64,
                                         Arithmetic_tier::INT128, Arithmetic_tier::FILTERED_EXACT};

template <class Point, class NT>
Pairs pairs_with(CGAL::Scene_profile& profile, const std::vector<Point>& points,
                 const CGAL::Distance_bound<NT>& bound)
{
  Pairs pairs;
  const auto append = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  BOOST_REQUIRE(CGAL::fixed_radius_near_neighbors(points, bound, append, profile));
  return sorted(pairs);
}

// All tiers from `needed` on find the pairs, and those before are refused.
template <class Maker>
void check_tiers(const Points& scene, double r, Arithmetic_tier needed)
{
  const auto points = make_points<Maker>(scene);
  const Truth truth = brute_force(scene, Radius::of_length(r));
  for(const Arithmetic_tier tier : all_tiers)
    for(const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
      BOOST_TEST_CONTEXT(tier << " in rounding mode " << mode)
      {
        CGAL::Scene_profile profile;
        profile.force_tier(tier);
        std::fesetround(mode);
        if(tier < needed)
          BOOST_CHECK_THROW(pairs_with(profile, points, CGAL::within_distance(r)),
                            std::invalid_argument);
        else {
          const Pairs closed = pairs_with(profile, points, CGAL::within_distance(r));
          const Pairs open = pairs_with(profile, points, CGAL::within_distance(r).open());
          std::fesetround(FE_TONEAREST);
          BOOST_CHECK(closed == truth.pairs);
          BOOST_CHECK(open == truth.open_pairs);
          BOOST_CHECK(profile.needed_tier() == needed);
        }
        std::fesetround(FE_TONEAREST);
      }
}

// The integer square root of `square`, moved by -1, 0 or 1.
double near_root(const Integer& square, Random& random)
{
  const Integer root = sqrt(square);
  return static_cast<double>(root) + static_cast<double>(random.below(3)) - 1;
}

// Around the origin: ties at r on the axes, and integers as near to the sphere of radius r as there
// are. `step` divides r, and leaves coordinates along the other axes below 2^53.
Points near_sphere(int dimension, double r, double step)
{
  Random random(7);
  Points points = {Coordinates(dimension, 0)};
  for(int axis = 0; axis < dimension; ++axis)
    for(const double x : {r, -r}) {
      points.push_back(points.front());
      points.back()[axis] = x;
    }
  while(points.size() < 150) {
    Coordinates c = {r - step * static_cast<double>(random.below(1000))};
    Integer rest = Integer(r) * Integer(r) - Integer(c[0]) * Integer(c[0]);
    if(dimension == 3) {
      c.push_back(std::floor(std::ldexp(static_cast<double>(Integer(sqrt(rest))),
                                        -1 - static_cast<int>(random.below(20)))));
      rest -= Integer(c[1]) * Integer(c[1]);
    }
    c.push_back(near_root(rest, random));
    points.push_back(c);
  }
  points.push_back(Coordinates(dimension, 1)); // so that the grid is that of the integers
  return points;
}

// Rational points, and one more, far away, with a coordinate that is no double.
std::vector<Rational_plane::Point> with_a_third(const Points& scene)
{
  auto points = make_points<Rational_plane>(scene);
  points.emplace_back(CGAL::Exact_rational(1) / 3 + 1000000, 0);
  return points;
}

template <class Maker>
void check_limit(int dimension, double units, double step, Arithmetic_tier needed)
{
  BOOST_TEST_CONTEXT(units << " steps in dimension " << dimension)
  {
    Points points = near_sphere(dimension, units, step);
    check_tiers<Maker>(points, units, needed);
    if(step != 1)
      return;
    for(Coordinates& c : points) // nor does it matter where, and how fine the grid is
      for(double& x : c)
        x = std::ldexp(x + std::ldexp(1., 40), -30);
    check_tiers<Maker>(points, std::ldexp(units, -30), needed);
  }
}

std::string message_of_forcing(CGAL::Scene_profile profile, Arithmetic_tier tier)
{
  return refusal([&] { profile.force_tier(tier); });
}

std::string text_of(const CGAL::Scene_profile& profile)
{
  std::ostringstream text;
  text << profile;
  return text.str();
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

} // namespace

// --- the limits of tiers

BOOST_AUTO_TEST_CASE(pairs_at_the_limits_of_double)
{
  check_limit<Plane>(2, 67108864, 1, Arithmetic_tier::DOUBLE);
  check_limit<Plane>(2, 67108865, 1, Arithmetic_tier::INT64);
  check_limit<Space>(3, 54794158, 1, Arithmetic_tier::DOUBLE);
  check_limit<Space>(3, 54794159, 1, Arithmetic_tier::INT64);
}

BOOST_AUTO_TEST_CASE(pairs_at_the_limits_of_int64)
{
  check_limit<Plane>(2, 2147483647, 1, Arithmetic_tier::INT64);
  check_limit<Plane>(2, 2147483648, 1, Arithmetic_tier::INT128);
  check_limit<Space>(3, 1753413056, 1, Arithmetic_tier::INT64);
  check_limit<Space>(3, 1753413057, 1, Arithmetic_tier::INT128);
}

BOOST_AUTO_TEST_CASE(pairs_at_the_limits_of_int128)
{
  const double limit = std::ldexp(1., 63);
  check_limit<Plane>(2, limit - 1024, 1024, Arithmetic_tier::INT128);
  check_limit<Plane>(2, limit, 2048, Arithmetic_tier::FILTERED_EXACT);
  check_limit<Space>(3, limit - 1024, 1024, Arithmetic_tier::INT128);
  check_limit<Space>(3, limit, 2048, Arithmetic_tier::FILTERED_EXACT);
}

// Up to 53 bits, differences are taken in doubles, and above modulo 2^64.
BOOST_AUTO_TEST_CASE(pairs_where_differences_are_no_longer_doubles)
{
  const double limit = std::ldexp(1., 53);
  for(const double units : {limit - 1, limit, limit + 2}) {
    check_limit<Plane>(2, units, 2, Arithmetic_tier::INT128);
    check_limit<Space>(3, units, 2, Arithmetic_tier::INT128);
  }
}

// Steps of 2^-1074, and the largest numbers.
BOOST_AUTO_TEST_CASE(grids_at_the_ends_of_the_doubles)
{
  for(const int exponent : {-1074, -1000, 960}) {
    Points points = lattice_points(2, 12, std::ldexp(3., exponent));
    points.push_back({std::ldexp(1., exponent), 0});
    check_tiers<Plane>(points, std::ldexp(15., exponent), Arithmetic_tier::INT64);
  }
}

// The search divides all coordinates by 2^600. One of them becomes the least normal number then,
// and another one is rounded to it. So the two points, which differ along both axes, seem to be
// within the bound.
BOOST_AUTO_TEST_CASE(ties_of_coordinates_that_are_scaled_to_the_least_normal_number)
{
  const double r = 0x1p600, x = 0x1p-422;
  Points points = {{std::nextafter(x, 0.), r}, {x, 2 * r}};
  for(int i = 0; i < 400; ++i)
    points.push_back({3.7 * r * (i + 2), r});
  const auto made = make_points<Plane>(points);
  CGAL::Scene_profile profile;
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    BOOST_CHECK(pairs_with(profile, made, CGAL::within_distance(r)).empty());
  }
}

// The squares of all differences vanish, so that no filter keeps far points from the integers.
BOOST_AUTO_TEST_CASE(differences_of_a_multiple_of_2_to_64_steps_are_not_zero)
{
  const double step = 5e-324, reach = std::ldexp(step, 55);
  for(int axis = 0; axis < 2; ++axis) {
    Points points = lattice_points(2, 4, reach / 2);
    points.push_back({step, 0});
    for(const Coordinates& c : lattice_points(2, 3, reach / 2)) {
      points.push_back(c);
      points.back()[axis] += std::ldexp(step, 64);
    }
    check_tiers<Plane>(points, reach, Arithmetic_tier::INT128);

    // Whether a sweep asks for such a pair depends on its lanes.
    const internal::Squared_bound<internal::Exact_number_t<double>> bound(
      CGAL::within_distance(reach));
    const auto made = make_points<Plane>(points);
    const internal::Numbered_elements<std::vector<Kernel::Point_2>> elements(made);
    const internal::Is_within_distance<Kernel::Point_2> is_within(
      bound, internal::scan_points(elements, "point"),
      Arithmetic_tier::INT128);
    BOOST_CHECK(!is_within(made[0], made[17]));
  }
}

// --- what a scene does not need

BOOST_AUTO_TEST_CASE(a_denormal_outlier_falls_back_to_the_filter)
{
  Points points = lattice_points(2, 15, 1);
  BOOST_CHECK(CGAL::profile_scene(make_points<Plane>(points), CGAL::within_distance(5)).tier()
              == Arithmetic_tier::DOUBLE);
  points.push_back({5e-324, 3});
  check_tiers<Plane>(points, 5, Arithmetic_tier::FILTERED_EXACT);
}

BOOST_AUTO_TEST_CASE(coordinates_that_all_points_share_need_no_grid)
{
  Points points = lattice_points(2, 15, 1);
  for(Coordinates& c : points)
    c.insert(c.begin() + 1, 0.1);
  check_tiers<Space>(points, 5, Arithmetic_tier::DOUBLE);
}

BOOST_AUTO_TEST_CASE(flat_scenes_have_the_pairs_of_brute_force)
{
  const Points flat = clustered_points(2, 500, 7, 1. / 32, 3);
  for(int axis = 0; axis < 3; ++axis) {
    Points plane = flat, line = flat;
    for(std::size_t i = 0; i < flat.size(); ++i) {
      plane[i].insert(plane[i].begin() + axis, -0.3);
      line[i] = Coordinates(3, 0.7);
      line[i][axis] = flat[i][0];
    }
    check_tiers<Space>(plane, 0.1, Arithmetic_tier::INT128);
    check_tiers<Space>(line, 0.01, Arithmetic_tier::INT128);
  }
}

// --- grid and box

BOOST_AUTO_TEST_CASE(profile_finds_grid_and_box)
{
  const std::vector<Kernel::Point_2> points = {{0.5, 1024}, {-3, 0.375}, {0, 0}};
  const CGAL::Scene_profile profile = CGAL::profile_scene(points, CGAL::within_distance(2));
  BOOST_CHECK_EQUAL(profile.size(), 3u);
  BOOST_CHECK_EQUAL(profile.dimension(), 2);
  BOOST_CHECK_EQUAL(profile.grid_exponent(), -3);
  BOOST_CHECK_EQUAL(profile.units(), 16);
  BOOST_CHECK_EQUAL(profile.range(0).first, -3);
  BOOST_CHECK_EQUAL(profile.range(1).second, 1024);
  BOOST_CHECK_EQUAL(profile.bits(), 9);
  BOOST_CHECK(contains(text_of(profile), "arithmetic  double\n"));

  const std::vector<Kernel::Point_2> denormal = {{5e-324, 1}, {0, 0}};
  const auto fine = CGAL::profile_scene(denormal, CGAL::within_distance(1));
  BOOST_CHECK_EQUAL(fine.grid_exponent(), -1074);
  BOOST_CHECK(fine.tier() == CGAL::Arithmetic_tier::FILTERED_EXACT);
  const std::vector<Kernel::Point_2> zeros = {{0, 0}, {-0., 0}};
  BOOST_CHECK(CGAL::profile_scene(zeros, CGAL::within_distance(1)).tier()
              == CGAL::Arithmetic_tier::DOUBLE);
}

// --- forcing, counting, printing

BOOST_AUTO_TEST_CASE(a_tier_that_is_not_exact_is_refused_by_name)
{
  const auto points = make_points<Plane>(lattice_points(2, 5, 0.1));
  const auto bound = CGAL::within_distance(0.1);
  const CGAL::Scene_profile profile = CGAL::profile_scene(points, bound);
  BOOST_CHECK(profile.tier() == Arithmetic_tier::INT128);
  const std::string message = message_of_forcing(profile, Arithmetic_tier::INT64);
  BOOST_CHECK_MESSAGE(contains(message, "'int64'") && contains(message, "'int128'"), message);
  BOOST_CHECK_EQUAL(message_of_forcing(profile, Arithmetic_tier::FILTERED_EXACT), "");

  // Not even if the profile is that of another scene.
  CGAL::Scene_profile other
    = CGAL::profile_scene(make_points<Plane>(lattice_points(2, 3, 1)), CGAL::within_distance(1));
  other.force_tier(Arithmetic_tier::DOUBLE);
  BOOST_CHECK_THROW(pairs_with(other, points, bound), std::invalid_argument);
  BOOST_CHECK_EQUAL(other.size(), 9u); // as it was

  // Coordinates that are no doubles have no grid.
  CGAL::Scene_profile of_rationals;
  of_rationals.force_tier(Arithmetic_tier::INT128);
  BOOST_CHECK_THROW(pairs_with(of_rationals, with_a_third(lattice_points(2, 3, 1)), bound),
                    std::invalid_argument);
}

// The doubles decide all but the ties at the bound.
BOOST_AUTO_TEST_CASE(decisions_are_counted_by_tier)
{
  const Points scene = lattice_points(2, 28, 87654321);
  const auto points = make_points<Plane>(scene);
  const double r = 5 * 87654321.;
  const Truth truth = brute_force(scene, Radius::of_length(r));
  BOOST_REQUIRE_EQUAL(truth.boundary, 3688u);
  for(const Arithmetic_tier tier : {Arithmetic_tier::INT64, Arithmetic_tier::INT128,
                                    Arithmetic_tier::FILTERED_EXACT})
    for(const bool is_open : {false, true}) {
      CGAL::Scene_profile profile;
      profile.force_tier(tier);
      const auto bound = CGAL::within_distance(r);
      pairs_with(profile, points, is_open ? bound.open() : bound);
      for(const Arithmetic_tier each : all_tiers)
        BOOST_CHECK_EQUAL(profile.decided(each), each == Arithmetic_tier::DOUBLE
                                                   ? truth.open_pairs.size()
                                                   : each == tier ? truth.boundary : 0);
    }

  CGAL::Scene_profile profile;
  pairs_with(profile, points, CGAL::within_distance(1e12)); // each pair, without a search
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::DOUBLE), 784u * 783 / 2);
  pairs_with(profile, points, CGAL::within_distance(1)); // the counts are those of one search
  for(const Arithmetic_tier each : all_tiers)
    BOOST_CHECK_EQUAL(profile.decided(each), 0u);
}

// Squares overflow or underflow, and the extent of a scene may overflow as well. Ties are at the
// bound on a lattice. Uniform points hardly have any.
template <class Maker>
void check_magnitude(int dimension, double side)
{
  const double center = side > 1e300 ? 0 : side / 2;
  Points scene = uniform_points(dimension, 1500, -0.5, 1, 9);
  for(Coordinates& p : scene)
    for(double& x : p)
      x = center + x * side;
  const double r = side * (dimension == 2 ? 0.02 : 0.06);
  const Truth truth = brute_force(scene, Radius::of_length(r));
  BOOST_REQUIRE_GT(truth.pairs.size(), 500u);
  CGAL::Scene_profile profile;
  const auto bound = CGAL::within_distance(r);
  BOOST_CHECK(pairs_with(profile, make_points<Maker>(scene), bound) == truth.pairs);
  BOOST_CHECK_LE(profile.decided(Arithmetic_tier::FILTERED_EXACT), 2u);

  const Points lattice = lattice_points(dimension, dimension == 2 ? 20 : 7, side / 32);
  const auto lattice_bound = CGAL::within_distance(side / 32 * 5);
  check_tiers<Maker>(lattice, side / 32 * 5,
                     CGAL::profile_scene(make_points<Maker>(lattice), lattice_bound).tier());
}

BOOST_AUTO_TEST_CASE(scenes_of_all_magnitudes_are_decided_by_doubles)
{
  for(const double side : {1e-320, 1e-306, 1e-200, 1e-150, 1e150, 1e160, 1e200, 1e300, 1.7e308}) {
    BOOST_TEST_CONTEXT("side " << side)
    {
      check_magnitude<Plane>(2, side);
      check_magnitude<Space>(3, side);
    }
  }
}

// Like doubles if they are, by exact numbers if a single one is not.
BOOST_AUTO_TEST_CASE(exact_coordinates_that_are_doubles_have_a_grid)
{
  check_limit<Rational_plane>(2, 67108864, 1, Arithmetic_tier::DOUBLE);
  check_limit<Rational_plane>(2, 2147483647, 1, Arithmetic_tier::INT64);
  check_limit<Rational_plane>(2, 2147483648, 1, Arithmetic_tier::INT128);

  const Points scene = lattice_points(2, 10, 0.1);
  const Truth truth = brute_force(scene, Radius::of_length(0.5));
  CGAL::Scene_profile profile;
  BOOST_CHECK(pairs_with(profile, make_points<Rational_plane>(scene), CGAL::within_distance(0.5))
              == truth.pairs);
  BOOST_CHECK(profile.tier() == Arithmetic_tier::INT128);
  BOOST_CHECK_GE(profile.decided(Arithmetic_tier::INT128), truth.boundary);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::FILTERED_EXACT), 0u);

  BOOST_CHECK(pairs_with(profile, with_a_third(scene), CGAL::within_distance(0.5)) == truth.pairs);
  BOOST_CHECK(!profile.has_grid());
  BOOST_CHECK_GE(profile.decided(Arithmetic_tier::FILTERED_EXACT), truth.boundary);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::INT128), 0u);
  BOOST_CHECK_GE(profile.decided(Arithmetic_tier::DOUBLE)
                   + profile.decided(Arithmetic_tier::FILTERED_EXACT),
                 truth.pairs.size());
}

BOOST_AUTO_TEST_CASE(decisions_are_counted_for_two_sets)
{
  CGAL::Scene_profile profile;
  const auto points = make_points<Plane>(lattice_points(2, 10, 1));
  std::size_t pairs = 0;
  CGAL::fixed_radius_near_neighbors(points, points, CGAL::within_distance(1),
                                    [&](std::size_t, std::size_t) { ++pairs; }, profile);
  BOOST_CHECK_EQUAL(pairs, 100u + 2 * 180);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::DOUBLE), pairs);
  BOOST_CHECK_EQUAL(profile.size(), 200u);
}

// By the recursive route.
BOOST_AUTO_TEST_CASE(tiers_in_dimension_4)
{
  const Points scene = lattice_points(4, 4, 87654321);
  std::vector<CGAL::Cartesian_d<double>::Point_d> points;
  for(const Coordinates& c : scene)
    points.emplace_back(4, c.begin(), c.end());
  const double r = 2 * 87654321.;
  const Truth truth = brute_force(scene, Radius::of_length(r));
  for(const Arithmetic_tier tier : {Arithmetic_tier::INT64, Arithmetic_tier::INT128,
                                    Arithmetic_tier::FILTERED_EXACT}) {
    CGAL::Scene_profile profile;
    profile.force_tier(tier);
    BOOST_CHECK(pairs_with(profile, points, CGAL::within_distance(r)) == truth.pairs);
    BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::DOUBLE), truth.open_pairs.size());
    BOOST_CHECK_EQUAL(profile.decided(tier), truth.boundary);
  }
}

// Searches by slabs in the plane, and tells how they held coordinates.
std::string coordinates_of_search(const Points& points, double r)
{
  CGAL::Scene_profile profile;
  pairs_with(profile, make_points<Plane>(points), CGAL::within_distance(r));
  return std::to_string(profile.coordinate_bits())
         + (profile.are_coordinates_rounded() ? ", rounded" : "");
}

BOOST_AUTO_TEST_CASE(the_profile_tells_how_coordinates_were_held)
{
  const Points uniform = uniform_points(2, 1000, 0, 1, 1);
  BOOST_CHECK_EQUAL(coordinates_of_search(lattice_points(2, 30, 1), 5), "32");
  BOOST_CHECK_EQUAL(coordinates_of_search(uniform, 0.01), "32, rounded");
  BOOST_CHECK_EQUAL(coordinates_of_search(uniform, 1e-8), "64");
  BOOST_CHECK_EQUAL(coordinates_of_search(lattice_points(2, 30, 0.1), 0.1), "64"); // many ties
  CGAL::Scene_profile profile;
  const double zeros[4] = {};
  const std::vector<CGAL::Cartesian_d<double>::Point_d> points(2, {4, zeros, zeros + 4});
  pairs_with(profile, points, CGAL::within_distance(1));
  BOOST_CHECK_EQUAL(profile.coordinate_bits(), 0); // no slabs
  BOOST_CHECK(!profile.are_coordinates_rounded());
}

BOOST_AUTO_TEST_CASE(the_report_ends_in_a_sentence)
{
  CGAL::Scene_profile profile;
  const auto points = make_points<Plane>({{0, 0}, {3, 4}});
  pairs_with(profile, points, CGAL::within_distance(4096));
  BOOST_CHECK_MESSAGE(ends_with(text_of(profile), "\narithmetic  double\n"
                                                  "coordinates 32 bits, exact\n"
                                                  "decided     1 by double\n"
                                                  "25 bits: double is exact, no filter used.\n"),
                      text_of(profile));
  profile.force_tier(Arithmetic_tier::INT64);
  pairs_with(profile, points, CGAL::within_distance(5));
  BOOST_CHECK_MESSAGE(
    ends_with(text_of(profile), "\narithmetic  int64, forced\n"
                                "coordinates 32 bits, rounded\n"
                                "decided     1 by int64\n"
                                "6 bits: doubles filter, 64-bit integers decide the rest.\n"),
    text_of(profile));
  BOOST_CHECK(ends_with(text_of(CGAL::Scene_profile()), "double is exact, no filter used.\n"));
  const double infinity = std::numeric_limits<double>::infinity();
  const std::string all = text_of(CGAL::profile_scene(points, CGAL::within_distance(infinity)));
  BOOST_CHECK_MESSAGE(ends_with(all, "\ndoubles filter, exact numbers decide the rest.\n"), all);
}
