// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the lists of slabs in a window take. That they are right is left to test_List_route.cpp.

#include "support/counting_allocator.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Slab_lists.h>

BOOST_AUTO_TEST_SUITE(Slab_lists)

using namespace test_support;
using internal::Place;

using Lists = internal::Slab_lists;
using Strips = internal::Strips<internal::Slab_point<2, double>>;

// A slab of points at the positions from `first` on, with the numbers that the lists give them.
Strips numbered_slab(Place first, Place size, Lists& lists)
{
  std::vector<internal::Slab_point<2, double>> points(size);
  for(Place i = 0; i < size; ++i)
    points[i] = {{double(i), 0}, first + i};
  Strips strips;
  strips.reset(size, 1);
  strips.append(points.data(), points.data() + size, internal::Point_sets());
  Place* positions = nullptr;
  const Place number = lists.add(strips.place_count(), positions);
  strips.number_places(number, positions);
  return strips;
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
    std::deque<Strips> window;
    for(std::size_t s = 0; s < slab_count; ++s) {
      if(s >= slabs_at_once) {
        lists.finish(window.front(), bins);
        window.pop_front();
      }
      window.push_back(numbered_slab(static_cast<Place>(s) * size, size, lists));
    }
    BOOST_CHECK_LT(peak_bytes() - before,
                   (slabs_at_once + 2) * size * sizeof(internal::Short_list));
  }
}

BOOST_AUTO_TEST_SUITE_END()
