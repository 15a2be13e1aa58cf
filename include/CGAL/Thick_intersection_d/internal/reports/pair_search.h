// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_SEARCH_H

// What all functions that report pairs do with their arguments: check their types, number the
// elements, and give a callback of two positions to the search.

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>

#include <cstddef>
#include <tuple>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A search reports the pairs in one set, or the pairs between two sets. A type says which: a call
// compiles only one of the two searches.
//
// All elements.
struct One_set
{
  static constexpr bool are_two = false;
  std::size_t first_of_second() const { return 0; } // subtracted from positions in the second set
};

// The first `first_size` elements, and all other elements.
struct Two_sets
{
  static constexpr bool are_two = true;
  std::size_t first_size;
  std::size_t first_of_second() const { return first_size; }
};

// Returns task(elements, sets) for the elements of one range, or of two in one numbering.
template <class Task, class Elements>
auto with_sets(const Task& task, const Elements& elements)
{
  return task(elements, One_set());
}
template <class Task, class First, class Second>
auto with_sets(const Task& task, const First& first, const Second& second)
{
  return task(Joined_elements(first, second), Two_sets{first.size()});
}

template <bool Takes_interiors, class Callback, class NamedParameters, class... Ranges>
constexpr bool check_pair_search()
{
  if constexpr((check_range<Ranges, NamedParameters, Takes_interiors>() && ...)) {
    using Elements = std::tuple<Elements_of<Ranges, NamedParameters>...>;
    return check_callback<Callback, std::tuple_element_t<0, Elements>,
                          std::tuple_element_t<sizeof...(Ranges) - 1, Elements>>();
  }
  else
    return false;
}

// Returns search(elements, sets, report) for the elements of one range, or of two.
template <bool Takes_interiors = false, class Callback, class NamedParameters, class Search,
          class... Ranges>
bool search_ranges(Callback& callback, const NamedParameters& np, const Threads& threads,
                   const Search& search, Ranges&... ranges)
{
  if constexpr(check_pair_search<Takes_interiors, Callback, NamedParameters, Ranges...>()) {
    const auto search_sets = [&](const auto& elements, const auto& sets) {
      auto&& report = pair_output(elements.first(), elements.second(), callback, threads);
      return search(elements, sets, report);
    };
    return with_sets(search_sets, make_elements(ranges, np)...);
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_PAIR_SEARCH_H
