// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a scene of objects needs: its grid and bits, every tier that is exact for it, and the counts
// of decisions.

#include "support/parallel_pairs.h"
#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/thick_intersection_d.h>

using namespace test_support;
using CGAL::Arithmetic_tier;
using CGAL::Scene_profile;

namespace {

using Triangles = std::vector<Epick::Triangle_3>;

constexpr Arithmetic_tier all_tiers[]
  = {Arithmetic_tier::DOUBLE, Arithmetic_tier::INT64, Arithmetic_tier::INT128,
     Arithmetic_tier::INT192, Arithmetic_tier::FILTERED_EXACT};

// One type of callback, because compilers make a search for each.
using Callback = std::function<void(std::size_t, std::size_t)>;

template <class ConcurrencyTag = CGAL::Sequential_tag, class Object>
Pairs pairs_with(Scene_profile& profile, const std::vector<Object>& objects)
{
  return sorted(collected([&](const Callback& callback) {
    CGAL::thick_self_intersection_d<ConcurrencyTag>(objects, callback, profile);
  }));
}

std::uint64_t decided_by_all(const Scene_profile& profile)
{
  std::uint64_t sum = 0;
  for(const Arithmetic_tier tier : all_tiers)
    sum += profile.decided(tier);
  return sum;
}

// Random triangles of integers below 2^bits, in units of 2^exponent, that nearly all meet.
Triangles random_triangles(int bits, int exponent)
{
  Random random(static_cast<unsigned int>(bits));
  const auto point = [&] {
    const auto x = [&] {
      const double least = static_cast<double>(random.below(2));
      return std::ldexp(random.below(2) == 0 ? std::ldexp(1., bits) - 1 - least : least, exponent);
    };
    const double first = x(), second = x();
    return Epick::Point_3(first, second, x());
  };
  Triangles triangles;
  for(int i = 0; i < 40; ++i) {
    const Epick::Point_3 p = point(), q = point();
    triangles.emplace_back(p, q, point());
  }
  return triangles;
}

// All tiers from `needed` on find the same pairs, and those before are refused.
void check_tiers(const Triangles& triangles, Arithmetic_tier needed)
{
  Scene_profile plain;
  const Pairs expected = pairs_with(plain, triangles);
  BOOST_CHECK(plain.needed_tier() == needed);
  BOOST_CHECK_GT(expected.size(), 50u);
  for(const Arithmetic_tier tier : all_tiers)
    BOOST_TEST_CONTEXT(tier)
    {
      Scene_profile profile;
      profile.force_tier(tier);
      if(tier < needed) {
        BOOST_CHECK_THROW(pairs_with(profile, triangles), std::invalid_argument);
        BOOST_CHECK_EQUAL(profile.size(), 0u);
      }
      else {
        BOOST_CHECK(pairs_with(profile, triangles) == expected);
        BOOST_CHECK(profile.tier() == tier);
        BOOST_CHECK_EQUAL(decided_by_all(profile), decided_by_all(plain));
        for(const Arithmetic_tier other : all_tiers)
          if(other != Arithmetic_tier::DOUBLE && other < tier && tier != Arithmetic_tier::INT192)
            BOOST_CHECK_EQUAL(profile.decided(other), 0u);
      }
    }
}

} // namespace

// Two objects whose boxes meet differ by twice the extent, which takes a bit more: b = bits + 1,
// and determinants of 3 b + 3 bits.
BOOST_AUTO_TEST_CASE(every_tier_that_is_exact_finds_the_same_pairs)
{
  check_tiers(random_triangles(15, 0), Arithmetic_tier::DOUBLE);
  check_tiers(random_triangles(15, -340), Arithmetic_tier::DOUBLE);
  check_tiers(random_triangles(15, 300), Arithmetic_tier::DOUBLE);
  check_tiers(random_triangles(15, -380), Arithmetic_tier::INT64);
  check_tiers(random_triangles(15, 400), Arithmetic_tier::INT64);
  check_tiers(random_triangles(16, 0), Arithmetic_tier::INT64);
  check_tiers(random_triangles(19, 0), Arithmetic_tier::INT64);
  check_tiers(random_triangles(20, 0), Arithmetic_tier::INT128);
  check_tiers(random_triangles(40, 0), Arithmetic_tier::INT128);
  check_tiers(random_triangles(41, 0), Arithmetic_tier::INT192);
  check_tiers(random_triangles(52, -1000), Arithmetic_tier::INT192);
}

BOOST_AUTO_TEST_CASE(differences_of_more_than_61_bits_need_exact_numbers)
{
  Triangles triangles = random_triangles(52, 0);
  triangles.emplace_back(Epick::Point_3(0x1p-12, 0, 0), Epick::Point_3(1, 0, 0),
                         Epick::Point_3(0, 1, 0));
  check_tiers(triangles, Arithmetic_tier::FILTERED_EXACT);
}

