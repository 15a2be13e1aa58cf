// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The lists of slabs in a window, against sets of neighbors.

#include "support/counting_allocator.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Slab_lists.h>

#include <deque>

BOOST_AUTO_TEST_SUITE(Slab_lists)

using namespace test_support;
using internal::Place;

using Lists = internal::Slab_lists;
using Strips = internal::Strips<internal::Slab_point<2, double>>;
using Numbers = std::vector<Place>; // by the order of the points of a slab

// A slab in the window, and the numbers of its points.
struct Numbered_slab
{
  Strips strips;
  Numbers numbers;
};

// The lists in the bins.
std::map<Place, std::vector<Place>> lists_of(const internal::List_bins& bins, Place size)
{
  std::map<Place, std::vector<Place>> lists;
  const std::size_t bin_size = internal::List_bins::bin_size;
  for(std::size_t bin = 0; bin * bin_size < size; ++bin)
    bins.for_each(bin, [&](std::size_t of, const Place* first, const Place* last) {
      std::vector<Place>& list = lists[static_cast<Place>(bin * bin_size + of)];
      list.insert(list.end(), first, last);
    });
  return lists;
}

// A slab of points at the positions from `first` on.
Numbered_slab number(Place first, Place size, Lists& lists)
{
  std::vector<internal::Slab_point<2, double>> points(size);
  for(Place i = 0; i < size; ++i)
    points[i] = {{double(i), 0}, first + i};
  Numbered_slab slab;
  slab.strips.reset(size, 1);
  slab.strips.append(points.data(), points.data() + size, internal::Point_sets());
  Place* positions = nullptr;
  const Place number = lists.add(slab.strips.place_count(), positions);
  slab.strips.number_places(number, positions);
  const auto run = slab.strips.run(slab.strips.strips().front());
  slab.numbers.assign(run.positions, run.positions + run.size);
  return slab;
}

// A window moves over slabs of various sizes. The pairs are of the first slab in the window, and of
// itself or another slab. Their number is such that there are lists of all kinds.
void check_window(std::size_t slab_count, std::size_t window_size, std::size_t pairs_per_slab)
{
  Random random(pairs_per_slab);
  Lists lists(slab_count);
  const auto position = [&](Place number) { return (*lists.positions())[number]; };
  std::map<Place, std::set<Place>> expected;
  internal::List_bins bins(100 * slab_count);
  std::deque<Numbered_slab> window;
  Place end = 0;
  for(std::size_t s = 0; s < slab_count + window_size; ++s) {
    if(s < slab_count) {
      const Place size = 1 + static_cast<Place>(random.below(s % 3 == 0 ? 100 : 30));
      window.push_back(number(end, size, lists));
      end += size;
    }
    if(s + 1 < window_size || window.empty())
      continue;
    for(std::size_t p = 0; p < pairs_per_slab; ++p) {
      const Numbers& other = window[random.below(window.size())].numbers;
      const Numbers& numbers = window.front().numbers;
      const Place i = numbers[random.below(numbers.size())];
      const Place j = other[random.below(other.size())];
      const Place a = position(i);
      const Place b = position(j);
      if(a != b && expected[a].insert(b).second) {
        expected[b].insert(a);
        const internal::Found_pair pair = {i, j};
        BOOST_CHECK(lists.take(&pair, 1));
      }
    }
    if(s % 5 == 4) {
      for(const Place n : window.front().numbers)
        expected.erase(position(n));
      lists.drop();
    }
    else
      lists.finish(window.front().strips, bins);
    window.pop_front();
  }
  for(const auto& [of, list] : lists_of(bins, end)) {
    BOOST_CHECK(std::set<Place>(list.begin(), list.end()) == expected[of]);
    BOOST_CHECK(std::is_sorted(list.begin(), list.end()));
    expected.erase(of);
  }
  for(const auto& [of, neighbors] : expected)
    BOOST_CHECK(neighbors.empty());
}

BOOST_AUTO_TEST_CASE(lists_of_a_slab_are_complete_when_it_leaves_the_window)
{
  for(const std::size_t window_size : {1, 2, 5})
    for(const std::size_t pairs : {0, 10, 100, 2000})
      check_window(40, window_size, pairs);
}

// Room that grows would hold lists twice.
BOOST_AUTO_TEST_CASE(lists_take_memory_once)
{
  const Place size = 1000;
  for(const std::size_t slab_count : {1, 2, 3, 100}) {
    const std::size_t slabs_at_once = (std::min)(slab_count, std::size_t(3));
    const std::size_t before = current_bytes();
    reset_peak();
    Lists lists(slab_count);
    internal::List_bins bins(slab_count * size);
    std::deque<Numbered_slab> window;
    for(std::size_t s = 0; s < slab_count; ++s) {
      if(s >= slabs_at_once) {
        lists.finish(window.front().strips, bins);
        window.pop_front();
      }
      window.push_back(number(static_cast<Place>(s) * size, size, lists));
    }
    BOOST_CHECK_LT(peak_bytes() - before,
                   (slabs_at_once + 2) * size * sizeof(internal::Short_list));
  }
}

BOOST_AUTO_TEST_SUITE_END()
