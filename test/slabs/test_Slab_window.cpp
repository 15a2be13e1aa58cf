// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The window over the slabs that are ready, against the list of all slabs of the stream.

#include "support/point_source.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>

BOOST_AUTO_TEST_SUITE(Slab_window)

using namespace test_support;

template <int Dimension>
using Point = internal::Slab_point<Dimension, double>;

// One slab of the stream, and the positions of its points.
struct Listed_slab
{
  internal::Interval interval;
  internal::Place slab;
  std::vector<internal::Place> positions;
};

template <int Dimension>
std::vector<internal::Place> positions_of(const internal::Strips<Point<Dimension>>& strips)
{
  std::vector<internal::Place> positions;
  for(const auto& strip : strips.strips()) {
    const internal::Run<Dimension, double> run = strips.run(strip);
    positions.insert(positions.end(), run.positions, run.positions + run.size);
  }
  return positions;
}

template <int Dimension>
std::vector<Listed_slab> list_of(const internal::Slab_column<Point<Dimension>>& slabs,
                                 double reach)
{
  std::vector<Listed_slab> list;
  internal::Slab_stream<Point<Dimension>> stream(slabs, reach, 0, tuning_for_few_points());
  internal::Strips<Point<Dimension>> strips;
  while(stream.next(strips))
    list.push_back(
      {strips.interval(Dimension - 1), stream.slab(), positions_of<Dimension>(strips)});
  return list;
}

// The slabs of a stream follow each other, and have each point once.
void check_list(const std::vector<Listed_slab>& list, std::size_t size)
{
  std::vector<internal::Place> all;
  for(std::size_t s = 0; s < list.size(); ++s) {
    all.insert(all.end(), list[s].positions.begin(), list[s].positions.end());
    BOOST_CHECK(!list[s].positions.empty());
    BOOST_CHECK(s == 0 || list[s - 1].interval.high <= list[s].interval.low);
    BOOST_CHECK(s == 0 || list[s - 1].slab <= list[s].slab);
  }
  std::sort(all.begin(), all.end());
  BOOST_CHECK_EQUAL(all.size(), size);
  BOOST_CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

// Those from the slab `s` on that are not beyond reach above `high`.
std::vector<std::vector<internal::Place>> within_reach(const std::vector<Listed_slab>& list,
                                                       std::size_t s, double high, double reach)
{
  std::vector<std::vector<internal::Place>> near;
  for(; s < list.size(); ++s)
    if(list[s].interval.low - high <= reach)
      near.push_back(list[s].positions);
  return near;
}

template <int Dimension>
void check_window(const internal::Slabs<Point<Dimension>>& slabs, double reach)
{
  const internal::Slab_column<Point<Dimension>> column(slabs, 0, reach, false);
  const std::vector<Listed_slab> list = list_of<Dimension>(column, reach);
  check_list(list, slabs.size());
  internal::Slab_window<Point<Dimension>> window(column, reach, 0, tuning_for_few_points());
  typename internal::Slab_window<Point<Dimension>>::Slabs_nearby nearby;
  for(std::size_t s = 0; s < list.size(); ++s) {
    BOOST_REQUIRE(window.front() != nullptr);
    BOOST_CHECK(positions_of<Dimension>(*window.front()) == list[s].positions);
    BOOST_CHECK_EQUAL(window.slab(), list[s].slab);
    const internal::Interval interval = list[s].interval;
    for(const double high : {interval.low - reach, interval.low - reach / 2, interval.high}) {
      window.find_within_reach(high, nearby); // a slab of another set may be lower
      std::vector<std::vector<internal::Place>> found;
      for(const auto* strips : nearby)
        found.push_back(positions_of<Dimension>(*strips));
      BOOST_CHECK(found == within_reach(list, s, high, reach));
    }
    window.pop();
  }
  BOOST_CHECK(window.front() == nullptr);
  BOOST_CHECK_EQUAL(window.slab(), slabs.count());
}

template <int Dimension>
void check_scenes()
{
  for(const auto& [name, points] : scenes_to_cut(Dimension, 1500))
    for(const double reach : {1e-12, 1e-4, 1e-2, 0.3, 10.}) {
      BOOST_TEST_CONTEXT(name << ", reach " << reach)
      {
        check_window<Dimension>(slabs_of<Dimension>(points, reach), reach);
      }
    }
}

BOOST_AUTO_TEST_CASE(slabs_within_reach_are_those_of_the_list_2) { check_scenes<2>(); }
BOOST_AUTO_TEST_CASE(slabs_within_reach_are_those_of_the_list_3) { check_scenes<3>(); }

BOOST_AUTO_TEST_SUITE_END()
