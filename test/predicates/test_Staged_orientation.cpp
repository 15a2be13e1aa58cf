// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The orientation of points against rational numbers: random, nearly degenerate and extreme points,
// in every rounding mode, by every arithmetic.

#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>

#include <CGAL/Simple_cartesian.h>

BOOST_AUTO_TEST_SUITE(Staged_orientation)

using namespace test_support;
using CGAL::Arithmetic_tier;

using Space = internal::Staged_orientation<3>;
using Rational_point = CGAL::Simple_cartesian<CGAL::Exact_rational>::Point_3;

using Doubles = std::array<double, 3>;
using Four_points = std::array<Doubles, 4>;

constexpr Arithmetic_tier all_tiers[]
  = {Arithmetic_tier::INT64, Arithmetic_tier::INT128, Arithmetic_tier::INT192,
     Arithmetic_tier::FILTERED_EXACT};

Rational_point exact(const Doubles& p) { return Rational_point(p[0], p[1], p[2]); }

CGAL::Sign expected_side(const Four_points& p)
{
  return CGAL::orientation(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
}

CGAL::Sign expected_turn(const Four_points& p)
{
  using Point = CGAL::Simple_cartesian<CGAL::Exact_rational>::Point_2;
  const auto projection = [&](std::size_t k) { return Point(p[k][0], p[k][1]); };
  return CGAL::orientation(projection(0), projection(1), projection(2));
}

// What the package says, and the arithmetic that it took.
struct Answer
{
  CGAL::Sign side;
  CGAL::Sign turn;
  Arithmetic_tier tier;
};

Answer answer(const Four_points& p, Arithmetic_tier least_tier)
{
  Space::Vertices<4> vertices;
  for(std::size_t k = 0; k < 4; ++k)
    vertices[k].x = p[k];
  const auto point = [&](std::size_t k) { return Space::Point(vertices[k]); };
  Space orientation(vertices, least_tier);
  const CGAL::Sign side
    = orientation.side(orientation.plane(point(0), point(1), point(2)), point(3));
  const Arithmetic_tier tier = orientation.needed_tier();
  return {side, orientation.orientation(point(0), point(1), point(2), 0, 1), tier};
}

// The last two points are affine combinations of the others, rounded, and often moved by a last
// bit. Each axis has a scale of its own.
Four_points nearly_flat_points(Random& random, const std::array<int, 3>& exponents)
{
  Four_points p;
  const double s = random.uniform(), t = random.uniform();
  for(std::size_t axis = 0; axis < 3; ++axis) {
    for(std::size_t k = 0; k < 2; ++k)
      p[k][axis] = random.uniform();
    const double on_line = p[0][axis] + s * (p[1][axis] - p[0][axis]);
    p[2][axis] = random.below(2) == 0 ? random.uniform() : on_line;
    p[3][axis] = on_line + t * (p[2][axis] - p[0][axis]);
    if(random.below(4) == 0)
      p[3][axis] = std::nextafter(p[3][axis], 9. * static_cast<double>(random.below(2)));
    for(Doubles& point : p)
      point[axis] = std::ldexp(point[axis], exponents[axis]);
  }
  return p;
}

// Multiples of .1 and integers: many are in a plane, and many are equal.
Four_points lattice_points(Random& random, double unit)
{
  Four_points p;
  for(Doubles& point : p)
    for(double& x : point)
      x = unit * static_cast<double>(random.below(4));
  return p;
}

std::size_t count_wrong(const Four_points& p)
{
  std::size_t wrong = 0;
  const CGAL::Sign side = expected_side(p), turn = expected_turn(p);
  for(const int mode : rounding_modes)
    for(const Arithmetic_tier tier : all_tiers) {
      const Rounding_mode rounding(mode);
      const Answer found = answer(p, tier);
      wrong += found.side != side || found.turn != turn;
    }
  return wrong;
}

BOOST_AUTO_TEST_CASE(signs_are_those_of_rational_numbers)
{
  Random random(1);
  std::size_t wrong = 0;
  const std::array<int, 3> exponents[]
    = {{0, 0, 0}, {-1070, -1060, -1050}, {1020, 1021, 1022}, {-1000, 1000, 3}, {-400, -320, -340},
       {-500, 900, -600}, {-700, 700, 700}};
  for(int i = 0; i < 300; ++i) {
    for(const std::array<int, 3>& e : exponents)
      wrong += count_wrong(nearly_flat_points(random, e));
    for(const double unit : {1., 0.1, 0x1p-1074, 0x1p1020})
      wrong += count_wrong(lattice_points(random, unit));
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
}

// Beside the line through two points that are far away, where differences are rounded (L. Kettner
// et al., Classroom examples of robustness problems in geometric computations, 2008).
BOOST_AUTO_TEST_CASE(turns_beside_a_line_are_those_of_rational_numbers)
{
  std::size_t wrong = 0;
  for(int i = 0; i < 32; ++i)
    for(int j = 0; j < 32; ++j) {
      const double x = 0.5 + i * 0x1p-53, y = 0.5 + j * 0x1p-53;
      wrong += count_wrong({{{x, y, 0}, {8.1, 8.1, 1}, {17.3, 17.3, 0}, {x, y, 1}}});
    }
  BOOST_CHECK_EQUAL(wrong, 0u);
}

// Exponents within an axis differ too much for integers.
BOOST_AUTO_TEST_CASE(coordinates_of_all_sizes_take_exact_numbers)
{
  Random random(2);
  std::size_t wrong = 0, exact_count = 0;
  for(int i = 0; i < 500; ++i) {
    Four_points p = lattice_points(random, 1);
    for(Doubles& point : p)
      for(double& x : point)
        x = std::ldexp(x, static_cast<int>(random.below(2090)) - 1070);
    wrong += count_wrong(p);
    exact_count += answer(p, Arithmetic_tier::INT64).tier == Arithmetic_tier::FILTERED_EXACT;
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(exact_count, 10u);
}

// Four points of a plane, with differences of so many bits.
Four_points flat_points(int bits)
{
  const double a = std::ldexp(1., bits) - 1;
  return {{{0, 0, 0}, {a, 1, a}, {1, a, a}, {a + 1, a + 1, 2 * a}}};
}

BOOST_AUTO_TEST_CASE(no_more_bits_are_used_than_the_points_need)
{
  const auto tier_of = [](const Four_points& p) { return answer(p, Arithmetic_tier::INT64).tier; };
  BOOST_CHECK(tier_of(flat_points(18)) == Arithmetic_tier::INT64);
  BOOST_CHECK(tier_of(flat_points(21)) == Arithmetic_tier::INT128);
  BOOST_CHECK(tier_of(flat_points(39)) == Arithmetic_tier::INT128);
  BOOST_CHECK(tier_of(flat_points(43)) == Arithmetic_tier::INT192);
  BOOST_CHECK(tier_of(flat_points(51)) == Arithmetic_tier::INT192);
  BOOST_CHECK(tier_of({{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}}}) == Arithmetic_tier::INT64);
  BOOST_CHECK(tier_of({{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}}}) == Arithmetic_tier::DOUBLE);
  BOOST_CHECK(tier_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 2}}}) == Arithmetic_tier::DOUBLE);
}

