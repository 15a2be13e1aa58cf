// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_ROUTE_H

// Chooses the route of objects by their traits.

#include <CGAL/Thick_intersection_d/internal/doors/Traits_boxes.h>
#include <CGAL/Thick_intersection_d/internal/doors/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/doors/recursive_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Traits, class = void>
struct Has_check : std::false_type {};
template <class Traits>
struct Has_check<Traits,
                 std::void_t<decltype(std::declval<const Traits&>().check(
                   std::declval<const typename Traits::Object_d&>(), std::size_t()))>>
  : std::true_type {};

// Checks each object with the traits, if they have check(), as the traits of the package do. Other
// traits have to check their objects themselves.
template <class ConcurrencyTag, class Elements, class Traits>
void check_objects(const Elements& objects, const Traits& traits)
{
  if constexpr(Has_check<Traits>::value)
    check_each<ConcurrencyTag>(objects.size(), [&](std::size_t position) {
      traits.check(objects[position], position);
    });
}

// Reports the pairs by the route that the traits allow. Boxes of finite doubles are for the box
// route. Objects beyond the range of doubles have boxes that all meet there, so they take the
// recursive route, if the traits have its predicates.
template <class ConcurrencyTag, class Elements, class Sets, class Traits, class Callback,
          class NamedParameters>
bool report_objects(const Elements& objects, const Sets& sets, const Traits& traits,
                    Callback& callback, const NamedParameters& np)
{
  if constexpr(Has_intervals<Traits>::value) {
    const Traits_boxes<Elements, Traits> boxes(objects, traits);
    const bool are_finite
      = boxes.template are_finite<ConcurrencyTag>() && fits_box_route(objects.size());
    if(are_finite || !Has_close_predicate<Traits>::value) {
      auto progress = make_progress(np, objects.size());
      return report_meeting_boxes<ConcurrencyTag>(boxes, sets, callback, progress);
    }
  }
  if constexpr(Has_close_predicate<Traits>::value)
    return report_recursively<ConcurrencyTag>(objects, sets, traits, callback, np);
  else
    return true;
}

// A specialization for some traits may take a faster route.
template <class Traits>
struct Object_route
{
  template <class ConcurrencyTag, class Elements, class Sets, class Callback,
            class NamedParameters>
  static bool report(const Elements& objects, const Sets& sets, const Traits& traits,
                     Callback& callback, const NamedParameters& np)
  {
    check_objects<ConcurrencyTag>(objects, traits);
    return report_objects<ConcurrencyTag>(objects, sets, traits, callback, np);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_ROUTE_H
