// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_OBJECTS_NEAR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_OBJECTS_NEAR_H

// Are two closed objects within a distance? A filter in doubles, whether they intersect, integers
// and exact numbers decide, in this order.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_bound.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_hulls_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/exact_hull_distance.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The exact numbers that hold the numbers of objects of several kinds.
template <class Kinds>
struct Common_exact_number;
template <class First, class... Others>
struct Common_exact_number<std::tuple<First, Others...>>
{
  using Exact = Exact_number_t<Hull_number_t<First>>;
  template <class Kind>
  static constexpr bool has_it
    = std::is_same_v<Exact, Exact_number_t<Hull_number_t<Kind>>>
      && std::is_same_v<Exact, Exact_number_t<typename Radius_number<Kind>::type>>;
  using type
    = std::conditional_t<has_it<First> && (has_it<Others> && ...), Exact, Exact_rational>;
};

template <class Object>
using Common_exact_number_t = typename Common_exact_number<typename Kinds_of<Object>::type>::type;

// Returns the exact radius of an object: zero, unless it is a ball.
template <class Exact, class Object>
Exact exact_radius(const Object& object)
{
  if constexpr(Is_ball<Object>::value)
    return exact_value<Exact>(object.second);
  else
    return Exact(0);
}

// Returns what compares a squared distance n / d of the hulls of two objects with a bound.
template <class Exact, class A, class B>
auto comparison_with(const Squared_bound<Exact>& bound, const A& a, const B& b)
{
  const Exact radii(exact_radius<Exact>(a) + exact_radius<Exact>(b));
  return [&bound, radii](const Exact& n, const Exact& d) { return bound.holds_for(n, d, radii); };
}

// The distance of objects as doubles know it.
template <class A, class B>
using Distance_of = Hull_distance<hull_dimension_v<A>, hull_size_v<A>, hull_size_v<B>>;

// Whether objects of one kind each, which are apart, are within a bound, as integers of 128 bits
// tell. Returns nothing if they have too few bits.
template <class A, class B>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED std::optional<bool>
are_near_in_integers(const Hull_of<A>& a, const Hull_of<B>& b, const Distance_of<A, B>& distance,
                     const Hull_bound& bound)
{
  if(!bound.is_exact_radius || a.error != 0 || b.error != 0 || a.radius.length() != 0
     || b.radius.length() != 0)
    return std::nullopt;
  std::vector<std::array<double, hull_dimension_v<A>>> vertices_of_a, vertices_of_b;
  for(std::size_t k = 0; k < hull_size_v<A>; ++k)
    if(distance.may_be_nearest_of_a(k))
      vertices_of_a.push_back(a.vertices[k]);
  for(std::size_t k = 0; k < hull_size_v<B>; ++k)
    if(distance.may_be_nearest_of_b(k))
      vertices_of_b.push_back(b.vertices[k]);
  return Integer_hulls<hull_dimension_v<A>>(vertices_of_a, vertices_of_b, a.radius.low,
                                            b.radius.low, bound.radius.low)
    .are_near(bound.is_open);
}

// The same in exact numbers.
template <class Exact, class A, class B>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool are_near_in_exact_numbers(const A& a, const B& b,
                                                  const Distance_of<A, B>& distance,
                                                  const Squared_bound<Exact>& bound)
{
  constexpr std::size_t dimension = static_cast<std::size_t>(hull_dimension_v<A>);
  std::vector<Exact_vector<Exact, dimension>> vertices_of_a, vertices_of_b;
  for(std::size_t k = 0; k < hull_size_v<A>; ++k)
    if(distance.may_be_nearest_of_a(k))
      vertices_of_a.push_back(exact_hull_vertex<Exact>(a, k));
  for(std::size_t k = 0; k < hull_size_v<B>; ++k)
    if(distance.may_be_nearest_of_b(k))
      vertices_of_b.push_back(exact_hull_vertex<Exact>(b, k));
  const auto within = comparison_with(bound, a, b);
  return Exact_hull_distance<Exact, dimension, decltype(within)>(within)(vertices_of_a,
                                                                        vertices_of_b);
}

// Returns doubles that enclose the bound on the distance of the hulls of two objects.
template <class A, class B>
Interval reach_of_objects(const Hull_bound& bound, const A& a, const B& b)
{
  if constexpr(Is_ball<A>::value || Is_ball<B>::value)
    return reach_of_hulls(bound, hull_radius(a), hull_radius(b));
  else
    return bound.radius;
}

// The question that the first guesses leave undecided. `v` is the last of them. Objects that
// intersect are within every bound.
template <class A, class B, class Exact_bound>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool
decide_near_objects(const A& a, const B& b, const typename Distance_of<A, B>::Vector& v,
                    const Hull_bound& bound, const Exact_bound& exact_bound, Arithmetic_tier& tier)
{
  const Hull_of<A> hull_a = hull_of(a);
  const Hull_of<B> hull_b = hull_of(b);
  Distance_of<A, B> distance(hull_a, hull_b, v);
  const Uncertain<bool> are_within = distance.is_within(reach_of_objects(bound, a, b));
  if(is_certain(are_within)) {
    tier = Arithmetic_tier::DOUBLE;
    return get_certain(are_within);
  }
  const Arithmetic_tier least_tier = tier;
  const bool do_intersect = do_kernel_objects_intersect(hull_points(a), hull_points(b), tier);
  tier = (std::max)(tier, Arithmetic_tier::INT128);
  if(do_intersect)
    return true;
  if(least_tier != Arithmetic_tier::FILTERED_EXACT)
    if(const auto are_near = are_near_in_integers<A, B>(hull_a, hull_b, distance, bound))
      return *are_near;
  tier = Arithmetic_tier::FILTERED_EXACT;
  return are_near_in_exact_numbers(a, b, distance, exact_bound());
}

// What doubles guess first about the distance of two objects. `v` is as in are_hulls_near().
template <class A, class B>
BOOST_FORCEINLINE Uncertain<bool> guess_near_objects(const A& a, const B& b,
                                                     const Interval& reach,
                                                     typename Distance_of<A, B>::Vector& v)
{
  constexpr std::size_t size_a = hull_size_v<A>, size_b = hull_size_v<B>;
  if constexpr(has_double_vertices_v<Hull_points_t<A>> && has_double_vertices_v<Hull_points_t<B>>)
    return are_hulls_near<size_a, size_b>(a, b, 0, reach, v);
  else {
    const Hull_of<A> hull_a = hull_of(a);
    const Hull_of<B> hull_b = hull_of(b);
    return are_hulls_near<size_a, size_b>(hull_a, hull_b, hull_a.error + hull_b.error, reach, v);
  }
}

// Whether objects of one kind each are within a bound, which holds for the distance zero at least.
// `exact_bound` returns it for exact numbers. `tier` is the first arithmetic after the filter, and
// becomes the one that was needed.
template <class A, class B, class Exact_bound>
bool are_kinds_near(const A& a, const B& b, const Hull_bound& bound, const Exact_bound& exact_bound,
                    Arithmetic_tier& tier)
{
  typename Distance_of<A, B>::Vector v;
  const Uncertain<bool> are_near = guess_near_objects(a, b, reach_of_objects(bound, a, b), v);
  if(!is_certain(are_near))
    return decide_near_objects(a, b, v, bound, exact_bound, tier);
  tier = Arithmetic_tier::DOUBLE;
  return get_certain(are_near);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_OBJECTS_NEAR_H
