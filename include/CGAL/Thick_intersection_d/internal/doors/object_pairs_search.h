// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_PAIRS_SEARCH_H

// The common way of the public functions: check the input, then search it.

#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>

#include <optional>

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

// Has the traits of the package look at each object. Traits of others are taken at their word.
template <class Elements, class Traits>
void check_objects(const Elements& objects, const Traits& traits)
{
  if constexpr(Has_check<Traits>::value)
    for(std::size_t position = 0; position < objects.size(); ++position)
      traits.check(objects[position], position);
}

// Reports the intersecting pairs of the objects, which have been checked: those of one set, or, if
// `first_set_size` is given, those between the first so many objects and the others.
template <class ConcurrencyTag, class Elements, class Traits, class Callback,
          class NamedParameters>
bool report_intersections(const Elements& objects, std::optional<std::size_t> first_set_size,
                          const Traits& traits, Callback& callback, const NamedParameters& np)
{
  Book_options options;
  options.random_seed = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::random_seed), 0u);
  const Book_scene<Elements, Traits> scene(objects, first_set_size, traits);
  auto progress = make_progress(np, objects.size());
  return search_by_the_book<ConcurrencyTag>(scene, options, callback, progress);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_PAIRS_SEARCH_H
