// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The book route in each of its variants, on any traits.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_BOOK_VARIANTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_BOOK_VARIANTS_H

#include "pairs.h"

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>

#include <array>
#include <optional>
#include <ostream>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Base_case;
using internal::Book_options;
using internal::Pivot;

inline std::array<Book_options, 6> book_variants(unsigned int seed)
{
  return {{{Pivot::MEDIAN, Base_case::SWEEP, seed},
           {Pivot::MEDIAN, Base_case::WALK, seed},
           {Pivot::MEDIAN, Base_case::DIMENSION_ZERO, seed},
           {Pivot::RANDOM, Base_case::SWEEP, seed},
           {Pivot::RANDOM, Base_case::WALK, seed},
           {Pivot::RANDOM, Base_case::DIMENSION_ZERO, seed}}};
}

inline std::string name(const Book_options& options)
{
  const char* base_cases[] = {"sweep", "walk", "dimension zero"};
  return std::string(options.pivot == Pivot::MEDIAN ? "median" : "random") + ", "
         + base_cases[static_cast<int>(options.base_case)];
}

// With two sets, the first `first_set_size` objects are those of the first.
template <class Range, class Traits>
Pairs book_pairs(const Range& objects, const Traits& traits, const Book_options& options,
                 std::optional<std::size_t> first_set_size = std::nullopt)
{
  Pairs pairs;
  const auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  const internal::Elements<Range> elements(objects);
  const internal::Book_scene<internal::Elements<Range>, Traits> scene(elements, first_set_size,
                                                                      traits);
  internal::No_progress progress;
  internal::search_by_the_book<CGAL::Sequential_tag>(scene, options, callback, progress);
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_BOOK_VARIANTS_H
