// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's predicates on its exact kernels. They require that no object is degenerate.

#include "predicate_columns.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace lab {

Predicate_columns cgal_predicates()
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  return {
    predicate_column<Epick>("CGAL, EPICK", "kernel", by_do_intersect()),
    predicate_column<Epeck>("CGAL, EPECK", "kernel", by_do_intersect()),
    predicate_column<Rational_kernel>("CGAL, rational", "kernel", by_do_intersect()),
  };
}

} // namespace lab
