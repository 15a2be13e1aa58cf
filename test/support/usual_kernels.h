// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The kernels that most tests are for, and the types of each by the dimension.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_USUAL_KERNELS_H
#define THICK_INTERSECTION_TEST_SUPPORT_USUAL_KERNELS_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace test_support {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Double_kernel = CGAL::Simple_cartesian<double>;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_USUAL_KERNELS_H
