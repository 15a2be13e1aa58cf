// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_OBJECTS_NEAR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_OBJECTS_NEAR_H

// Are two closed objects within a distance? A filter in doubles, whether they intersect, integers
// and exact numbers decide, in this order.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_bound.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_hulls_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/exact_hull_distance.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
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

// Returns the exact radius of an object: zero, unless it is thickened.
template <class Exact, class Object>
Exact exact_radius(const Object& object)
{
  if constexpr(Is_thickened<Object>::value)
    return to_exact<Exact>(object.second);
  else
    return Exact(0);
}

template <class Object>
using Hull_vector = typename Hull_distance<hull_dimension_v<Object>>::Vector;

// The vertices of a hull in exact numbers, or those of them that may be nearest to another hull.
template <class Exact, int Dimension>
using Exact_vertices = std::vector<Exact_vector<Exact, static_cast<std::size_t>(Dimension)>>;

// Whether hulls that are apart are within a bound: their vertices, and the sum of their radii.
template <int Dimension, class Exact>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
bool are_vertices_near(const Exact_vertices<Exact, Dimension>& a,
                       const Exact_vertices<Exact, Dimension>& b, const Exact& radii,
                       const Squared_bound<Exact>& bound)
{
  const auto within = [&](const Exact& n, const Exact& d) { return bound.holds_for(n, d, radii); };
  return Exact_hull_distance<Exact, Dimension, decltype(within)>(within)(a, b);
}

