// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_RECURSIVE_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_RECURSIVE_SEARCH_H

// Calls the recursive route.

#include <CGAL/Thick_intersection_d/internal/recursion/Members.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Reports the intersecting pairs of checked objects. Returns false iff the search was stopped.
template <class ConcurrencyTag, class Elements, class Sets, class Traits, class Callback,
          class NamedParameters>
bool report_recursively(const Elements& objects, const Sets& sets, const Traits& traits,
                        Callback& callback, const NamedParameters& np)
{
  const Member_predicates<Elements, Sets, Traits> predicates(objects, sets, traits);
  auto progress = make_progress(np, objects.size());
  return search_recursively<ConcurrencyTag>(predicates, callback, progress);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_RECURSIVE_SEARCH_H
