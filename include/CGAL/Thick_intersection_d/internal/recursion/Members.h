// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_MEMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_MEMBERS_H

// What the recursive route sees of the input: positions, and three predicates on them. The end of
// the recursion is a sweep along the only axis that is left.
//
// [V03] is cited in Recursive_route.h.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// An object on its way through the recursion.
//
// `sides` has a bit for each recursed side of a cut that the object is on, and a bit for its set.
// The separation rule: a search reports no pair that shares a bit. The rule replaces the flags of
// [V03], section 2.3.1, case 2. In a strip, the members of a recursed side carry the bit of that
// side, because the recursion reports their pairs. A search between two sets reports no pair within
// a set.
struct Member
{
  std::size_t position;
  std::uint64_t sides;
};

using Members = std::vector<Member>;
using Member_iterator = Members::iterator;

inline bool share_a_side(const Member& a, const Member& b) { return (a.sides & b.sides) != 0; }

// At most this many axes are cut, because each takes two bits. Do_intersect_d covers the others.
inline constexpr int max_cut_axes = 31;

inline std::uint64_t lower_side_bit(int axis) { return std::uint64_t(1) << (2 * axis); }
inline std::uint64_t upper_side_bit(int axis) { return std::uint64_t(2) << (2 * axis); }
inline constexpr std::uint64_t first_set_bit = std::uint64_t(1) << (2 * max_cut_axes);
inline constexpr std::uint64_t second_set_bit = first_set_bit << 1;

// The predicates of a traits class, on members.
template <class Elements, class Sets, class Traits>
class Member_predicates
{
public:
  Member_predicates(const Elements& elements, const Sets& sets, const Traits& traits)
    : elements_(elements), sets_(sets),
      less_(traits.less_coordinate_d_object()), is_close_(traits.is_close_along_axis_d_object()),
      do_intersect_(traits.do_intersect_d_object()), dimension_(traits.dimension())
  {}

  int dimension() const { return dimension_; }
  static constexpr bool has_two_sets() { return Sets::are_two; }

  Members members() const
  {
    Members all(elements_.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      all[i] = {i, set_bit(i)};
    return all;
  }

  bool less(const Member& a, const Member& b, int axis) const
  {
    return less_(elements_[a.position], elements_[b.position], axis);
  }
  bool is_close(const Member& a, const Member& b, int axis) const
  {
    return is_close_(elements_[a.position], elements_[b.position], axis);
  }
  bool do_intersect(const Member& a, const Member& b) const
  {
    return do_intersect_(elements_[a.position], elements_[b.position]);
  }

  // Hands the pair to `report`: positions i < j, or with two sets a position in each range.
  template <class Reporter>
  bool report(const Member& a, const Member& b, Reporter& report) const
  {
    const std::size_t i = (std::min)(a.position, b.position);
    const std::size_t j = (std::max)(a.position, b.position);
    return report(i, j - sets_.first_of_second());
  }

private:
  std::uint64_t set_bit(std::size_t position) const
  {
    if constexpr(has_two_sets())
      return position < sets_.first_size ? first_set_bit : second_set_bit;
    else
      return 0;
  }

  const Elements& elements_;
  Sets sets_;
  decltype(std::declval<const Traits&>().less_coordinate_d_object()) less_;
  decltype(std::declval<const Traits&>().is_close_along_axis_d_object()) is_close_;
  decltype(std::declval<const Traits&>().do_intersect_d_object()) do_intersect_;
  int dimension_;
};

// Compares members along an axis.
template <class Predicates>
struct Less_along_axis
{
  const Predicates& predicates;
  int axis;
  bool operator()(const Member& a, const Member& b) const { return predicates.less(a, b, axis); }
};

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
//
// The sweep asks whether two members share a side before it asks the predicate. Without the first
// question it would test each close pair once, as the walk of [V03], Lemmas 1 and 2, does. So it
// makes O(C(n + k)) tests.
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

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_MEMBERS_H
