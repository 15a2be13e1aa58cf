// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H

// Do two closed objects intersect, of any kinds? The predicates of the package decide about objects
// of CGAL, thickened or not, and do_intersect() about others.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_bound.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_objects_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The algebraic degree of the squared distance of two objects of the kinds A and B.
template <class A, class B>
struct Distance_degree
  : std::integral_constant<int, hull_size_v<A> == 1 && hull_size_v<B> == 1
                                  ? 2 : 2 * hull_dimension_v<A>>
{};

// That of the test whether they intersect.
template <class A, class B>
constexpr int degree_of_intersection()
{
  if constexpr(Is_thickened<A>::value || Is_thickened<B>::value)
    return Distance_degree<A, B>::value;
  else {
    constexpr bool is_a_box = Vertex_count<A>::value == 1 || is_iso_box_v<A>;
    constexpr bool is_b_box = Vertex_count<B>::value == 1 || is_iso_box_v<B>;
    return is_a_box && is_b_box ? 1 : vertex_dimension_v<A>;
  }
}
template <class A, class B>
struct Intersection_degree : std::integral_constant<int, degree_of_intersection<A, B>()> {};

template <template <class, class> class Degree, class A, class... Kinds_b>
constexpr int largest_degree_with(std::tuple<Kinds_b...>*)
{
  return (std::max)({Degree<A, Kinds_b>::value...});
}
template <template <class, class> class Degree, class... Kinds_a, class Tuple_b>
constexpr int largest_degree(std::tuple<Kinds_a...>*, Tuple_b* b)
{
  return (std::max)({largest_degree_with<Degree, Kinds_a>(b)...});
}

// The largest degree of the test of two objects of a range, or of one of each of two ranges.
template <template <class, class> class Degree, class A, class B = A>
constexpr int degree_of()
{
  if constexpr(Is_one_of_two<A>::value)
    return degree_of<Degree, typename A::First, typename A::Second>();
  else
    return largest_degree<Degree>(static_cast<typename Kinds_of<A>::type*>(nullptr),
                                  static_cast<typename Kinds_of<B>::type*>(nullptr));
}

// Whether objects of one known kind each intersect.
template <class A, class B>
bool do_kinds_intersect(const A& a, const B& b, Arithmetic_tier& tier)
{
  if constexpr(Is_thickened<A>::value || Is_thickened<B>::value) {
    using Exact = typename Common_exact_number<std::tuple<A, B>>::type;
    const auto no_distance = [] { return Squared_bound<Exact>(within_distance(0)); };
    return are_kinds_near(a, b, Hull_bound(), no_distance, tier);
  }
  else
    return do_kernel_objects_intersect(a, b, tier);
}

// Whether objects of one type each intersect. The test of a class of the user with another class is
// found in their namespaces.
template <class A, class B>
bool do_types_intersect(const A& a, const B& b, Arithmetic_tier& tier)
{
  constexpr bool are_known
    = Is_known_kind<Base_kind_t<A>>::value && Is_known_kind<Base_kind_t<B>>::value;
  if constexpr(Has_own_test<A, B>::value || (!are_known && !Has_own_test<B, A>::value))
    return do_intersect(a, b);
  else if constexpr(Has_own_test<B, A>::value)
    return do_intersect(b, a);
  else
    return do_kinds_intersect(as_base(a), as_base(b), tier);
}

// Whether two objects whose bounding boxes meet intersect. `tier` is the first arithmetic after the
// filter, and becomes the one that was needed.
template <class Object>
bool do_objects_intersect(const Object& a, const Object& b, Arithmetic_tier& tier)
{
  return with_types(a, b, [&](const auto& x, const auto& y) {
    return do_types_intersect(x, y, tier);
  });
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H
