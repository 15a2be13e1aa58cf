// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The randomized cells of the benchmarks: their pair, and their work.

#include "../../benchmark/methods/Incremental_cells.h"
#include "support/check_closest_pair.h"
#include "support/counted_points.h"
#include "support/unit_test.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

BOOST_AUTO_TEST_SUITE(Incremental_cells)

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Maker = Cartesian_points<Epick, Dimension>;

// Returns the closest pair; nothing if points are equal.
template <int Dimension, class Elements>
std::optional<Pair> closest_by_cells(const Elements& elements, const internal::Scene& scene)
{
  std::vector<std::uint32_t> positions(elements.size());
  std::iota(positions.begin(), positions.end(), 0);
  internal::Pair_minimum<Elements> minimum(elements, scene);
  thick_benchmark::Incremental_cells<Dimension, Elements> cells(elements, positions, scene, 1);
  return cells.search(minimum) ? std::optional<Pair>(minimum.pair()) : std::nullopt;
}

template <int Dimension>
void check_cells()
{
  std::size_t found = 0;
  for(const Point_scene& scene : all_scenes(Dimension)) {
    const auto points = make_points<Maker<Dimension>>(scene.points);
    const Elements_of<typename Maker<Dimension>::Point> elements(points);
    if(points.size() >= 2)
      if(const auto pair = closest_by_cells<Dimension>(elements, scene_of(elements))) {
        ++found;
        BOOST_TEST_CONTEXT(scene)
        check_pair("cells", known_closest(scene.points).pair, *pair);
      }
  }
  BOOST_CHECK_GT(found, 30u);
}

BOOST_AUTO_TEST_CASE(randomised_cells_find_the_closest_pair)
{
  check_cells<2>();
  check_cells<3>();
}

// Of the randomised cells, per point.
template <int Dimension>
double looks_of_cells(const Points& scene)
{
  using Counted = Counted_points<typename Maker<Dimension>::Point>;
  const auto points = make_points<Maker<Dimension>>(scene);
  std::size_t looks = 0;
  const Counted counted = {points, looks};
  BOOST_CHECK(closest_by_cells<Dimension>(
    counted, scene_of(Elements_of<typename Maker<Dimension>::Point>(points))));
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
