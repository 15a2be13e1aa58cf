// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef THICK_INTERSECTION_TEST_SUPPORT_RECURSION_VARIANTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_RECURSION_VARIANTS_H

// The recursive route in the variants that [V03] has experiments with; all of them report the same
// pairs. Tests and benchmarks run them, the package has one.

#include "pairs.h"
#include "paper_base_cases.h"

#include <CGAL/Thick_intersection_d/internal/recursion/Recursive_route.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;

enum class Pivot {
  MEDIAN, // [V03], section 2.3
  RANDOM  // [V03], section 3: the version of the experiments
};

enum class Base_case { SWEEP, WALK, DIMENSION_ZERO };

// What the package calls Median_and_sweep is the first of the variants.
struct Recursion_variant
{
  Pivot pivot = Pivot::MEDIAN;
  Base_case base_case = Base_case::SWEEP;
  unsigned int random_seed = 0;

  int lowest_cut_axis() const { return base_case == Base_case::DIMENSION_ZERO ? 0 : 1; }

  template <class Predicates>
  Member choose_pivot(const Predicates& predicates, Member_iterator first, Member_iterator last,
                      int axis) const
  {
    if(pivot == Pivot::MEDIAN)
      return internal::Median_and_sweep().choose_pivot(predicates, first, last, axis);
    const std::size_t size = static_cast<std::size_t>(last - first);
    return first[static_cast<std::ptrdiff_t>(hash(first->position, size) % size)];
  }

  template <class Predicates, class Reporter>
  bool finish(const Predicates& predicates, Member_iterator first, Member_iterator last,
              Reporter& report) const
  {
    if(base_case == Base_case::SWEEP)
      return internal::sweep(predicates, first, last, report);
    if(base_case == Base_case::WALK)
      return Walk<Predicates, Reporter>(predicates, report)(first, last);
    return all_pairs(predicates, first, last, report);
  }

private:
  // A random number that depends on where in the recursion it is drawn, and not on when: the same
  // for any number of threads. [Steele, Lea, Flood: Fast splittable pseudorandom number generators]
  std::uint64_t hash(std::size_t position, std::size_t size) const
  {
    std::uint64_t x = random_seed + 0x9e3779b97f4a7c15 * (position + 1) + size;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }
};

inline std::array<Recursion_variant, 6> recursion_variants(unsigned int seed)
{
  return {{{Pivot::MEDIAN, Base_case::SWEEP, seed},
           {Pivot::MEDIAN, Base_case::WALK, seed},
           {Pivot::MEDIAN, Base_case::DIMENSION_ZERO, seed},
           {Pivot::RANDOM, Base_case::SWEEP, seed},
           {Pivot::RANDOM, Base_case::WALK, seed},
           {Pivot::RANDOM, Base_case::DIMENSION_ZERO, seed}}};
}

inline std::string name(const Recursion_variant& variant)
{
  const char* base_cases[] = {"sweep", "walk", "dimension zero"};
  return std::string(variant.pivot == Pivot::MEDIAN ? "median" : "random") + ", "
         + base_cases[static_cast<int>(variant.base_case)];
}

// Calls callback(i, j) for the pairs.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Range, class Traits, class Callback,
          class Sets = internal::One_set>
void search_by_variant(const Range& objects, const Traits& traits,
                       const Recursion_variant& variant, Callback& callback,
                       const Sets& sets = Sets())
{
  using Elements = internal::Numbered_elements<Range>;
  const Elements elements(objects);
  internal::Unwatched_progress progress;
  const auto report = internal::reporter_of(callback);
  internal::search_recursively(elements, sets, traits, report, progress,
                               internal::Threads(ConcurrencyTag()), variant);
}

// The pairs of one set, or of two if the size of the first one is given.
template <class Range, class Traits>
Pairs pairs_by_variant(const Range& objects, const Traits& traits,
                       const Recursion_variant& variant,
                       std::optional<std::size_t> first_set_size = std::nullopt)
{
  Pairs pairs;
  const auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  if(first_set_size)
    search_by_variant(objects, traits, variant, callback, internal::Two_sets{*first_set_size});
  else
    search_by_variant(objects, traits, variant, callback);
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_RECURSION_VARIANTS_H
