// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PAIR_SEARCH_H

// What all functions that report pairs do with their arguments: check their types, number the
// elements, and give a callback of two positions to the search.

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Range, class NamedParameters>
using Elements_of_range
  = decltype(make_elements(std::declval<Range&>(), std::declval<const NamedParameters&>()));

template <class ConcurrencyTag, class RangeA, class RangeB, class Callback, class NamedParameters>
constexpr bool check_pair_search()
{
  if constexpr(!check_range<ConcurrencyTag, RangeA, NamedParameters>())
    return false;
  else if constexpr(!check_range<ConcurrencyTag, RangeB, NamedParameters>())
    return false;
  else
    return check_callback<Callback, Elements_of_range<RangeA, NamedParameters>,
                          Elements_of_range<RangeB, NamedParameters>>();
}

// Returns search(elements, sets, report) for the elements of a range.
template <class ConcurrencyTag, class Range, class Callback, class NamedParameters, class Search>
bool search_range(Range& range, Callback& callback, const NamedParameters& np,
                  const Search& search)
{
  if constexpr(check_pair_search<ConcurrencyTag, Range, Range, Callback, NamedParameters>()) {
    const auto elements = make_elements(range, np);
    auto&& report = pair_output<ConcurrencyTag>(elements, elements, callback);
    return search(elements, One_set(), report);
  }
  else
    return false;
}

// Returns search(elements, sets, report) for the elements of two ranges.
template <class ConcurrencyTag, class RangeA, class RangeB, class Callback, class NamedParameters,
          class Search>
bool search_two_ranges(RangeA& range_a, RangeB& range_b, Callback& callback,
                       const NamedParameters& np, const Search& search)
{
  if constexpr(check_pair_search<ConcurrencyTag, RangeA, RangeB, Callback, NamedParameters>())
    return with_two_ranges(range_a, range_b, np, [&](const auto& elements, std::size_t size_a) {
      auto&& report
        = pair_output<ConcurrencyTag>(elements.first(), elements.second(), callback);
      return search(elements, Two_sets{size_a}, report);
    });
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_PAIR_SEARCH_H
