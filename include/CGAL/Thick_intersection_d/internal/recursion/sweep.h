// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_SWEEP_H

// The end of the recursion: a sweep along the only axis that is left.
//
// The sweep asks whether two members share a side before it asks the predicate. Without the first
// question it would test each close pair once, as the walk of [V03], Lemmas 1 and 2, does. So it
// makes O(C(n + k)) tests. [V03] is cited in Recursive_route.h.

#include <CGAL/Thick_intersection_d/internal/recursion/Members.h>

#include <algorithm>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Predicates, class Reporter>
bool test_pair(const Predicates& predicates, const Member& a, const Member& b, Reporter& report)
{
  return share_a_side(a, b) || !predicates.do_intersect(a, b) || predicates.report(a, b, report);
}

// Moves the members of the first set to the front. Returns where the second set begins.
inline Member_iterator separate_sets(Member_iterator first, Member_iterator last)
{
  return std::partition(first, last,
                        [](const Member& m) { return (m.sides & second_set_bit) == 0; });
}

template <class Predicates, class Reporter>
bool sweep_one_set(const Predicates& predicates, Member_iterator first, Member_iterator last,
                   Reporter& report)
{
  std::sort(first, last, Less_along_axis<Predicates>{predicates, 0});
  for(Member_iterator a = first; a != last; ++a)
    for(Member_iterator b = a + 1; b != last && predicates.is_close(*a, *b, 0); ++b)
      if(!test_pair(predicates, *a, *b, report))
        return false;
  return true;
}

// Sweeps the first set over the second, and does not enumerate the pairs within a set.
template <class Predicates, class Reporter>
bool sweep_two_sets(const Predicates& predicates, Member_iterator first, Member_iterator last,
                    Reporter& report)
{
  const Member_iterator second = separate_sets(first, last);
  std::sort(first, second, Less_along_axis<Predicates>{predicates, 0});
  std::sort(second, last, Less_along_axis<Predicates>{predicates, 0});

  // Invariant: the members of the second set before `begin` are before a, and not close to a.
  Member_iterator begin = second;
  for(Member_iterator a = first; a != second; ++a) {
    while(begin != last && predicates.less(*begin, *a, 0) && !predicates.is_close(*begin, *a, 0))
      ++begin;
    for(Member_iterator b = begin; b != last; ++b) {
      if(predicates.is_close(*a, *b, 0)) {
        if(!test_pair(predicates, *a, *b, report))
          return false;
      }
      else if(predicates.less(*a, *b, 0))
        break; // otherwise b is before a: is_close() may be true too often, and was for `begin`
    }
  }
  return true;
}

// Reports the intersecting pairs of [first, last) that share no side. Returns false to stop.
template <class Predicates, class Reporter>
bool sweep(const Predicates& predicates, Member_iterator first, Member_iterator last,
           Reporter& report)
{
  if constexpr(Predicates::has_two_sets())
    return sweep_two_sets(predicates, first, last, report);
  else
    return sweep_one_set(predicates, first, last, report);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_SWEEP_H