// Whether hulls that are exact, and apart, are within a bound. Integers of 128 bits tell, unless
// they have too few bits, or `least_tier` is that of exact numbers. Then `tier` becomes this.
template <int Dimension, class Exact>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
bool are_exact_hulls_near(const Hull<Dimension>& a, const Hull<Dimension>& b,
                          const Hull_distance<Dimension>& distance, const Hull_bound& bound,
                          const Squared_bound<Exact>& exact_bound, Arithmetic_tier least_tier,
                          Arithmetic_tier& tier)
{
  const auto nearest_a = distance.nearest_of(0, [&](std::size_t k) { return a.vertices[k]; });
  const auto nearest_b = distance.nearest_of(1, [&](std::size_t k) { return b.vertices[k]; });
  if(bound.is_exact_radius && least_tier != Arithmetic_tier::FILTERED_EXACT) {
    Integer_hulls<Dimension> hulls(nearest_a, nearest_b, a.radius.low, b.radius.low,
                                   bound.radius.low);
    if(const std::optional<bool> are_near = hulls.are_near(bound.is_open))
      return *are_near;
  }
  tier = Arithmetic_tier::FILTERED_EXACT;
  const auto exact = [](const std::vector<std::array<double, Dimension>>& vertices) {
    Exact_vertices<Exact, Dimension> result(vertices.size());
    for(std::size_t k = 0; k < vertices.size(); ++k)
      for(int axis = 0; axis < Dimension; ++axis)
        result[k][axis] = Exact(vertices[k][axis]);
    return result;
  };
  return are_vertices_near<Dimension>(exact(nearest_a), exact(nearest_b),
                                      Exact(Exact(a.radius.low) + Exact(b.radius.low)),
                                      exact_bound);
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template class Hull_distance<2>;
extern template class Hull_distance<3>;
extern template bool are_exact_hulls_near<2>(
  const Hull<2>&, const Hull<2>&, const Hull_distance<2>&, const Hull_bound&,
  const Squared_bound<Exact_number_t<double>>&, Arithmetic_tier, Arithmetic_tier&);
extern template bool are_exact_hulls_near<3>(
  const Hull<3>&, const Hull<3>&, const Hull_distance<3>&, const Hull_bound&,
  const Squared_bound<Exact_number_t<double>>&, Arithmetic_tier, Arithmetic_tier&);
#endif

// Whether objects of one kind each are made of doubles, by their types.
template <class A, class B>
constexpr bool are_doubles_v = has_double_vertices_v<Hull_points_t<A>>
                               && has_double_vertices_v<Hull_points_t<B>>
                               && is_held_by_double_v<typename Radius_number<A>::type>
                               && is_held_by_double_v<typename Radius_number<B>::type>;

// The same of objects by the numbers that they have.
template <class A, class B, class Exact>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
bool are_near_in_their_numbers(const A& a, const B& b,
                               const Hull_distance<hull_dimension_v<A>>& distance,
                               const Squared_bound<Exact>& bound)
{
  return are_vertices_near<hull_dimension_v<A>>(
    distance.nearest_of(0, [&](std::size_t k) { return exact_hull_vertex<Exact>(a, k); }),
    distance.nearest_of(1, [&](std::size_t k) { return exact_hull_vertex<Exact>(b, k); }),
    Exact(exact_radius<Exact>(a) + exact_radius<Exact>(b)), bound);
}

// Returns doubles that enclose the bound on the distance of the hulls of two objects.
template <class A, class B>
Interval reach_of_objects(const Hull_bound& bound, const A& a, const B& b)
{
  if constexpr(Is_thickened<A>::value || Is_thickened<B>::value)
    return reach_of_hulls(bound, hull_radius(a), hull_radius(b));
  else
    return bound.radius;
}

// The question that the first guesses leave undecided. `v` is the last of them. Objects that
// intersect are within every bound.
template <class A, class B, class Exact_bound>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool
decide_near_objects(const A& a, const B& b, const Hull_vector<A>& v, const Hull_bound& bound,
                    const Exact_bound& exact_bound, Arithmetic_tier& tier)
{
  constexpr int dimension = hull_dimension_v<A>;
  const Hull<dimension> hull_a = hull_of(a), hull_b = hull_of(b);
  Hull_distance<dimension> distance(hull_a, hull_b, v);
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
  if constexpr(!are_doubles_v<A, B>)
    if(!hull_a.is_exact() || !hull_b.is_exact()) {
      tier = Arithmetic_tier::FILTERED_EXACT;
      return are_near_in_their_numbers(a, b, distance, exact_bound());
    }
  return are_exact_hulls_near(hull_a, hull_b, distance, bound, exact_bound(), least_tier, tier);
}

// Whether objects of one kind each are within a bound, which holds for the distance zero at least.
// `exact_bound` returns it for exact numbers. `tier` is the first arithmetic after the filter, and
// becomes the one that was needed.
template <class A, class B, class Exact_bound>
bool are_kinds_near(const A& a, const B& b, const Hull_bound& bound, const Exact_bound& exact_bound,
                    Arithmetic_tier& tier)
{
  Hull_vector<A> v;
  const Uncertain<bool> are_near = are_hulls_near<hull_size_v<A>, hull_size_v<B>>(
    hull_of(a), hull_of(b), reach_of_objects(bound, a, b), v);
  if(!is_certain(are_near))
    return decide_near_objects(a, b, v, bound, exact_bound, tier);
  tier = Arithmetic_tier::DOUBLE;
  return get_certain(are_near);
}

// Whether two objects of kinds that the package knows are within a bound.
template <class Object>
class Are_objects_near
{
  using Exact = Common_exact_number_t<Object>;

public:
  static constexpr int static_dimension = hull_dimension_v<typename Kinds<Object>::First>;

  // `least_tier` is the first arithmetic after the filter. Counts in `counts` which arithmetic
  // decides, unless `counts` is null.
  template <class NT>
  Are_objects_near(const Distance_bound<NT>& bound, Arithmetic_tier least_tier,
                   Shared_decision_counts* counts)
    : bound_(bound), least_tier_(least_tier), counts_(counts)
  {
    set_hull_bound(hull_bound_, bound, bound_);
  }

  int dimension() const { return static_dimension; }
  double reach() const { return bound_.reach(); }

  static std::pair<double, double> interval(const Object& object, int axis)
  {
    const auto& box = internal::bounding_box(object);
    return {(box.min)(axis), (box.max)(axis)};
  }

  bool operator()(const Object& a, const Object& b) const
  {
    if(bound_.is_open() && bound_.is_zero()) // no distance is less than zero
      return false;
    return with_kinds(a, b, [&](const auto& x, const auto& y) {
      Arithmetic_tier tier = least_tier_;
      const auto exact_bound = [&]() -> const Squared_bound<Exact>& { return bound_; };
      const bool are_near = are_kinds_near(x, y, hull_bound_, exact_bound, tier);
      if(counts_ != nullptr)
        counts_->add(tier);
      return are_near;
    });
  }

private:
  const Squared_bound<Exact> bound_;
  Hull_bound hull_bound_;
  const Arithmetic_tier least_tier_;
  Shared_decision_counts* counts_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ARE_OBJECTS_NEAR_H
