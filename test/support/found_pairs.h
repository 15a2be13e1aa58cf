// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The sorted pairs that public functions report.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_FOUND_PAIRS_H
#define THICK_INTERSECTION_TEST_SUPPORT_FOUND_PAIRS_H

#include "check_pairs.h"

#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

namespace test_support {

// The arguments are objects, and named parameters if there are any.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Objects, class... NamedParameters>
Pairs pairs_of(const Objects& objects, const NamedParameters&... np)
{
  Pairs pairs;
  Locked_collector collect(pairs);
  CGAL::thick_self_intersection_d<ConcurrencyTag>(objects, collect, np...);
  return sorted(pairs);
}

template <class A, class B, class... NamedParameters>
Pairs pairs_between(const A& a, const B& b, const NamedParameters&... np)
{
  return sorted(reported([&](auto collect) { CGAL::thick_intersection_d(a, b, collect, np...); }));
}

// The arguments are one range or two, and a bound.
template <class... Arguments>
Pairs near_pairs_of(const Arguments&... arguments)
{
  return sorted(reported([&](auto collect) {
    CGAL::fixed_radius_near_neighbors(arguments..., collect);
  }));
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_FOUND_PAIRS_H
