// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H

// The intersection test of kernel objects, exact for the coordinates that they hold. It is the test
// of the kernel, if the kernel is exact, and otherwise the test of a kernel with exact predicates.

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>

#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether an object is of a kernel. Other objects bring their own test.
template <class Object, class = void>
struct Has_kernel : std::false_type {};
template <class Object>
struct Has_kernel<Object, std::void_t<typename Kernel_traits<Object>::Kernel::Point_2>>
  : std::true_type {};

// Whether the predicates of a kernel are exact. CGAL calls `long long` an exact type, but products
// of such numbers overflow.
template <class FT>
constexpr bool has_exact_predicates_v
  = Algebraic_structure_traits<FT>::Is_exact::value && !std::is_arithmetic_v<FT>;

// A kernel whose predicates are exact on the objects of Kernel.
template <class Kernel>
using Kernel_with_exact_predicates = std::conditional_t<
  has_exact_predicates_v<typename Kernel::FT>, Kernel,
  std::conditional_t<is_held_by_double_v<typename Kernel::FT>,
                     Exact_predicates_inexact_constructions_kernel,
                     Simple_cartesian<Exact_rational>>>;

// Converts numbers without rounding, for Cartesian_converter.
template <class From, class To>
struct Convert_exactly
{
  To operator()(const From& x) const
  {
    if constexpr(is_held_by_double_v<From>)
      return To(static_cast<double>(x));
    else
      return to_exact_rational(x);
  }
};

// Makes the bounding box of a lazy object final. Otherwise the box would shrink when a predicate
// evaluates the object exactly, in the middle of a search that has ordered objects by their boxes.
template <class Object>
void settle(const Object& object)
{
  if constexpr(Has_kernel<Object>::value)
    if constexpr(Is_lazy<typename Kernel_traits<Object>::Kernel::FT>::value)
      CGAL::exact(object);
}

// Tests two objects of a kernel by predicates that are exact.
template <class Object>
bool do_kernel_objects_intersect(const Object& a, const Object& b)
{
  using Kernel = typename Kernel_traits<Object>::Kernel;
  using Exact_kernel = Kernel_with_exact_predicates<Kernel>;
  if constexpr(std::is_same_v<Kernel, Exact_kernel>)
    return do_intersect(a, b);
  else {
    const Cartesian_converter<Kernel, Exact_kernel,
                              Convert_exactly<typename Kernel::FT, typename Exact_kernel::FT>>
      convert;
    return do_intersect(convert(a), convert(b));
  }
}

// do_intersect() is found in the namespace of the objects.
template <class Object>
bool do_objects_intersect(const Object& a, const Object& b)
{
  if constexpr(Has_kernel<Object>::value)
    return do_kernel_objects_intersect(a, b);
  else
    return do_intersect(a, b);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H
