// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_OBJECT_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_OBJECT_PAIRS_SEARCH_H

// The searches behind thick_self_intersection_d() and thick_intersection_d(). A mistake in their
// arguments gives one sentence when a program is compiled.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_object_traits_d.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_objects.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/objects/Object_route.h>
#include <CGAL/Thick_intersection_d/internal/objects/Traits_of_interiors.h>
#include <CGAL/Thick_intersection_d/internal/objects/Two_type_traits.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Object, class = void>
struct Has_bounding_box
  : std::bool_constant<std::is_same_v<Object, Bbox_2> || std::is_same_v<Object, Bbox_3>>
{};
template <class Object>
struct Has_bounding_box<Object, std::void_t<decltype(std::declval<const Object&>().bbox())>>
  : std::true_type {};

// Whether a search without traits takes objects of a kind, perhaps with those of another one.
template <class Kind>
struct Is_kind : std::bool_constant<Has_bounding_box<Kind>::value || Is_thickened<Kind>::value>
{};

// Whether there is a test of an object of A and one of B in the namespace of their classes.
template <class A, class B, class = void>
struct Have_own_test : std::false_type {};
template <class A, class B>
struct Have_own_test<A, B,
                     std::void_t<decltype(do_intersect(std::declval<const A&>(),
                                                       std::declval<const B&>()))>>
  : std::true_type {};

// Whether the package has a test of objects of a type, or says more about why it has none.
template <class Object>
inline constexpr bool is_answered_v
  = Is_known_kind<Base_kind_t<Object>>::value || Is_hypersphere<Base_kind_t<Object>>::value;

// Whether two objects of a range, or of two, can be tested. Variants are not asked.
template <class A, class B = A>
constexpr bool have_test()
{
  if constexpr(Is_one_of_two<A>::value)
    return have_test<typename A::First, typename A::Second>();
  else
    return Is_variant<A>::value || Is_variant<B>::value || (is_answered_v<A> && is_answered_v<B>)
           || Have_own_test<A, B>::value;
}

// Checks the objects of a search without traits.
template <class Object>
constexpr bool check_kernel_objects()
{
  constexpr bool has_weight = Kinds<Object>::template is_any<Is_weighted_point>;
  constexpr bool has_no_index = check_no_index<Object>();
  constexpr bool have_boxes = Kinds<Object>::template are_all<Is_kind>;
  constexpr bool are_kinds = have_boxes && have_test<Object>();
  static_assert(!has_weight,
                "A weighted point is no ball: make it a pair of a center and a radius.");
  static_assert(are_kinds || !has_no_index || has_weight,
                "The elements of the range must be objects with bbox() and do_intersect(): pass "
                "a property map to such objects as point_map, or traits as geom_traits.");
  if constexpr(are_kinds && !has_weight)
    return check_one_dimension<Object>();
  else
    return false;
}

struct No_objects {};

// The objects of traits with an intersection test.
template <class Traits, class = void>
struct Object_of_traits
{
  using type = No_objects;
};
template <class Traits>
struct Object_of_traits<
  Traits, std::void_t<decltype(std::declval<const Traits&>().do_intersect_d_object()),
                      typename Traits::Object_d>>
{
  using type = typename Traits::Object_d;
};

// Whether traits have intervals of two types, and an intersection test of both.
template <class Traits, class A, class B, class = void>
struct Takes_two_types : std::false_type {};
template <class Traits, class A, class B>
struct Takes_two_types<
  Traits, A, B,
  std::enable_if_t<
    std::is_invocable_v<decltype(std::declval<const Traits&>().interval_d_object()), const A&, int>
    && std::is_invocable_v<decltype(std::declval<const Traits&>().interval_d_object()), const B&,
                           int>
    && std::is_invocable_v<decltype(std::declval<const Traits&>().do_intersect_d_object()),
                           const A&, const B&>>>
  : std::true_type {};

template <class Traits, class Object>
constexpr bool check_traits_of_two_types()
{
  constexpr bool takes_two
    = Takes_two_types<Traits, typename Object::First, typename Object::Second>::value;
  static_assert(takes_two, "The ranges hold objects of two types: geom_traits must have intervals "
                           "of both, and do_intersect_d_object() must take one of each.");
  return takes_two;
}

// Whether the functors of traits take their objects.
template <class Traits, class Object>
constexpr bool do_functors_take_objects()
{
  using Do_intersect
    = std::decay_t<decltype(std::declval<const Traits&>().do_intersect_d_object())>;
  if constexpr(!std::is_invocable_r_v<bool, const Do_intersect&, const Object&, const Object&>)
    return false;
  else if constexpr(Has_intervals<Traits>::value)
    return std::is_invocable_r_v<
      std::pair<double, double>,
      const std::decay_t<decltype(std::declval<const Traits&>().interval_d_object())>&,
      const Object&, int>;
  else
    return std::is_invocable_r_v<
      bool,
      const std::decay_t<decltype(std::declval<const Traits&>().is_close_along_axis_d_object())>&,
      const Object&, const Object&, int>;
}