BOOST_AUTO_TEST_CASE(profile_of_segments_of_the_plane_is_printed)
{
  using Segment = Epick::Segment_2;
  using Point = Epick::Point_2;
  const std::vector<Segment> segments = {Segment(Point(0, 0), Point(3, 1.5)),
                                         Segment(Point(1, 2), Point(2, 0)),
                                         Segment(Point(3, 1.5), Point(4, 4))};
  Scene_profile profile;
  BOOST_CHECK(pairs_with(profile, segments) == Pairs({{0, 1}, {0, 2}}));
  BOOST_CHECK(profile.is_of_objects());
  BOOST_CHECK_EQUAL(profile.degree(), 2);
  std::ostringstream text;
  text << profile;
  BOOST_CHECK_EQUAL(text.str(), "objects     3 in dimension 2\n"
                                "axis 0      [0, 4]\n"
                                "axis 1      [0, 4]\n"
                                "reach       6\n"
                                "grid        2^-1\n"
                                "bits        4 for a difference, 9 for a determinant of degree 2, "
                                "a double has 53\n"
                                "arithmetic  double\n"
                                "decided     2 by double\n"
                                "9 bits: double is exact, no filter used.\n");
}

BOOST_AUTO_TEST_CASE(boxes_and_points_are_of_degree_one)
{
  const std::vector<CGAL::Bbox_3> boxes
    = {CGAL::Bbox_3(0, 0, 0, 1, 1, 0.1), CGAL::Bbox_3(1, 1, 0.1, 2, 2, 2),
       CGAL::Bbox_3(0, 0, 0.2, 1, 1, 3)};
  Scene_profile profile;
  BOOST_CHECK(pairs_with(profile, boxes) == Pairs({{0, 1}, {1, 2}}));
  BOOST_CHECK_EQUAL(profile.degree(), 1);
  BOOST_CHECK(profile.tier() == Arithmetic_tier::DOUBLE);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::DOUBLE), 2u);
  const std::vector<Epick::Point_2> points = {{0, 0.1}, {0, 0.1}, {1, 0}};
  BOOST_CHECK(pairs_with(profile, points) == Pairs({{0, 1}}));
  BOOST_CHECK_EQUAL(profile.degree(), 1);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_no_doubles_have_no_grid)
{
  const auto triangle = [](const Epeck::FT& x) {
    return Epeck::Triangle_3(Epeck::Point_3(x, 0, 0), Epeck::Point_3(x + 1, 0, 0),
                              Epeck::Point_3(x, 1, 0));
  };
  Scene_profile profile;
  const std::vector<Epeck::Triangle_3> doubles = {triangle(0), triangle(1), triangle(3)};
  BOOST_CHECK(pairs_with(profile, doubles) == Pairs({{0, 1}}));
  BOOST_CHECK(profile.has_grid());
  const std::vector<Epeck::Triangle_3> thirds
    = {triangle(0), triangle(Epeck::FT(1) / 3), triangle(3)};
  BOOST_CHECK(pairs_with(profile, thirds) == Pairs({{0, 1}}));
  BOOST_CHECK(!profile.has_grid());
  BOOST_CHECK(profile.tier() == Arithmetic_tier::FILTERED_EXACT);
  BOOST_CHECK_EQUAL(profile.decided(Arithmetic_tier::FILTERED_EXACT), 1u);
}

BOOST_AUTO_TEST_CASE(threads_count_the_same_decisions)
{
  const Triangles triangles = random_triangles(30, 0);
  Scene_profile one, many;
  BOOST_CHECK(pairs_with(one, triangles) == pairs_with<CGAL::Parallel_tag>(many, triangles));
  for(const Arithmetic_tier tier : all_tiers)
    BOOST_CHECK_EQUAL(one.decided(tier), many.decided(tier));
}

BOOST_AUTO_TEST_CASE(two_ranges_are_one_scene)
{
  const Triangles triangles = random_triangles(30, 0);
  const auto ranges = split(triangles, 10);
  Scene_profile all, two;
  const Pairs pairs = pairs_with(all, triangles);
  const Pairs found = collected([&](const Callback& callback) {
    CGAL::thick_intersection_d(ranges.first, ranges.second, callback, two);
  });
  BOOST_CHECK(sorted(found) == of_two_sets(pairs, 10));
  BOOST_CHECK_EQUAL(two.size(), 40u);
  BOOST_CHECK_EQUAL(two.bits(), all.bits());
}

BOOST_AUTO_TEST_CASE(empty_range_has_a_profile)
{
  Scene_profile profile;
  BOOST_CHECK(pairs_with(profile, Triangles()).empty());
  BOOST_CHECK_EQUAL(profile.size(), 0u);
  BOOST_CHECK_EQUAL(profile.dimension(), 0);
}
