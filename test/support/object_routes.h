// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The pairs of objects by routes that the public functions take for other scenes.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_OBJECT_ROUTES_H
#define THICK_INTERSECTION_TEST_SUPPORT_OBJECT_ROUTES_H

#include "number_boxes.h"

#include <CGAL/Thick_intersection_d/internal/objects/Object_route.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>

namespace test_support {

// The recursive route, as public functions call it: so it is not compiled once more.
template <class Object, class Traits, class Callback>
void report_by_recursion(const std::vector<Object>& objects,
                         std::optional<std::size_t> first_set_size, const Traits& traits,
                         Callback& callback)
{
  const auto& np = CGAL::parameters::default_values();
  internal::Unwatched_progress progress;
  const auto report = internal::reporter_of(callback);
  const auto search = [&](const auto& elements, const auto& sets) {
    internal::search_recursively(elements, sets, traits, report, progress, internal::Threads());
  };
  if(!first_set_size)
    return search(internal::make_elements(objects, np), internal::One_set());
  const auto [a, b] = split(objects, *first_set_size);
  internal::with_sets(search, internal::make_elements(a, np), internal::make_elements(b, np));
}

// The box route with many cuts, in another way for each seed.
template <class Object, class Traits, class Callback>
void report_by_cuts(const std::vector<Object>& objects, std::optional<std::size_t> first_set_size,
                    const Traits& traits, Callback& callback, std::uint64_t seed)
{
  using Elements = internal::Numbered_elements<std::vector<Object>>;
  const Elements elements(objects);
  const internal::Traits_boxes<Elements, Traits> boxes(elements, traits);
  Generator random(seed);
  internal::Unwatched_progress progress;
  const auto report = [&](std::size_t i, std::size_t j) {
    callback(i, j - first_set_size.value_or(0)); // one numbering is for both sets
  };
  search_boxes<decltype(boxes)::static_dimension>(boxes, small_tuning(random), first_set_size,
                                                  report, progress);
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_OBJECT_ROUTES_H
