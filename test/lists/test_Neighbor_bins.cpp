// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Neighbors come out of the bins that they were thrown into, in the order in which they came.

#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Neighbor_bins)

using namespace test_support;
using Bins = CGAL::Thick_intersection_d::internal::Neighbor_bins;
using Neighbor = std::pair<std::size_t, Bins::Position>;

BOOST_AUTO_TEST_CASE(each_bin_has_the_neighbors_of_its_points)
{
  const std::size_t size = 3 * Bins::bin_size + 1; // the last bin has a single point
  Bins bins(size);
  std::vector<std::vector<Neighbor>> expected(4);
  Random random(1);
  for(int i = 0; i < 20000; ++i) {
    const auto of = static_cast<Bins::Position>(i % 100 == 0 ? size - 1 : random.below(size));
    const auto neighbor = static_cast<Bins::Position>(random.below(0xffffffff)); // all 32 bits
    bins.add(of, neighbor);
    expected[of / Bins::bin_size].emplace_back(of % Bins::bin_size, neighbor);
  }
  for(std::size_t bin = 0; bin < 4; ++bin) {
    std::vector<Neighbor> found;
    bins.for_each(bin, [&](std::size_t of, const Bins::Position* first,
                           const Bins::Position* last) {
      BOOST_CHECK_EQUAL(last - first, 1);
      found.emplace_back(of, *first);
    });
    BOOST_CHECK(found == expected[bin]);
    BOOST_CHECK_EQUAL(bins.size(bin), expected[bin].size());
  }
}

BOOST_AUTO_TEST_SUITE_END()
