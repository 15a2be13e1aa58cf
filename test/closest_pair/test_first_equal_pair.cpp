// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The first two equal points, against all pairs.

#include "support/pairs.h"
#include "support/plain_points.h"
#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/first_equal_pair.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <optional>

BOOST_AUTO_TEST_SUITE(first_equal_pair)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

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
    BOOST_CHECK(!search.is_given_up());
  }
  BOOST_CHECK_GT(found, 500u);
  BOOST_CHECK_LT(found, 2500u);
}

BOOST_AUTO_TEST_SUITE_END()
