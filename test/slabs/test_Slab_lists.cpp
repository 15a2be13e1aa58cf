// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The lists of slabs in a window, against sets of neighbors.

#include "support/counting_allocator.h"
#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Slab_lists.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(Slab_lists)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Place;

struct Never_stopped
{
  bool is_stopped() const { return false; }
};
using Lists = internal::Slab_lists<Never_stopped>;
using Strips = internal::Strips<internal::Slab_point<2, double>>;
using Numbers = std::vector<Place>; // by the order of the points of a slab
using Neighbors = std::map<Place, std::vector<Place>>;

// A list that is given in parts would not be sorted here.
struct Some_bins
{
  Place* append_short(Place of, std::size_t size)
  {
    lists[of].resize(internal::Short_list::capacity);
    sizes[of] = size;
    return lists[of].data();
  }
  void append(Place of, const Place* first, const Place* last)
  {
    lists[of].assign(first, last);
    sizes[of] = lists[of].size();
  }

  Neighbors lists;
  std::map<Place, std::size_t> sizes;
};

// A slab of points at the positions from `first` on.
Numbers number(Place first, Place size, Lists& lists)
{
  std::vector<internal::Slab_point<2, double>> points(size);
  for(Place i = 0; i < size; ++i)
    points[i] = {{double(i), 0}, first + i};
  Strips strips;
  strips.reset(size, 1);
  strips.append(points.data(), points.data() + size, internal::Point_sets());
  lists.number(strips);
  const auto run = strips.run(strips.strips().front());
  return Numbers(run.positions, run.positions + run.size);
}

// A window moves over slabs of various sizes. The pairs are of the first slab in the window, and of
// itself or another slab. Their number is such that there are lists of all kinds.
void check_window(std::size_t slab_count, std::size_t window_size, std::size_t pairs_per_slab)
{
  Random random(pairs_per_slab);
  const Never_stopped stop;
  Lists lists(stop, slab_count);
  std::map<Place, std::set<Place>> expected;
  Some_bins bins;
  std::deque<Numbers> window;
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
      const Numbers& other = window[random.below(window.size())];
      const Place i = window.front()[random.below(window.front().size())];
      const Place j = other[random.below(other.size())];
      const Place a = lists.position(i);
      const Place b = lists.position(j);
      if(a != b && expected[a].insert(b).second) {
        expected[b].insert(a);
        BOOST_CHECK(lists(i, j));
      }
    }
    if(s % 5 == 4) {
      for(const Place n : window.front())
        expected.erase(lists.position(n));
      lists.drop();
    }
    else
      lists.finish(bins);
    window.pop_front();
  }
  BOOST_CHECK(!lists.is_stopped());
  for(auto& [of, list] : bins.lists) {
    list.resize(bins.sizes[of]);
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
    const Never_stopped stop;
    Lists lists(stop, slab_count);
    Some_bins bins;
    for(std::size_t s = 0; s < slab_count; ++s) {
      if(s >= slabs_at_once)
        lists.finish(bins);
      number(static_cast<Place>(s) * size, size, lists);
    }
    BOOST_CHECK_LT(peak_bytes() - before,
                   (slabs_at_once + 2) * size * sizeof(internal::Short_list));
  }
}

BOOST_AUTO_TEST_SUITE_END()
