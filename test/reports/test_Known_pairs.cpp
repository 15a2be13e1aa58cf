// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs that are known, against a set of the standard library.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>

BOOST_AUTO_TEST_SUITE(Known_pairs)

using namespace test_support;
using internal::Place;

// As many pairs as a small set takes before it grows. Each search for another pair ends: it looks
// through all slots, not through every other one, which may all be taken.
BOOST_AUTO_TEST_CASE(searches_in_full_sets_end)
{
  Random random(1);
  const auto below = [&](Place end) { return static_cast<Place>(random.below(end)); };
  for(int k = 0; k < 3000; ++k) {
    internal::Known_pairs known{internal::Threads()};
    for(int count = 0; count < 8; ++count)
      known.add(below(1000), 1000 + below(1000));
    for(int count = 0; count < 10; ++count)
      BOOST_REQUIRE(!known.has(below(1000), 2000 + below(1000)));
  }
}

BOOST_AUTO_TEST_CASE(many_pairs)
{
  internal::Known_pairs known{internal::Threads()};
  std::set<std::pair<Place, Place>> expected;
  Random random(1);
  for(int k = 0; k < 20000; ++k) {
    const auto i = static_cast<Place>(random.below(200)), j = static_cast<Place>(random.below(200));
    if(i == j)
      continue;
    const auto pair = std::minmax({i, j});
    const bool is_new = expected.count(pair) == 0;
    BOOST_REQUIRE_EQUAL(known.has(i, j), !is_new);
    if(random.below(2) == 0) {
      BOOST_REQUIRE_EQUAL(known.add(i, j), is_new);
      expected.insert(pair);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
