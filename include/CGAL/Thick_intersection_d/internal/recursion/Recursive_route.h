// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_RECURSIVE_ROUTE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_RECURSIVE_ROUTE_H

// Divide and conquer for thick objects. It uses the three predicates of ThickIntersectionTraits_d
// and nothing else.
//
//   [V03]  A. Vigneron. Reporting intersections among thick objects. IPL 85 (2003) 87-92.
//
// Cost: O(n log n + C(n + k)) time, O(n) space, for n objects, k intersecting pairs, and at most C
//       disjoint objects within a cube of two reaches. [V03, Theorem 1]
// Terms: objects are close if they are within a reach, the 2D of the paper. An axis is its index i.
//        The last axis is cut first.
//
// The paper cuts at numbers, med(E) or min(E) + 2D. Here all cuts are at objects, so the cuts need
// only Less_coordinate_d and Is_close_along_axis_d, and nothing is rounded. doc/differences.md
// lists the differences from the paper, with reasons.

#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/recursion/Members.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// What the recursion leaves open: where it cuts a range, and how it ends. The experiments of [V03]
// use variants of this class (test/support/recursion_variants.h).
struct Median_and_sweep
{
  // The base case takes the axes below this one.
  static constexpr int lowest_cut_axis() { return 1; }

  // Returns the member of [first, last) to cut the range at. Reorders the range.
  template <class Predicates>
  Member choose_pivot(const Predicates& predicates, Member_iterator first, Member_iterator last,
                      int axis) const
  {
    const Member_iterator median = first + (last - first) / 2;
    std::nth_element(first, median, last, Less_along_axis<Predicates>{predicates, axis});
    return *median;
  }

  // The base case. Returns false to stop the search.
  template <class Predicates, class Reporter>
  bool finish(const Predicates& predicates, Member_iterator first, Member_iterator last,
              Reporter& report) const
  {
    return sweep(predicates, first, last, report);
  }
};

template <class Predicates, class Reporter, class Progress, class Variant>
class Recursive_route
{
public:
  // report(i, j) returns false to stop the search.
  Recursive_route(const Predicates& predicates, Reporter& report, Progress& progress,
                  const Threads& threads, const Variant& variant)
    : predicates_(predicates), report_(report), progress_(progress), threads_(threads),
      variant_(variant), last_axis_((std::min)(predicates.dimension(), max_cut_axes) - 1)
  {}

  // Returns false iff the search was stopped.
  bool operator()()
  {
    Members members = predicates_.members();
    if(last_axis_ < 0 && !members.empty())
      return test_all_pairs(members);
    return search(members.begin(), members.end(), last_axis_);
  }

private:
  // The object to cut a range at along an axis, and whether to recurse into either side. A side
  // without recursion lies within a reach of the cut.
  struct Cut
  {
    Member at;
    bool recurse_below;
    bool recurse_above;
  };

  // Objects without axes are neither cut nor sorted.
  bool test_all_pairs(const Members& members)
  {
    for(const Member& b : members) {
      for(const Member* a = members.data(); a != &b; ++a)
        if(!test_pair(predicates_, *a, b, report_))
          return false;
      if(!advance(1, last_axis_))
        return false;
    }
    return true;
  }

  // Reports the intersecting pairs of [first, last) that share no side. Along each axis above
  // `axis`, all members are within two reaches of each other.
  bool search(Member_iterator first, Member_iterator last, int axis)
  {
    if(last - first < 2)
      return advance(last - first, axis);
    if(axis < variant_.lowest_cut_axis())
      return variant_.finish(predicates_, first, last, report_) && advance(last - first, axis);

    Cut cut;
    if(!find_cut(first, last, axis, cut))
      return search(first, last, axis - 1) && advance(last - first, axis);
    return divide(first, last, axis, cut);
  }

  // Finds where to cut [first, last) along `axis`. The paper has four cases: which of the lowest
  // and the highest object are close to the pivot, a median or random object?
  //
  //   both       Case 1: two reaches hold the range, so it needs no cut. Returns false.
  //   neither    Case 2: cut at the pivot, recurse on both sides
  //   lowest     Case 3: cut at the last object close to the lowest, recurse above
  //   highest    Case 4: cut at the first object close to the highest, recurse below
  //
  // The strip holds all objects of a side without recursion. Cases 3 and 4 do not cut at the pivot,
  // because an object above it could then be close to the next cut too, and to the cut after that.
  // With the cuts here, an object is in at most two strips. [V03, section 2.3.2]
  bool find_cut(Member_iterator first, Member_iterator last, int axis, Cut& cut)
  {
    const auto extremes
      = std::minmax_element(first, last, Less_along_axis<Predicates>{predicates_, axis});
    const Member lowest = *extremes.first;
    const Member highest = *extremes.second;
    if(predicates_.is_close(lowest, highest, axis))
      return false; // Case 1, for any cut

    const Member pivot = variant_.choose_pivot(predicates_, first, last, axis);
    cut = {pivot, !predicates_.is_close(lowest, pivot, axis),
           !predicates_.is_close(pivot, highest, axis)};
    if(cut.recurse_below == cut.recurse_above)
      return cut.recurse_below; // Case 1 or 2
    if(cut.recurse_above)
      cut.at = last_close_to(lowest, cut.at, first, last, axis);
    else
      cut.at = first_close_to(highest, cut.at, first, last, axis);
    return !predicates_.is_close(cut.at, cut.recurse_above ? highest : lowest, axis); // else Case 1
  }

