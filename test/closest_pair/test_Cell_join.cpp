// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The join against brute force: it visits all pairs within the distance.

#include "support/check_closest_pair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

BOOST_AUTO_TEST_SUITE(Cell_join)

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Maker = Cartesian_points<Epick, Dimension>;
using Point = Epick::Point_2;

// What a join promises: all close pairs are visited, in the order of the input or not.
BOOST_AUTO_TEST_CASE(joins_visit_all_close_pairs)
{
  struct Visitor
  {
    Pairs& visited;
    bool operator()(std::size_t i, std::size_t j)
    {
      visited.push_back(std::minmax(i, j));
      return true;
    }
    void finish() {}
  };
  using Elements = Elements_of<Point>;
  std::size_t joined = 0;
  for(const Point_scene& scene : closest_pair_scenes(2)) {
    const double reach = upper_bound(scene.radius);
    if(!internal::Hashed_cells<2>::fits(reach, 0))
      continue;
    ++joined;
    const auto points = make_points<Maker<2>>(scene.points);
    const Elements elements(points);
    for(const double factor : {2., 16.}) {
      Pairs visited;
      const internal::Cell_join<CGAL::Sequential_tag, 2, Elements> join(elements, reach,
                                                                        factor * reach);
      internal::Unwatched_progress progress;
      join(internal::All_positions(points.size()), [&] { return Visitor{visited}; }, progress);
      std::sort(visited.begin(), visited.end());
      const Pairs& pairs = truth_of(scene).pairs;
      BOOST_CHECK_MESSAGE(std::includes(visited.begin(), visited.end(), pairs.begin(),
                                        pairs.end()), scene << ", factor " << factor);
    }
  }
  BOOST_CHECK_GT(joined, 30u);
}

BOOST_AUTO_TEST_SUITE_END()
