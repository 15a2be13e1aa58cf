// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every search of small random scenes of doubles, on two kernels, in sequence and by four threads.

#include "support/check_fuzz.h"
#include "support/usual_kernels.h"

#include <tbb/global_control.h>

using namespace test_support;

namespace {

const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);

template <class Kernel, int Dimension, class ConcurrencyTag = CGAL::Sequential_tag>
void fuzz_doubles()
{
  fuzz<Fuzz_cartesian<Kernel, Dimension, false>, ALL_PARTS, ConcurrencyTag>(20000);
}

} // namespace

BOOST_AUTO_TEST_CASE(epick_2) { fuzz_doubles<Epick, 2>(); }
BOOST_AUTO_TEST_CASE(epick_2_by_threads) { fuzz_doubles<Epick, 2, CGAL::Parallel_tag>(); }
BOOST_AUTO_TEST_CASE(epick_3) { fuzz_doubles<Epick, 3>(); }
BOOST_AUTO_TEST_CASE(epick_3_by_threads) { fuzz_doubles<Epick, 3, CGAL::Parallel_tag>(); }
BOOST_AUTO_TEST_CASE(doubles_2) { fuzz_doubles<Double_kernel, 2>(); }
BOOST_AUTO_TEST_CASE(doubles_2_by_threads) { fuzz_doubles<Double_kernel, 2, CGAL::Parallel_tag>(); }
BOOST_AUTO_TEST_CASE(doubles_3) { fuzz_doubles<Double_kernel, 3>(); }
BOOST_AUTO_TEST_CASE(doubles_3_by_threads) { fuzz_doubles<Double_kernel, 3, CGAL::Parallel_tag>(); }
