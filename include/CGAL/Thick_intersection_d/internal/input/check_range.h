// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_CHECK_RANGE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_CHECK_RANGE_H

// Checks the types of the user's ranges, when a program is compiled. A mistake gives one sentence:
// a function that checks returns false as well, and then its caller compiles nothing else.

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>

#include <type_traits>
#include <utility>

namespace CGAL {

template <class NT>
class Distance_bound;

namespace Thick_intersection_d {
namespace internal {

template <class T>
inline constexpr bool are_named_parameters_v = false;
template <class T, class Tag, class Base>
inline constexpr bool are_named_parameters_v<Named_function_parameters<T, Tag, Base>> = true;

// Checks the named parameters that all functions take.
template <class NamedParameters>
constexpr bool check_named_parameters()
{
  if constexpr(!are_named_parameters_v<NamedParameters>) {
    static_assert(are_named_parameters_v<NamedParameters>,
                  "The last argument must be made of named parameters: pass traits by "
                  "CGAL::parameters::geom_traits(traits).");
    return false;
  }
  else if constexpr(parameters::is_default_parameter<NamedParameters,
                                                     internal_np::callback_t>::value)
    return true;
  else {
    using Functor = std::decay_t<decltype(parameters::get_parameter(
      std::declval<const NamedParameters&>(), internal_np::callback))>;
    constexpr bool tells = std::is_invocable_r_v<bool, Functor&, double>;
    static_assert(tells, "The progress functor that is given as callback must take a double, and "
                         "return bool to tell whether the search goes on.");
    return tells;
  }
}

// The map of the named parameters, which may not fit the range.
template <class Map, class Element, class = void>
struct Maps_element : std::is_same<Map, No_map> {};
template <class Map, class Element>
struct Maps_element<Map, Element,
                    std::void_t<std::enable_if_t<!std::is_same_v<Map, No_map>>,
                                decltype(get(std::declval<const Map&>(), std::declval<Element>()))>>
  : std::true_type {};

// Refuses the map of another kind of input, which no function of ranges reads.
template <class NamedParameters>
constexpr bool check_map_of_range()
{
  constexpr bool has_no_other
    = parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value;
  static_assert(has_no_other, "vertex_point_map is for meshes: pass the map as point_map.");
  return has_no_other;
}

// For functions that take interiors() in the place of a range.
inline constexpr bool takes_interiors = true;

// `Range` is const if the range is.
template <class Range, class NamedParameters, bool Takes_interiors = false>
constexpr bool check_range()
{
  constexpr bool may_be_open = Takes_interiors || !are_interiors_v<std::remove_const_t<Range>>;
  static_assert(may_be_open,
                "This function does not take interiors(). Two interiors are within a distance iff "
                "the closed objects are closer: pass the ranges, and bound.open().");
  if constexpr(!check_named_parameters<NamedParameters>() || !may_be_open)
    return false;
  else if constexpr(!check_map_of_range<NamedParameters>())
    return false;
  else if constexpr(!Is_range<Range>::value) {
    static_assert(Is_range<Range>::value, "The argument must be a range with forward iterators.");
    return false;
  }
  else {
    using Map
      = decltype(element_map(std::declval<Range&>(), std::declval<const NamedParameters&>()));
    using Element = Reference_of<Iterator_of<Read_range<Range>>>;
    static_assert(Maps_element<Map, Element>::value,
                  "The property map point_map must take the elements of the range.");
    return Maps_element<Map, Element>::value;
  }
}

template <class NamedParameters>
using Given_traits = std::decay_t<decltype(parameters::get_parameter_reference(
  std::declval<const NamedParameters&>(), internal_np::geom_traits))>;

// The kernel of an object, or of what is thickened.
template <class Kind, bool = Is_thickened<Kind>::value>
struct Kernel_of_kind
{
  using type = typename Kernel_traits<Kind>::Kernel;
};
template <class Thickened>
struct Kernel_of_kind<Thickened, true>
{
  using type = typename Kernel_traits<Hull_points_t<Thickened>>::Kernel;
};

// Whether traits are given that know something else than the type of the objects does: any but the
// kernel of the objects, which other functions of CGAL take as geom_traits.
template <class Object, class NamedParameters>
inline constexpr bool has_traits_v
  = !parameters::is_default_parameter<NamedParameters, internal_np::geom_traits_t>::value
    && !std::is_same_v<Given_traits<NamedParameters>,
                       typename Kernel_of_kind<typename Kinds<Object>::First>::type>;

// Refuses pairs that are thickened to nobody who has read examples of CGAL.
template <class Object>
constexpr bool check_no_index()
{
  constexpr bool has_index = Kinds<Object>::template is_any<Is_object_with_index>;
  static_assert(!has_index, "A pair of an object and an integer may be an object with an index: "
                            "pass a property map to the objects as point_map, or make the integer "
                            "a number of the kernel if it is a radius.");
  return !has_index;
}

// Refuses traits where distances are those of the kernel.
template <class Point, class NamedParameters>
constexpr bool check_no_traits()
{
  constexpr bool has_traits = has_traits_v<Point, NamedParameters>;
  static_assert(!has_traits, "geom_traits must be the kernel of the points, if it is given: this "
                             "function asks no other traits.");
  return !has_traits;
}

template <class Elements, class NamedParameters>
constexpr bool check_points()
{
  using Point = typename Elements::value_type;
  constexpr bool has_weight = Is_weighted_point<Point>::value;
  constexpr bool is_point = Is_point<Point>::value || has_weight;
  static_assert(!has_weight, "Weighted points have no distance here: pass a point_map to their "
                             "points, or make them balls: pairs of a center and a radius.");
  static_assert(is_point, "The elements of the range must be points of a kernel of CGAL: pass a "
                          "property map to such points as point_map.");
  if constexpr(is_point && !has_weight)
    return check_no_traits<Point, NamedParameters>();
  else
    return false;
}

template <class Range, class NamedParameters>
constexpr bool check_range_of_points()
{
  if constexpr(!check_range<Range, NamedParameters>())
    return false;
  else
    return check_points<Elements_of<Range, NamedParameters>, NamedParameters>();
}

template <class T>
inline constexpr bool is_bound_v = false;

template <class NT>
inline constexpr bool is_bound_v<Distance_bound<NT>> = true;

// Whether one of the arguments is a bare number, and none is a bound.
template <class... Arguments>
inline constexpr bool has_bare_number_v
  = (is_number_v<Arguments> || ...) && !(is_bound_v<Arguments> || ...);

// Refuses a bare number as a bound.
template <class... Arguments>
constexpr bool check_bound()
{
  static_assert(!has_bare_number_v<Arguments...>, "The bound must be within_distance(r) or "
                "within_squared_distance(r2), not a bare number.");
  return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_CHECK_RANGE_H
