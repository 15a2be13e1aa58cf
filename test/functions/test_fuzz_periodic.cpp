// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random periodic scenes on the usual kernels, in sequence and by threads.

#include "support/check_periodic_fuzz.h"
#include "support/usual_kernels.h"

using namespace test_support;

namespace {

template <class Maker, class ConcurrencyTag = CGAL::Sequential_tag>
void fuzz_with_domain(std::uint64_t count)
{
  fuzz_periodic<Maker, Maker, ConcurrencyTag>(count);
}

using Threads = CGAL::Parallel_if_available_tag;
using Epick_2 = Fuzz_cartesian<Epick, 2, false>;
using Doubles_3 = Fuzz_cartesian<Double_kernel, 3, false>;
using Epeck_3 = Fuzz_cartesian<Epeck, 3, true>;
using Rationals_2 = Fuzz_cartesian<Rational_kernel, 2, true>;

} // namespace

BOOST_AUTO_TEST_CASE(epick_2) { fuzz_with_domain<Epick_2>(3000); }
BOOST_AUTO_TEST_CASE(epick_2_by_threads) { fuzz_with_domain<Epick_2, Threads>(1000); }
BOOST_AUTO_TEST_CASE(doubles_3) { fuzz_with_domain<Doubles_3>(3000); }
BOOST_AUTO_TEST_CASE(doubles_3_by_threads) { fuzz_with_domain<Doubles_3, Threads>(1000); }
BOOST_AUTO_TEST_CASE(epeck_3) { fuzz_with_domain<Epeck_3>(400); }
BOOST_AUTO_TEST_CASE(epeck_3_by_threads) { fuzz_with_domain<Epeck_3, Threads>(400); }
BOOST_AUTO_TEST_CASE(rationals_2) { fuzz_with_domain<Rationals_2>(400); }
BOOST_AUTO_TEST_CASE(rationals_2_by_threads) { fuzz_with_domain<Rationals_2, Threads>(400); }
