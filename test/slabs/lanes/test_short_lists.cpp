// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Short lists in order, by the lanes of all processors, against std::sort.

#include "support/instruction_sets.h"
#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/slabs/lanes/short_lists.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <vector>

BOOST_AUTO_TEST_SUITE(short_lists)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

using Sorted = std::array<internal::Place, internal::Short_list::capacity>;

// Half of the positions have the highest bit.
std::vector<internal::Place> random_positions(internal::Place size, Random& random)
{
  std::vector<internal::Place> positions;
  for(internal::Place i = 0; i < size; ++i)
    positions.push_back(i << 27 | static_cast<internal::Place>(random.below(1 << 27)));
  for(internal::Place i = size; i > 1; --i)
    std::swap(positions[i - 1], positions[random.below(i)]);
  return positions;
}

// What is behind the positions of a list is of no account.
template <class Sort>
void check_sort(const Sort& sort)
{
  Random random(1);
  for(internal::Place size = 0; size <= internal::Short_list::capacity; ++size)
    for(int round = 0; round < 100; ++round) {
      std::vector<internal::Place> positions = random_positions(size, random);
      internal::Short_list list;
      list.positions.fill(static_cast<internal::Place>(random.below(1000)));
      std::copy(positions.begin(), positions.end(), list.positions.begin());
      Sorted sorted = {};
      sort(list.positions.data(), size, sorted.data());
      std::sort(positions.begin(), positions.end());
      BOOST_CHECK(std::equal(positions.begin(), positions.end(), sorted.begin()));
    }
}

BOOST_AUTO_TEST_CASE(lists_of_all_sizes_are_sorted)
{
  for(const internal::Instruction_set set : instruction_sets()) {
    const Forced_instruction_set forced(set);
    check_sort(internal::sort_short_list);
  }
}

BOOST_AUTO_TEST_SUITE_END()
