// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lists of neighbors by slabs, in sequence and in blocks of slabs, against pairs by the recursive
// route.

#include "support/kernels.h"
#include "support/slab_variants.h"

#include <tbb/global_control.h>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;

namespace {

// One slab, or a few, in many columns.
Slab_tuning few_slabs()
{
  Slab_tuning tuning;
  tuning.points_per_column = 8;
  return tuning;
}

template <int Dimension>
void check_lists(const Points& points, double r, Random& random)
{
  const auto made = make_points<Cartesian_points<Kernel, Dimension>>(points);
  const auto bound = CGAL::within_distance(r);
  const Pairs pairs = near_pairs_by_recursion(made, bound, Dimension);
  const Pairs expected = in_both_orders(pairs);
  Slab_tuning small = small_tuning(random);
  small.points_per_column = static_cast<internal::Place>(1 + random.below(8));
  small.max_slab_size = static_cast<internal::Place>(4 << random.below(8));
  for(const Slab_tuning& tuning : {Slab_tuning(), few_slabs(), small}) { // threads share all
    BOOST_CHECK(sorted(slab_pairs<Dimension, CGAL::Parallel_tag>(made, bound, tuning))
                == sorted(pairs));
    BOOST_CHECK(
      pairs_in_lists(slab_lists<CGAL::Sequential_tag, Dimension>(made, bound, tuning)) == expected);
    BOOST_CHECK(
      pairs_in_lists(slab_lists<CGAL::Parallel_tag, Dimension>(made, bound, tuning)) == expected);
  }
}

// Lists of no neighbor, of few and of many; on the lattice, the reach is a tie.
template <int Dimension>
void check_scenes()
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  Random random(Dimension);
  const int side = Dimension == 2 ? 25 : 8;
  for(int round = 0; round < 5; ++round)
    for(const double r : {0., 0.01, 0.1, 0.3, 0.5}) {
      check_lists<Dimension>(uniform_points(Dimension, 700, 0, 1, random.below(1000)), r, random);
      check_lists<Dimension>(flight_points(Dimension, 500), 10 * r, random);
      check_lists<Dimension>(lattice_points(Dimension, side, 0.1, 0), r, random);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(lists_are_the_pairs_2) { check_scenes<2>(); }
BOOST_AUTO_TEST_CASE(lists_are_the_pairs_3) { check_scenes<3>(); }

// If most points are in one slab, threads share it. Then pairs are collected.
BOOST_AUTO_TEST_CASE(lists_of_crowded_slabs)
{
  Random random(1);
  Points points = uniform_points(2, 2000, 0, 1, 1);
  for(std::size_t i = 0; i < 1000; ++i)
    points[i][1] = 0.5 + points[i][1] / 1000;
  check_lists<2>(points, 0.02, random);
}