  // Returns the last object that is close to `lowest`. `close` is one of these objects.
  Member last_close_to(const Member& lowest, Member close, Member_iterator first,
                       Member_iterator last, int axis) const
  {
    for(Member_iterator m = first; m != last; ++m)
      if(predicates_.less(close, *m, axis) && predicates_.is_close(lowest, *m, axis))
        close = *m;
    return close;
  }

  // Returns the first object that is close to `highest`. `close` is one of these objects.
  Member first_close_to(const Member& highest, Member close, Member_iterator first,
                        Member_iterator last, int axis) const
  {
    for(Member_iterator m = first; m != last; ++m)
      if(predicates_.less(*m, close, axis) && predicates_.is_close(*m, highest, axis))
        close = *m;
    return close;
  }

  // Divides [first, last) into the objects below, at and above the cut. Searches the strip along
  // the axes before this one, and recurses.
  //
  // The search meets each intersecting pair once. Unless the range of the pair ends without a cut,
  // there is one cut where the pair ceases to be on one recursed side. There the strip holds both
  // objects: each is close to the cut, or on a side without recursion. At the cuts before, the pair
  // shares the bit of the recursed side.
  bool divide(Member_iterator first, Member_iterator last, int axis, const Cut& cut)
  {
    const Member_iterator below_end = std::partition(
      first, last, [&](const Member& m) { return predicates_.less(m, cut.at, axis); });
    const Member_iterator above_begin = std::partition(
      below_end, last, [&](const Member& m) { return !predicates_.less(cut.at, m, axis); });

    Members strip; // a copy, made before the recursion reorders the range
    add_side(first, below_end, axis, cut, cut.recurse_below, lower_side_bit(axis), strip);
    add_side(below_end, above_begin, axis, cut, false, 0, strip);
    add_side(above_begin, last, axis, cut, cut.recurse_above, upper_side_bit(axis), strip);
    const std::ptrdiff_t left_behind = (cut.recurse_below ? 0 : below_end - first)
                                       + (above_begin - below_end)
                                       + (cut.recurse_above ? 0 : last - above_begin);

    const auto search_strip = [&] {
      Members members = std::move(strip); // released after its search, before the recursion
      return (!have_pairs(members) || search(members.begin(), members.end(), axis - 1))
             && advance(left_behind, axis);
    };
    const auto search_below
      = [&] { return !cut.recurse_below || search(first, below_end, axis); };
    const auto search_above
      = [&] { return !cut.recurse_above || search(above_begin, last, axis); };

    const Threads threads = last - first > parallel_cutoff ? threads_ : Threads();
    stop_.run_blocks(threads, 3, [&](std::size_t i, std::size_t end) {
      for(; i != end && !stop_.is_set(); ++i)
        if(!(i == 0 ? search_strip() : i == 1 ? search_below() : search_above()))
          stop_.set();
    });
    return !stop_.is_set();
  }

  // Appends the members of one side of the cut that may intersect members of the other side. If the
  // recursion takes the side, these are the members close to the cut, and they get the bit of the
  // side. Otherwise these are all members.
  void add_side(Member_iterator first, Member_iterator last, int axis, const Cut& cut,
                bool is_recursed, std::uint64_t side_bit, Members& strip)
  {
    for(Member_iterator m = first; m != last; ++m)
      if(!is_recursed)
        strip.push_back(*m);
      else if(predicates_.is_close(*m, cut.at, axis))
        strip.push_back({m->position, m->sides | side_bit});
  }

  // Whether two members may share no side: false if all members have a bit in common.
  static bool have_pairs(const Members& strip)
  {
    std::uint64_t common = ~std::uint64_t(0);
    for(const Member& m : strip)
      common &= m.sides;
    return common == 0;
  }

  // Counts objects as finished when the axis that is cut first is done with them.
  bool advance(std::ptrdiff_t finished, int axis)
  {
    if(axis == last_axis_ && !progress_.advance(static_cast<std::size_t>(finished)))
      stop_.set();
    return !stop_.is_set();
  }

  // Smaller ranges are not worth a task.
  static constexpr std::ptrdiff_t parallel_cutoff = 4096;

  const Predicates& predicates_;
  Reporter& report_;
  Progress& progress_;
  const Threads threads_;
  const Variant variant_;
  const int last_axis_;
  Stop_flag stop_;
};

// Reports the intersecting pairs of checked objects. Returns false iff the search was stopped.
template <class Elements, class Sets, class Traits, class Reporter, class Progress,
          class Variant = Median_and_sweep>
bool search_recursively(const Elements& objects, const Sets& sets, const Traits& traits,
                        Reporter& report, Progress& progress, const Threads& threads,
                        const Variant& variant = Variant())
{
  using Predicates = Member_predicates<Elements, Sets, Traits>;
  const Predicates predicates(objects, sets, traits);
  Recursive_route<Predicates, Reporter, Progress, Variant> route(predicates, report, progress,
                                                                 threads, variant);
  return route();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_RECURSIVE_ROUTE_H
