// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Runs of positions, sorted and merged by the lanes of all processors, against std::sort.

#include "support/instruction_sets.h"

#include <CGAL/Thick_intersection_d/internal/lanes/run_sorter.h>

BOOST_AUTO_TEST_SUITE(run_sorter)

using namespace test_support;

using internal::Place;
using Run = std::array<Place, internal::max_run_size>;

constexpr Place largest = (std::numeric_limits<Place>::max)();

// Half of the positions have the highest bit.
std::vector<Place> random_positions(std::size_t size, Random& random)
{
  std::vector<Place> positions;
  for(std::size_t i = 0; i < size; ++i)
    positions.push_back(static_cast<Place>(i << 22 | random.below(1 << 22)) ^ largest);
  return shuffled(std::move(positions), random);
}

// What is behind the positions of a run is of no account.
void check_sort(const internal::Run_sorter& sorter, const std::vector<Place>& positions)
{
  Run run, sorted = {};
  run.fill(positions.empty() ? 0 : positions.front() / 2);
  std::copy(positions.begin(), positions.end(), run.begin());
  std::vector<Place> expected = positions;
  std::sort(expected.begin(), expected.end());
  sorter.sort(run.data(), static_cast<Place>(positions.size()), sorted.data());
  BOOST_CHECK(std::equal(expected.begin(), expected.end(), sorted.begin()));
}

// The first run gets every n-th position, for n = `share`, and the largest number behind them.
void check_merge(const internal::Run_sorter& sorter, std::vector<Place> positions,
                 std::size_t share)
{
  std::sort(positions.begin(), positions.end());
  std::vector<std::vector<Place>> runs(2);
  for(std::size_t i = 0; i < positions.size(); ++i)
    runs[i % share == 0 ? 0 : 1].push_back(positions[i]);
  const auto step = static_cast<std::size_t>(sorter.size_step);
  const std::size_t longest = (std::max)({runs[0].size(), runs[1].size(), std::size_t(1)});
  const std::size_t size = (longest + step - 1) / step * step;
  for(std::vector<Place>& run : runs)
    run.resize(size, largest);
  for(int swaps = 0; swaps < 2; ++swaps) {
    std::vector<Place> both = runs[0], merged(2 * size);
    both.insert(both.end(), runs[1].begin(), runs[1].end());
    both.push_back(0); // may be read, and is of no account
    sorter.merge(both.data(), static_cast<std::ptrdiff_t>(size), merged.data());
    std::sort(both.begin(), both.end() - 1);
    BOOST_CHECK(std::equal(merged.begin(), merged.end(), both.begin()));
    std::swap(runs[0], runs[1]);
  }
}

// Calls f with the sorter of each instruction set.
template <class Function>
void for_each_sorter(const Function& f)
{
  for(const internal::Instruction_set set : instruction_sets()) {
    const Forced_instruction_set forced(set);
    f(internal::run_sorter());
  }
}

BOOST_AUTO_TEST_CASE(runs_of_all_sizes_are_sorted)
{
  for_each_sorter([](const internal::Run_sorter& sorter) {
    Random random(1);
    for(std::size_t size = 0; size <= std::size_t(internal::max_run_size); ++size)
      for(int round = 0; round < 100; ++round)
        check_sort(sorter, random_positions(size, random));
  });
}

BOOST_AUTO_TEST_CASE(runs_of_unequal_shares_are_merged)
{
  for_each_sorter([](const internal::Run_sorter& sorter) {
    Random random(2);
    for(std::size_t size = 0; size < 300; ++size)
      for(const std::size_t share : {1, 2, 3, 7, 1000})
        check_merge(sorter, random_positions(size, random), share);
  });
}

// Runs that are all before or all behind the other one.
BOOST_AUTO_TEST_CASE(runs_that_do_not_overlap_are_merged)
{
  for_each_sorter([](const internal::Run_sorter& sorter) {
    for(const std::ptrdiff_t size : {16, 32, 64, 128}) {
      std::vector<Place> both(2 * static_cast<std::size_t>(size) + 1), merged(both.size() - 1);
      for(const Place first : {Place(0), static_cast<Place>(size)}) {
        for(Place i = 0; i + 1 < both.size(); ++i)
          both[i] = (i + first) % static_cast<Place>(2 * size);
        sorter.merge(both.data(), size, merged.data());
        for(Place i = 0; i < merged.size(); ++i)
          BOOST_CHECK_EQUAL(merged[i], i);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(lists_of_all_sizes_are_sorted)
{
  for_each_sorter([](const internal::Run_sorter& sorter) {
    Random random(3);
    internal::Buffer<Place> memory;
    for(std::size_t size = 0; size < 700; ++size) {
      std::vector<Place> positions = random_positions(size, random), expected = positions;
      std::sort(expected.begin(), expected.end());
      internal::sort_distinct(positions.data(), positions.data() + size, memory, sorter);
      BOOST_CHECK(positions == expected);
    }
  });
}

BOOST_AUTO_TEST_SUITE_END()
