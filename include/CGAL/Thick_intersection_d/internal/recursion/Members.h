// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_MEMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_MEMBERS_H

// What the book route sees of the input: positions, and three predicates on them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// An object on its way through the recursion.
//
// `parts` has one bit for each part of the scene that the object lies in and that somebody else
// takes care of: a pair that shares a bit is not reported here. This is the separation rule, which
// replaces the flags of [V03], section 2.3.1, case 2: of the objects in a strip, those in a
// recursed child carry the bit of that child; and with two sets, each object that of its set.
struct Member
{
  std::size_t position;
  std::uint64_t parts;
};

using Members = std::vector<Member>;
using Member_iterator = Members::iterator;

inline bool share_a_part(const Member& a, const Member& b)
{
  return (a.parts & b.parts) != 0;
}

// Axes beyond these are not cut but left to Do_intersect_d: there is a pair of bits for each.
constexpr int max_cut_axes = 31;

inline std::uint64_t lower_child_bit(int axis) { return std::uint64_t(1) << (2 * axis); }
inline std::uint64_t upper_child_bit(int axis) { return std::uint64_t(2) << (2 * axis); }
constexpr std::uint64_t first_set_bit = std::uint64_t(1) << (2 * max_cut_axes);
constexpr std::uint64_t second_set_bit = first_set_bit << 1;

// The predicates of a traits class, on members.
template <class Elements, class Traits>
class Book_scene
{
public:
  // With two sets, the first `first_set_size` elements are those of the first.
  Book_scene(const Elements& elements, std::optional<std::size_t> first_set_size,
             const Traits& traits)
    : elements_(elements), first_set_size_(first_set_size),
      less_(traits.less_coordinate_d_object()), is_close_(traits.is_close_along_axis_d_object()),
      do_intersect_(traits.do_intersect_d_object()), dimension_(traits.dimension())
  {}

  int dimension() const { return dimension_; }
  bool has_two_sets() const { return first_set_size_.has_value(); }

  Members members() const
  {
    Members all(elements_.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      all[i] = {i, !has_two_sets() ? 0 : i < *first_set_size_ ? first_set_bit : second_set_bit};
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

  // Hands the pair to `report` in the order of the user's positions, each in its own range.
  template <class Reporter>
  bool report(const Member& a, const Member& b, Reporter& report) const
  {
    const std::size_t i = (std::min)(a.position, b.position);
    const std::size_t j = (std::max)(a.position, b.position);
    return report(i, has_two_sets() ? j - *first_set_size_ : j);
  }

private:
  const Elements& elements_;
  std::optional<std::size_t> first_set_size_;
  typename Traits::Less_coordinate_d less_;
  typename Traits::Is_close_along_axis_d is_close_;
  typename Traits::Do_intersect_d do_intersect_;
  int dimension_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_RECURSION_MEMBERS_H
