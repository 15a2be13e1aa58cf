// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PAPER_BASE_CASES_H
#define THICK_INTERSECTION_TEST_SUPPORT_PAPER_BASE_CASES_H

#include "standard_library.h"

// Two ways in which [V03] ends the recursion, beside the sweep of the package. Each reports the
// intersecting pairs of a range of members that share no side, and returns false iff the search is
// to stop.
//
//   walk        one dimension: the maximal disjoint sets of [V03], Lemmas 1 and 2
//   all_pairs   dimension zero: the alternative of [V03], end of section 2.3.2

#include <CGAL/Thick_intersection_d/internal/recursion/Members.h>

namespace test_support {

using CGAL::Thick_intersection_d::internal::Member;
using CGAL::Thick_intersection_d::internal::Member_iterator;

template <class Predicates, class Reporter>
bool all_pairs(const Predicates& predicates, Member_iterator first, Member_iterator last,
               Reporter& report)
{
  constexpr bool two_sets = Predicates::has_two_sets();
  const Member_iterator second = two_sets ? separate_sets(first, last) : last;
  for(Member_iterator a = first; a != second; ++a)
    for(Member_iterator b = two_sets ? second : a + 1; b != last; ++b)
      if(!test_pair(predicates, *a, *b, report))
        return false;
  return true;
}

// Lemma 1: walks along axis 0 and partitions the members into a maximal disjoint set, and the rest,
// which takes their place at the front, in the same order; reports the pairs between the two.
template <class Predicates, class Reporter>
class Walk
{
public:
  Walk(const Predicates& predicates, Reporter& report) : predicates_(predicates), report_(report) {}

  // Lemma 2: repeats until the rest is empty. A loop, for there may be as many rounds as members.
  bool operator()(Member_iterator first, Member_iterator last)
  {
    using CGAL::Thick_intersection_d::internal::Less_along_axis;
    std::sort(first, last, Less_along_axis<Predicates>{predicates_, 0});
    while(first != last) {
      if(!partition_off_disjoint_set(first, last) || !look_ahead())
        return false;
      last = std::transform(rest_.begin(), rest_.end(), first,
                            [](const Ranked& r) { return r.member; });
    }
    return true;
  }

private:
  struct Ranked
  {
    Member member;
    std::ptrdiff_t rank; // the position in the order along the axis
  };
  using Ranked_members = std::vector<Ranked>;

  // The predicate comes before the rule here: `disjoint_` has to be disjoint, or the bound C fails.
  bool test(const Member& a, const Member& b, bool& do_intersect)
  {
    if(!predicates_.do_intersect(a, b))
      return true;
    do_intersect = true;
    return share_a_side(a, b) || predicates_.report(a, b, report_);
  }

  // First pass: each member meets those of the disjoint set that are close before it.
  bool partition_off_disjoint_set(Member_iterator first, Member_iterator last)
  {
    disjoint_.clear();
    rest_.clear();
    for(Member_iterator a = first; a != last; ++a) {
      bool does_meet = false;
      for(auto b = disjoint_.rbegin();
          b != disjoint_.rend() && predicates_.is_close(b->member, *a, 0); ++b)
        if(!test(b->member, *a, does_meet))
          return false;
      (does_meet ? rest_ : disjoint_).push_back({*a, a - first});
    }
    return true;
  }

  // Second pass: each member of the rest meets those of the disjoint set that are close behind it.
  // Behind by rank, not by coordinate: equal ones have met in the first pass if they come before.
  bool look_ahead()
  {
    auto next = disjoint_.begin(); // the first of the disjoint set behind a
    for(const Ranked& a : rest_) {
      while(next != disjoint_.end() && next->rank < a.rank)
        ++next;
      bool does_meet = false;
      for(auto b = next; b != disjoint_.end() && predicates_.is_close(a.member, b->member, 0); ++b)
        if(!test(a.member, b->member, does_meet))
          return false;
    }
    return true;
  }

  const Predicates& predicates_;
  Reporter& report_;
  Ranked_members disjoint_;
  Ranked_members rest_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_PAPER_BASE_CASES_H
