// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's predicates on plain doubles, and on intervals of them: what a filter alone can tell.

#include "predicate_columns.h"

#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>

#include <memory>

namespace lab {
namespace {

// Intervals need the processor to round upwards.
auto by_intervals()
{
  return [](const auto&) {
    const auto rounding = std::make_shared<CGAL::Protect_FPU_rounding<true>>();
    return [rounding](const auto& a, const auto& b) {
      try {
        return CGAL::do_intersect(a, b) ? YES : NO;
      }
      catch(const CGAL::Uncertain_conversion_exception&) {
        return UNDECIDED;
      }
    };
  };
}

} // namespace

Predicate_columns plain_predicates()
{
  using Double_kernel = CGAL::Simple_cartesian<double>;
  using Interval_kernel = CGAL::Simple_cartesian<CGAL::Interval_nt<false>>;
  return {
    predicate_column<Double_kernel>("CGAL, double", "form", by_do_intersect()),
    predicate_column<Interval_kernel>("CGAL, intervals", "form", by_intervals()),
  };
}

} // namespace lab