template <class Traits, class = void>
struct Has_dimension : std::false_type {};
template <class Traits>
struct Has_dimension<Traits, std::void_t<decltype(std::declval<const Traits&>().dimension())>>
  : std::is_convertible<decltype(std::declval<const Traits&>().dimension()), int> {};

template <class Traits, class Object>
constexpr bool check_traits()
{
  using Object_d = typename Object_of_traits<Traits>::type;
  constexpr bool is_model = !std::is_same_v<Object_d, No_objects> && Has_dimension<Traits>::value
                            && (Has_intervals<Traits>::value || Has_close_predicate<Traits>::value);
  static_assert(is_model, "geom_traits must be a model of ThickIntersectionIntervalTraits_d or of "
                          "ThickIntersectionTraits_d.");
  if constexpr(is_model) {
    constexpr bool is_whole = do_functors_take_objects<Traits, Object_d>();
    constexpr bool takes_objects = std::is_convertible_v<const Object&, const Object_d&>;
    static_assert(is_whole, "The functors of geom_traits must take its type Object_d, as constant "
                            "functors.");
    static_assert(takes_objects || !is_whole,
                  "The elements of the range must be of the type Object_d of geom_traits: pass "
                  "a property map to such objects as point_map.");
    return is_whole && takes_objects;
  }
  else
    return false;
}

// Checks the traits of the named parameters. Without any, checks that the default traits will do.
template <class Object, class NamedParameters>
constexpr bool check_objects_and_traits()
{
  if constexpr(parameters::is_default_parameter<NamedParameters,
                                                internal_np::geom_traits_t>::value)
    return check_kernel_objects<Object>();
  else {
    using Traits = decltype(parameters::get_parameter_reference(
      std::declval<const NamedParameters&>(), internal_np::geom_traits));
    if constexpr(Is_one_of_two<Object>::value)
      return check_traits_of_two_types<std::decay_t<Traits>, Object>();
    else
      return check_traits<std::decay_t<Traits>, Object>();
  }
}

// Checks the objects of a search with a profile. The coordinates of other objects are not known.
template <class Object, class NamedParameters>
constexpr bool check_profiled_objects()
{
  constexpr bool is_known = are_tests_known_v<Object>;
  constexpr bool has_traits
    = !parameters::is_default_parameter<NamedParameters, internal_np::geom_traits_t>::value;
  static_assert(is_known && !has_traits,
                "A Scene_profile is for objects of a kernel or boxes, without geom_traits.");
  if constexpr(is_known && !has_traits)
    return check_one_dimension<Object>();
  else
    return false;
}

// Returns the traits given as `geom_traits`. Otherwise makes the traits for kernel objects, without
// the extents of the objects, which only the recursive route needs.
template <class Elements, class NamedParameters>
decltype(auto) object_traits([[maybe_unused]] const NamedParameters& np)
{
  using Object = typename Elements::value_type;
  if constexpr(!parameters::is_default_parameter<NamedParameters,
                                                 internal_np::geom_traits_t>::value) {
    if constexpr(Is_one_of_two<Object>::value) {
      const auto& traits = parameters::get_parameter_reference(np, internal_np::geom_traits);
      return Two_type_traits<std::decay_t<decltype(traits)>, Object>(traits);
    }
    else
      return parameters::get_parameter_reference(np, internal_np::geom_traits);
  }
  else
    return Default_traits<Elements>();
}

// Checks the objects, and reports the pairs. Returns false iff the search was stopped.
template <class Elements, class Sets, class Callback, class NamedParameters>
bool report_object_pairs(const Elements& objects, const Sets& sets, Callback& callback,
                         const NamedParameters& np, const Threads& threads)
{
  using Object = typename Elements::value_type;
  if constexpr(!check_open_objects<Elements, NamedParameters>())
    return false;
  else if constexpr(check_objects_and_traits<Object, NamedParameters>()) {
    check_denormals();
    const auto& traits = object_traits<Elements>(np);
    using Route = Object_route<std::decay_t<decltype(traits)>>;
    return Route::report(objects, sets, traits, callback, np, threads);
  }
  else
    return false;
}

// The same, with the tier that is forced in `profile`. Sets `profile` to the profile of the scene.
template <class Elements, class Sets, class Callback, class NamedParameters>
bool report_object_pairs(const Elements& objects, const Sets& sets, Callback& callback,
                         Scene_profile& profile, const NamedParameters& np, const Threads& threads)
{
  using Object = typename Elements::value_type;
  if constexpr(!check_open_objects<Elements, NamedParameters>())
    return false;
  else if constexpr(check_profiled_objects<Object, NamedParameters>()) {
    check_denormals();
    Default_traits<Elements> traits;
    check_objects(objects, traits, threads);
    Object_scene scene = scan_objects(objects);
    scene.has_distances = Kinds<Object>::template is_any<Is_thickened>;
    const auto search = [&](Arithmetic_tier least_tier, Shared_decision_counts* counts) {
      traits.decide_by(least_tier, *counts);
      return report_objects(objects, sets, traits, callback, np, threads);
    };
    return search_profiled(profile, {scene, degree_of<Intersection_degree, Object>()}, search);
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_OBJECT_PAIRS_SEARCH_H
