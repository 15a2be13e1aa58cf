// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every search of small random scenes whose coordinates are thirds, in exact numbers, in sequence
// and by four threads.

#include "support/check_fuzz.h"
#include "support/usual_kernels.h"

#include <CGAL/Exact_integer.h>
#include <CGAL/Homogeneous.h>

#include <tbb/global_control.h>

using namespace test_support;

using Integers = CGAL::Homogeneous<CGAL::Exact_integer>;

namespace {

const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);

template <class Kernel, int Dimension, class ConcurrencyTag = CGAL::Sequential_tag>
void fuzz_thirds()
{
  fuzz<Fuzz_cartesian<Kernel, Dimension, true>, ALL_PARTS, ConcurrencyTag>(8000);
}

} // namespace

BOOST_AUTO_TEST_CASE(epeck_2) { fuzz_thirds<Epeck, 2>(); }
BOOST_AUTO_TEST_CASE(epeck_2_by_threads) { fuzz_thirds<Epeck, 2, CGAL::Parallel_tag>(); }
BOOST_AUTO_TEST_CASE(epeck_3) { fuzz_thirds<Epeck, 3>(); }
BOOST_AUTO_TEST_CASE(epeck_3_by_threads) { fuzz_thirds<Epeck, 3, CGAL::Parallel_tag>(); }
BOOST_AUTO_TEST_CASE(rationals_2) { fuzz_thirds<Rational_kernel, 2>(); }
BOOST_AUTO_TEST_CASE(rationals_2_by_threads)
{
  fuzz_thirds<Rational_kernel, 2, CGAL::Parallel_tag>();
}
BOOST_AUTO_TEST_CASE(rationals_3) { fuzz_thirds<Rational_kernel, 3>(); }
BOOST_AUTO_TEST_CASE(rationals_3_by_threads)
{
  fuzz_thirds<Rational_kernel, 3, CGAL::Parallel_tag>();
}

// Many near pairs, which take less time than the other searches.
BOOST_AUTO_TEST_CASE(near_pairs_of_epeck_3)
{
  fuzz<Fuzz_cartesian<Epeck, 3, true>, NEAR_PAIRS | BALLS>(20000);
}
BOOST_AUTO_TEST_CASE(near_pairs_of_rationals_2)
{
  fuzz<Fuzz_cartesian<Rational_kernel, 2, true>, NEAR_PAIRS | CLOSEST_PAIRS>(20000);
}

BOOST_AUTO_TEST_CASE(homogeneous_2)
{
  fuzz<Fuzz_homogeneous<Integers, 2>, NEAR_PAIRS | CLOSEST_PAIRS>(2000);
}

// Near pairs at the limits of narrow coordinates.
BOOST_AUTO_TEST_CASE(partners_of_epeck_3) { fuzz<Fuzz_cartesian<Epeck, 3, true>, PARTNERS>(5000); }
BOOST_AUTO_TEST_CASE(partners_of_rationals_2)
{
  fuzz<Fuzz_cartesian<Rational_kernel, 2, true>, PARTNERS>(5000);
}
