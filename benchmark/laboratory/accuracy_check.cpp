// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the laboratory must find each time: no wrong pair in our columns, known numbers of wrong
// pairs in those of others, and the steps of the precision staircase where the degrees put them.

#include <boost/test/unit_test.hpp>

#include "staircase.h"
#include "wrong_pairs.h"

#include "support/brute_force.h"
#include "support/robustness_families.h"

namespace {

using namespace test_support;

// ---- families -----------------------------------------------------------------------------------

void check_our_columns(int dimension)
{
  for(const Point_scene& scene : robustness_families(dimension))
    for(const lab::Column& column : lab::package_columns()) {
      const lab::Outcome outcome = find_in_child(column, lab::scene_of(scene), 60);
      const Pairs_difference wrong = wrong_pairs(outcome, truth_of(scene).pairs);
      BOOST_TEST_CONTEXT(column.name << " on " << scene << ": " << wrong)
      {
        BOOST_TEST(outcome.status == "ok");
        BOOST_TEST(wrong.empty());
        BOOST_TEST(count_asymmetric(outcome.found) == 0u);
      }
    }
}

Pairs_difference wrong_pairs_of(const std::string& name, int dimension, const std::string& family)
{
  for(const Point_scene& scene : robustness_families(dimension))
    if(scene.name == family)
      for(const lab::Column& column : lab::plain_columns())
        if(column.name == name)
          return wrong_pairs(find_in_child(column, lab::scene_of(scene), 60),
                             truth_of(scene).pairs);
  throw std::invalid_argument(name + " on " + family);
}

// ---- the staircase ------------------------------------------------------------------------------

// The highest precision with a wrong answer, 0 if there is none.
template <class Predicate>
int last_wrong_precision(int input_bits, bool is_near)
{
  int last = 0;
  lab::for_each_precision(
    lab::Questions<Predicate>(input_bits, is_near, 1000),
    [&](int precision, std::size_t wrong) { last = wrong > 0 ? precision : last; },
    lab::Precisions());
  return last;
}

// Wrong up to nearly `degree` times the bits of the input, right from the bound of theory on.
template <class Predicate>
void check_step()
{
  for(int input_bits : {16, 24})
    BOOST_TEST_CONTEXT(Predicate::name << " on input of " << input_bits << " bits")
    {
      const int last = last_wrong_precision<Predicate>(input_bits, true);
      BOOST_TEST(last >= Predicate::degree * (input_bits - 4));
      BOOST_TEST(last < Predicate::bits(input_bits));
      BOOST_TEST(last_wrong_precision<Predicate>(input_bits, false) <= 24);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(our_columns_are_zero_in_the_plane)
{
  check_our_columns(2);
}

BOOST_AUTO_TEST_CASE(our_columns_are_zero_in_space)
{
  check_our_columns(3);
}

// Numbers that were counted independently, in rational arithmetic.
BOOST_AUTO_TEST_CASE(other_columns_are_as_known)
{
  const std::string family = "lattice 0.1 i, r = 0.5 or 0.3";
  BOOST_TEST(wrong_pairs_of("double", 2, family).extra.size() == 244u);
  BOOST_TEST(wrong_pairs_of("double, sqrt", 2, family).extra.size() == 688u);
  BOOST_TEST(wrong_pairs_of("double, hypot", 2, family).extra.size() == 636u);
  BOOST_TEST(wrong_pairs_of("long double", 2, family).extra.size() == 120u);
  BOOST_TEST(wrong_pairs_of("float", 2, family).missing.size() == 240u);
  BOOST_TEST(wrong_pairs_of("float", 2, family).extra.size() == 928u);
  BOOST_TEST(wrong_pairs_of("double", 3, family).extra.size() == 752u);
  BOOST_TEST(wrong_pairs_of("grid, x * (1 / r)", 2, "collinear 49 i, r = 49").missing.size() == 8u);
  BOOST_TEST(wrong_pairs_of("grid, x / r", 2, "collinear 49 i, r = 49").missing.size() == 0u);
  BOOST_TEST(wrong_pairs_of("double", 2, "unit lattice, r^2 = 13").missing.size() == 2600u);
}

BOOST_AUTO_TEST_CASE(a_method_that_crashes_is_reported_as_crashed)
{
  const lab::Scene scene = lab::scene_of(robustness_families(2).front());
  const lab::Column crashing{{"crashing", [](const lab::Scene&) -> lab::Run<lab::Found> {
                                std::raise(SIGFPE);
                                return {};
                              }},
                             "form"};
  BOOST_TEST(find_in_child(crashing, scene, 10).status == "SIGFPE");
}

BOOST_AUTO_TEST_CASE(steps_of_the_staircase_are_where_the_degrees_put_them)
{
  check_step<lab::Compare_x>();
  check_step<lab::Compare_distance>();
  check_step<lab::Compare_distance_of_disks>();
  check_step<lab::Side_of_circle>();
  check_step<lab::Side_of_sphere>();
}
