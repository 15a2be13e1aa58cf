// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of the randomized cells.

#include "support/check_closest_pair.h"
#include "support/counted_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <numeric>

BOOST_AUTO_TEST_SUITE(Closest_pair_cells)

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Maker = Cartesian_points<Epick, Dimension>;

// Of the randomised cells, per point.
template <int Dimension>
double looks_of_cells(const Points& scene)
{
  using Counted = Counted_points<typename Maker<Dimension>::Point>;
  const auto points = make_points<Maker<Dimension>>(scene);
  std::vector<std::uint32_t> positions(points.size());
  std::iota(positions.begin(), positions.end(), 0);
  std::size_t looks = 0;
  const Counted counted = {points, looks};
  const internal::Scene scene_of_points =
      scene_of(Elements_of<typename Maker<Dimension>::Point>(points));
  internal::Pair_minimum<Counted> minimum(counted, scene_of_points);
  internal::Closest_pair_cells<Dimension, Counted> cells(counted, positions, scene_of_points, 1);
  internal::Unwatched_progress progress;
  BOOST_CHECK(cells.search(minimum, progress));
  BOOST_TEST_MESSAGE(Dimension << "D cells: " << looks / points.size() << " looks per point");
  return static_cast<double>(looks) / static_cast<double>(points.size());
}

BOOST_AUTO_TEST_CASE(randomised_cells_look_at_points_a_few_times)
{
  BOOST_CHECK_LT(looks_of_cells<2>(uniform_points(2, 20000, 0, 1, 22)), 30);
  BOOST_CHECK_LT(looks_of_cells<2>(lattice_points(2, 150, 1)), 30);
  BOOST_CHECK_LT(looks_of_cells<3>(uniform_points(3, 20000, 0, 1, 23)), 30);
  BOOST_CHECK_LT(looks_of_cells<3>(lattice_points(3, 28, 1)), 100);
}

BOOST_AUTO_TEST_SUITE_END()
