// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tests of the tests: brute force agrees with CGAL's boxes and Delaunay triangulations, the scenes
// have the number of pairs they claim, and decimals are read exactly. That data files are read as
// those who counted their pairs read them, test_data shows.

#include "box_oracle.h"
#include "check_pairs.h"
#include "counting_allocator.h"
#include "data_facts.h"
#include "delaunay_oracle.h"
#include "lattice_counts.h"
#include "mpfr_kernel_number.h"
#include "scenes.h"

#include <CGAL/Simple_cartesian.h>

using namespace test_support;

namespace {

void check_count(const std::string& what, std::size_t expected, std::size_t found)
{
  BOOST_CHECK_MESSAGE(expected == found, what << ": expected " << expected << ", found " << found);
}

} // namespace

BOOST_AUTO_TEST_CASE(difference_of_pairs_is_one_of_multisets)
{
  const Pairs once = {{0, 1}, {2, 3}};
  const Pairs_difference difference = compare(once, {{4, 5}, {0, 1}, {0, 1}});
  BOOST_CHECK((difference.missing == Pairs{{2, 3}}));
  BOOST_CHECK((difference.extra == Pairs{{0, 1}, {4, 5}}));
  BOOST_CHECK(!difference.empty());
  BOOST_CHECK(compare(once, {{2, 3}, {0, 1}}).empty());
  std::ostringstream out;
  out << compare(Pairs(12, Pair(7, 8)), {});
  BOOST_CHECK(out.str().find("12 missing (7, 8)") == 0);
  BOOST_CHECK(out.str().find("...; 0 extra") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(random_points_are_those_of_the_first_day)
{
  // The 10000th number of the default seed is fixed by the standard.
  Random random(5489);
  for(int i = 0; i < 9999; ++i)
    random.below(1);
  BOOST_CHECK_EQUAL(random.below(static_cast<std::size_t>(-1)), 9981545732273789042u);
  BOOST_CHECK_EQUAL(uniform_points(1, 1, 0, 1, 11)[0][0], Random(11).uniform());
}

BOOST_AUTO_TEST_CASE(scenes_have_distinct_names_and_their_dimension)
{
  for(int d : {1, 2, 3, 5}) {
    std::set<std::string> names;
    for(const Point_scene& scene : small_scenes(d)) {
      BOOST_CHECK_MESSAGE(names.insert(scene.name).second, scene << " occurs twice");
      BOOST_CHECK_MESSAGE(scene.points.size() <= 800, scene << " is large");
      for(const Coordinates& p : scene.points)
        BOOST_REQUIRE_MESSAGE(p.size() == static_cast<std::size_t>(d), scene);
    }
  }
}

BOOST_AUTO_TEST_CASE(random_scenes_have_pairs_but_not_all)
{
  for(int d : {1, 2, 3, 4, 5})
    for(const Point_scene& scene : small_scenes(d))
      if(scene.name == "uniform" || scene.name == "clustered") {
        const std::size_t n = scene.points.size(), k = truth_of(scene).pairs.size();
        BOOST_CHECK_MESSAGE(n / 4 < k && k < 40 * n, scene << ": k = " << k);
      }
}

BOOST_AUTO_TEST_CASE(brute_force_knows_the_boundary)
{
  const Points two = two_points_at_five(3);
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_length(5)).boundary, 1u);
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_square("25")).boundary, 1u);
  BOOST_CHECK(brute_force(two, Radius::of_length(5)).open_pairs.empty());
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_square("51/2")).boundary, 0u);
  BOOST_CHECK_EQUAL(brute_force(two, Radius::of_square("51/2")).open_pairs.size(), 1u);
  BOOST_CHECK(brute_force(two, Radius::of_length(std::nextafter(5., 0.))).pairs.empty());
}

BOOST_AUTO_TEST_CASE(oracles_agree)
{
  for(int d : {2, 3})
    for(const Point_scene& scene : all_scenes(d)) {
      check_pairs(scene, truth_of(scene).pairs, box_pairs(scene));
      check_pairs(scene, truth_of(scene).pairs, delaunay_pairs(scene));
    }
}

BOOST_AUTO_TEST_CASE(families_have_the_counts_of_the_table)
{
  std::size_t checked = 0;
  for(int d : {2, 3})
    for(const Point_scene& scene : robustness_families(d)) {
      if(!scene.expected)
        continue;
      const Truth& truth = truth_of(scene);
      check_count(scene.name + ", pairs", scene.expected->pairs, truth.pairs.size());
      check_count(scene.name + ", boundary", scene.expected->on_boundary, truth.boundary);
      ++checked;
    }
  BOOST_CHECK_EQUAL(checked, 42u);
}

BOOST_AUTO_TEST_CASE(ties_along_the_axes_are_ties)
{
  for(int d : {2, 3})
    for(const Point_scene& scene : robustness_families(d))
      if(scene.name == "random 40-bit, ties along the axes")
        BOOST_CHECK_MESSAGE(truth_of(scene).boundary >= 160, scene << truth_of(scene).boundary);
}

BOOST_AUTO_TEST_CASE(lattice_formula_counts_what_brute_force_counts)
{
  for(int d : {1, 2, 3, 4, 5})
    for(int threshold : {0, 1, 2, 5, 9, 1000}) {
      const std::size_t m = d <= 2 ? 9 : 4;
      const Truth truth =
        brute_force(lattice_points(d, m, 1), Radius::of_square(std::to_string(threshold)));
      const Lattice_count count = lattice_count(m, d, threshold);
      BOOST_CHECK_EQUAL(count.pairs, truth.pairs.size());
      BOOST_CHECK_EQUAL(count.at_threshold, truth.boundary);
    }
}

