// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The first two equal points, against all pairs.

#include "support/counted_points.h"
#include "support/pairs.h"
#include "support/plain_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

BOOST_AUTO_TEST_SUITE(first_equal_pair)

using namespace test_support;

std::optional<Pair> by_brute_force(const Points& points)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = i + 1; j < points.size(); ++j)
      if(points[i] == points[j])
        return Pair(i, j);
  return std::nullopt;
}

BOOST_AUTO_TEST_CASE(the_pair_is_the_lexicographically_smallest)
{
  Random random(1);
  std::size_t found = 0;
  for(int repetition = 0; repetition < 3000; ++repetition) {
    Points points;
    const std::size_t side = 3 + random.below(20);
    for(std::size_t size = random.below(20); size > 0; --size)
      points.push_back({static_cast<double>(random.below(side)),
                        random.below(2) == 0 ? 0. : -0., // equal
                        static_cast<double>(random.below(side))});
    const std::optional<Pair> expected = by_brute_force(points);
    found += expected.has_value();
    const Plain_points<double> elements = plain_points(points);
    internal::Unwatched_progress progress;
    internal::First_equal_pair<Plain_points<double>> search(elements, 3, random.below(1000));
    BOOST_CHECK(search.find(progress) == expected);
  }
  BOOST_CHECK_GT(found, 500u);
  BOOST_CHECK_LT(found, 2500u);
}

// The first key of the hash for a seed, as Sequence_hash makes it.
std::uint64_t first_key(std::uint64_t seed)
{
  std::uint64_t x = seed + 2 * 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

// Points of which the first `count` are different, and all have the same hash: one factor of their
// products is zero.
Points points_for_the_hash(std::uint64_t seed, std::uint64_t size, std::uint64_t count)
{
  Points points;
  for(std::uint64_t i = 0; i < size; ++i) {
    const std::uint64_t low = (0 - first_key(seed)) & 0xffffffff;
    const std::uint64_t bits = ((0x40000000 + i % count) << 32) + low; // those of a positive double
    points.emplace_back(1);
    std::memcpy(&points.back()[0], &bits, sizeof(bits));
  }
  return points;
}

BOOST_AUTO_TEST_CASE(points_that_are_made_for_the_hash_take_few_looks)
{
  const std::uint64_t seed = 5;
  const Points points = points_for_the_hash(seed, 20000, 19997);
  const Plain_points<double> plain = plain_points(points);
  std::size_t looks = 0;
  const Counted_points<Plain_point<double>> counted = {plain, looks};
  internal::Unwatched_progress progress;
  internal::First_equal_pair<Counted_points<Plain_point<double>>> search(counted, 1, seed);
  BOOST_CHECK(search.find(progress) == Pair(0, 19997));
  BOOST_CHECK_GT(looks, 20 * points.size());
  BOOST_CHECK_LT(looks, 200 * points.size());
}

// The search changes its hash in the middle of the points: one point after another is in a pair.
BOOST_AUTO_TEST_CASE(another_hash_has_all_points_before_it)
{
  const std::uint64_t seed = 5, size = 100;
  for(std::size_t i = 1; i + 1 < size; ++i) {
    Points points = points_for_the_hash(seed, size, size);
    points[size - 1] = points[i];
    const Plain_points<double> plain = plain_points(points);
    internal::Unwatched_progress progress;
    internal::First_equal_pair<Plain_points<double>> search(plain, 1, seed);
    BOOST_CHECK(search.find(progress) == Pair(i, size - 1));
  }
}

BOOST_AUTO_TEST_SUITE_END()
