// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_SWEEP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_SWEEP_H

// The three ways in which the recursion of the book route ends. Each reports the intersecting pairs
// of a range of members that share no part, and returns false iff the search is to stop.
//
//   sweep       one dimension: each object meets those close behind it in the order along axis 0
//   walk        one dimension: the maximal disjoint sets of [V03], Lemmas 1 and 2
//   all_pairs   dimension zero: the alternative of [V03], end of section 2.3.2
//
// The walk tests each close pair once, like the sweep without the rule, so both do O(C(n + k))
// tests; only the sweep may ask share_a_part() before the predicate.

#include <CGAL/Thick_intersection_d/internal/recursion/Members.h>

#include <algorithm>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Scene, class Reporter>
bool test_pair(const Scene& scene, const Member& a, const Member& b, Reporter& report)
{
  return share_a_part(a, b) || !scene.do_intersect(a, b) || scene.report(a, b, report);
}

template <class Scene>
void sort_along_first_axis(const Scene& scene, Member_iterator first, Member_iterator last)
{
  std::sort(first, last, [&](const Member& a, const Member& b) { return scene.less(a, b, 0); });
}

// Moves the members of the first set to the front; returns where those of the second begin.
inline Member_iterator separate_sets(Member_iterator first, Member_iterator last)
{
  return std::partition(first, last,
                        [](const Member& m) { return (m.parts & second_set_bit) == 0; });
}

template <class Scene, class Reporter>
bool sweep_one_set(const Scene& scene, Member_iterator first, Member_iterator last,
                   Reporter& report)
{
  sort_along_first_axis(scene, first, last);
  for(Member_iterator a = first; a != last; ++a)
    for(Member_iterator b = a + 1; b != last && scene.is_close(*a, *b, 0); ++b)
      if(!test_pair(scene, *a, *b, report))
        return false;
  return true;
}

// Sweeps the first set over the second, so that pairs within a set are not even enumerated.
template <class Scene, class Reporter>
bool sweep_two_sets(const Scene& scene, Member_iterator first, Member_iterator last,
                    Reporter& report)
{
  const Member_iterator second = separate_sets(first, last);
  sort_along_first_axis(scene, first, second);
  sort_along_first_axis(scene, second, last);

  // All members of the second set before `begin` are before a, and too far from it.
  Member_iterator begin = second;
  for(Member_iterator a = first; a != second; ++a) {
    while(begin != last && scene.less(*begin, *a, 0) && !scene.is_close(*begin, *a, 0))
      ++begin;
    for(Member_iterator b = begin; b != last; ++b) {
      if(scene.is_close(*a, *b, 0)) {
        if(!test_pair(scene, *a, *b, report))
          return false;
      }
      else if(scene.less(*a, *b, 0))
        break; // else b is before a: is_close may be true too often, and was for begin
    }
  }
  return true;
}

template <class Scene, class Reporter>
bool sweep(const Scene& scene, Member_iterator first, Member_iterator last, Reporter& report)
{
  return scene.has_two_sets() ? sweep_two_sets(scene, first, last, report)
                              : sweep_one_set(scene, first, last, report);
}

template <class Scene, class Reporter>
bool all_pairs(const Scene& scene, Member_iterator first, Member_iterator last, Reporter& report)
{
  const bool two_sets = scene.has_two_sets();
  const Member_iterator second = two_sets ? separate_sets(first, last) : last;
  for(Member_iterator a = first; a != second; ++a)
    for(Member_iterator b = two_sets ? second : a + 1; b != last; ++b)
      if(!test_pair(scene, *a, *b, report))
        return false;
  return true;
}

// Lemma 1: walks along axis 0 and partitions the members into a maximal disjoint set, and the rest,
// which takes their place at the front, in the same order; reports the pairs between the two.
template <class Scene, class Reporter>
class Walk
{
public:
  Walk(const Scene& scene, Reporter& report) : scene_(scene), report_(report) {}

  // Lemma 2: repeats until the rest is empty. A loop, for there may be as many rounds as members.
  bool operator()(Member_iterator first, Member_iterator last)
  {
    sort_along_first_axis(scene_, first, last);
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
    if(!scene_.do_intersect(a, b))
      return true;
    do_intersect = true;
    return share_a_part(a, b) || scene_.report(a, b, report_);
  }

  // First pass: each member meets those of the disjoint set that are close before it.
  bool partition_off_disjoint_set(Member_iterator first, Member_iterator last)
  {
    disjoint_.clear();
    rest_.clear();
    for(Member_iterator a = first; a != last; ++a) {
      bool does_meet = false;
      for(auto b = disjoint_.rbegin();
          b != disjoint_.rend() && scene_.is_close(b->member, *a, 0); ++b)
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
      for(auto b = next; b != disjoint_.end() && scene_.is_close(a.member, b->member, 0); ++b)
        if(!test(a.member, b->member, does_meet))
          return false;
    }
    return true;
  }

  const Scene& scene_;
  Reporter& report_;
  Ranked_members disjoint_;
  Ranked_members rest_;
};

template <class Scene, class Reporter>
bool walk(const Scene& scene, Member_iterator first, Member_iterator last, Reporter& report)
{
  return Walk<Scene, Reporter>(scene, report)(first, last);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_SWEEP_H