BOOST_AUTO_TEST_CASE(exact_numbers_are_used_where_they_are_asked_for)
{
  const Answer found = answer(flat_points(21), Arithmetic_tier::FILTERED_EXACT);
  BOOST_CHECK(found.side == CGAL::ZERO);
  BOOST_CHECK(found.tier == Arithmetic_tier::FILTERED_EXACT);
}

// As neighbors in meshes have.
BOOST_AUTO_TEST_CASE(equal_points_take_no_integers)
{
  Random random(5);
  for(const auto& [i, j] : {std::pair<std::size_t, std::size_t>(0, 1), {1, 2}, {0, 2}}) {
    Four_points p = nearly_flat_points(random, {0, 0, 0});
    p[j] = p[i];
    Space::Vertices<3> vertices;
    for(std::size_t k = 0; k < 3; ++k)
      vertices[k].x = p[k];
    Space orientation(vertices);
    BOOST_CHECK(orientation.orientation(Space::Point(vertices[0]), Space::Point(vertices[1]),
                                        Space::Point(vertices[2]), 0, 1) == CGAL::ZERO);
    BOOST_CHECK(orientation.needed_tier() == Arithmetic_tier::DOUBLE);
    Four_points q = nearly_flat_points(random, {0, 0, 0});
    q[3] = q[i];
    const Answer found = answer(q, Arithmetic_tier::INT64);
    BOOST_CHECK(found.side == CGAL::ZERO);
    BOOST_CHECK(found.tier == Arithmetic_tier::DOUBLE);
  }
}

BOOST_AUTO_TEST_CASE(certified_doubles_take_nothing_else)
{
  Random random(3);
  std::size_t wrong = 0;
  for(int i = 0; i < 2000; ++i) {
    const Four_points p = lattice_points(random, i % 2 == 0 ? 1 : 0x1p-350);
    const Answer found = answer(p, Arithmetic_tier::DOUBLE);
    wrong += found.side != expected_side(p) || found.turn != expected_turn(p)
             || found.tier != Arithmetic_tier::DOUBLE;
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
}

BOOST_AUTO_TEST_SUITE_END()