BOOST_AUTO_TEST_CASE(doubles_of_a_file_are_exact_or_refused)
{
  const auto doubles = as_exact_doubles(scaled_to_integers({{"1.25", "-3"}}));
  BOOST_REQUIRE(doubles.has_value());
  BOOST_CHECK((*doubles == Double_rows{{125, -300}}));
  BOOST_CHECK(!as_exact_doubles(scaled_to_integers({{"9007199254740993"}})));
}

BOOST_AUTO_TEST_CASE(lattice_formula_gives_the_large_figures)
{
  BOOST_CHECK_EQUAL(lattice_count(1000, 2, 25).pairs, 39826168u);
  BOOST_CHECK_EQUAL(lattice_count(100, 3, 9).pairs, 58922124u);
  BOOST_CHECK_EQUAL(lattice_count(28, 2, 25).at_threshold, 3688u);
}

BOOST_AUTO_TEST_CASE(decimals_are_scaled_exactly)
{
  BOOST_CHECK_EQUAL(scaled_decimal("-0.0832331", 8), -8323310);
  BOOST_CHECK_EQUAL(scaled_decimal("+12.5e-3", 5), 1250);
  BOOST_CHECK_EQUAL(scaled_decimal("2.5E3", 0), 2500);
  BOOST_CHECK_EQUAL(scaled_decimal("1.500", 1), 15);
  BOOST_CHECK_EQUAL(scaled_decimal("0", 3), 0);
  BOOST_CHECK_THROW(scaled_decimal("1.55", 1), std::invalid_argument);
  BOOST_CHECK_THROW(parse_decimal("abc"), std::invalid_argument);
  BOOST_CHECK_THROW(parse_decimal(""), std::invalid_argument);
  BOOST_CHECK((split_csv_line("1,\"a \"\"b\"\", c\",,2") ==
               std::vector<std::string>{"1", "a \"b\", c", "", "2"}));
}

BOOST_AUTO_TEST_CASE(allocations_are_counted)
{
  const std::size_t before = current_bytes();
  reset_peak();
  BOOST_CHECK_EQUAL(peak_bytes(), before);
  void* bytes = ::operator new[](1000); // a new-expression may be optimised away
  BOOST_CHECK_EQUAL(current_bytes(), before + 1000);
  ::operator delete[](bytes);
  const auto alignment = static_cast<std::align_val_t>(256);
  void* wide = ::operator new(500, alignment);
  BOOST_CHECK_EQUAL(reinterpret_cast<std::uintptr_t>(wide) % 256, 0u);
  BOOST_CHECK_EQUAL(current_bytes(), before + 500);
  ::operator delete(wide, alignment);
  BOOST_CHECK_EQUAL(current_bytes(), before);
  ::operator delete(::operator new(700, std::nothrow));
  BOOST_CHECK_EQUAL(current_bytes(), before);
  BOOST_CHECK_EQUAL(peak_bytes(), before + 1000);
  BOOST_CHECK_THROW(::operator delete(::operator new(static_cast<std::size_t>(-1))),
                    std::bad_alloc);
}

BOOST_AUTO_TEST_CASE(mpfr_numbers_make_a_kernel)
{
  using Number = Mpfr_number<30>;
  using Kernel = CGAL::Simple_cartesian<Number>;
  const Kernel::Point_2 p(0, 0), q(3, 4);
  const Kernel::Point_3 u(0.5, 1, 2), v(0.5, 1, 3);
  BOOST_CHECK(Kernel().compare_x_2_object()(p, q) == CGAL::SMALLER);
  BOOST_CHECK(Kernel().compare_xyz_3_object()(u, v) == CGAL::SMALLER);
  BOOST_CHECK(CGAL::squared_distance(p, q) == 25);
  BOOST_CHECK(Kernel().compare_squared_distance_2_object()(p, q, Number(25)) == CGAL::EQUAL);
  BOOST_CHECK(CGAL::compare_squared_distance(u, v, Number(2)) == CGAL::SMALLER);
  BOOST_CHECK(CGAL::orientation(p, q, Kernel::Point_2(3, 5)) == CGAL::LEFT_TURN);
  BOOST_CHECK(CGAL::sqrt(Number(49)) == 7);
  BOOST_CHECK(CGAL::to_double(Number(0.1)) == 0.1);
  BOOST_CHECK(CGAL::is_finite(Number(1)) && !CGAL::is_finite(Number(1) / 0));
  BOOST_CHECK(!CGAL::Algebraic_structure_traits<Number>::Is_exact::value);
}

BOOST_AUTO_TEST_CASE(mpfr_intervals_enclose)
{
  using Number = Mpfr_number<30>;
  const double largest = (std::numeric_limits<double>::max)();
  BOOST_CHECK(CGAL::to_interval(Number(0.1)) == std::make_pair(0.1, 0.1));
  const Number third = Number(1) / 3;
  const auto [low, high] = CGAL::to_interval(third);
  BOOST_CHECK(low < third && third < high);
  BOOST_CHECK_EQUAL(std::nextafter(low, infinity), high);
  BOOST_CHECK(CGAL::to_interval(Number(-third)) == std::make_pair(-high, -low));
  BOOST_CHECK(CGAL::to_interval(Number(2) * largest) == std::make_pair(largest, infinity));
}
