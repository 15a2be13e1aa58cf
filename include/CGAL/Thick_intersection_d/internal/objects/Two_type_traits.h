// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_TWO_TYPE_TRAITS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_TWO_TYPE_TRAITS_H

// The user's traits for objects of two types, as the routes see them: traits for one type, which is
// one of two.

#include <CGAL/Thick_intersection_d/internal/input/kinds.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The dimension that traits have as a constant, if they have one.
template <class Traits, class = void>
struct Constant_dimension
{};
template <class Traits>
struct Constant_dimension<Traits, std::void_t<typename Traits::Dimension>>
{
  using Dimension = typename Traits::Dimension;
};

// Refers to the traits. `Interval_d` takes either type, and `Do_intersect_d` an object of the first
// range and one of the second, in this order.
template <class Traits, class Object>
class Two_type_traits : public Constant_dimension<Traits>
{
public:
  using Object_d = Object;

  explicit Two_type_traits(const Traits& traits) : traits_(traits) {}

  int dimension() const { return traits_.dimension(); }

  auto interval_d_object() const
  {
    return [interval = traits_.interval_d_object()](const Object& object, int axis) {
      return of_range(object, [&](const auto& x) { return interval(x, axis); });
    };
  }

  auto do_intersect_d_object() const
  {
    return [do_intersect = traits_.do_intersect_d_object()](const Object& a, const Object& b) {
      return of_ranges(a, b, [&](const auto& x, const auto& y) { return do_intersect(x, y); });
    };
  }

  // For an object of either type, if the traits check it. `Given` is the type of the traits. If it
  // were no parameter of the function, traits without any check() would not compile.
  template <class T, class Given = Traits>
  auto check(const T& object, std::size_t position) const
    -> decltype(std::declval<const Given&>().check(object, position))
  {
    return traits_.check(object, position);
  }

private:
  const Traits& traits_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_TWO_TYPE_TRAITS_H
