// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_NEAR_OBJECTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_NEAR_OBJECTS_SEARCH_H

// Near pairs of objects that are no points, or of two types: by boxes that are longer by the reach.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_objects.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/objects/Object_route.h>
#include <CGAL/Thick_intersection_d/internal/objects/segment_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_objects_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether two objects of traits are within a bound, by the functors of the traits.
template <class Object, class Traits, class NT>
class Are_near_by_traits
{
public:
  static constexpr int static_dimension = Object_dimension<Traits>::value;

  Are_near_by_traits(const Traits& traits, const Distance_bound<NT>& bound)
    : traits_(traits), bound_(bound), reach_(Squared_bound<Exact_number_t<NT>>(bound).reach())
  {}

  int dimension() const { return traits_.dimension(); }
  double reach() const { return reach_; }

  std::pair<double, double> interval(const Object& object, int axis) const
  {
    return of_range(object, [&](const auto& x) -> std::pair<double, double> {
      return traits_.interval_d_object()(x, axis);
    });
  }

  bool operator()(const Object& a, const Object& b) const
  {
    return of_ranges(a, b, [&](const auto& x, const auto& y) -> bool {
      return traits_.is_within_distance_d_object()(x, y, bound_);
    });
  }

private:
  const Traits& traits_;
  const Distance_bound<NT>& bound_;
  double reach_;
};

// Whether traits have intervals of objects of two types, and tell if two are within a bound.
template <class Traits, class A, class B, class NT, class = void>
struct Has_distances : std::false_type {};
template <class Traits, class A, class B, class NT>
struct Has_distances<
  Traits, A, B, NT,
  std::enable_if_t<
    std::is_invocable_r_v<std::pair<double, double>,
                          decltype(std::declval<const Traits&>().interval_d_object()), const A&,
                          int>
    && std::is_invocable_r_v<std::pair<double, double>,
                             decltype(std::declval<const Traits&>().interval_d_object()), const B&,
                             int>
    && std::is_invocable_r_v<bool,
                             decltype(std::declval<const Traits&>().is_within_distance_d_object()),
                             const A&, const B&, const Distance_bound<NT>&>>>
  : std::true_type {};
template <class Traits, class A, class B, class NT>
struct Has_distances<Traits, One_of_two<A, B>, One_of_two<A, B>, NT>
  : Has_distances<Traits, std::decay_t<A>, std::decay_t<B>, NT> {};

// Checks the objects of a search for near ones without traits.
template <class Object>
constexpr bool check_known_objects()
{
  constexpr bool has_weight = Kinds<Object>::template is_any<Is_weighted_point>;
  constexpr bool has_no_index = check_no_index<Object>();
  constexpr bool are_known = Kinds<Object>::template are_all<Is_known_kind>;
  static_assert(!has_weight, "Weighted points have no distance here: pass a point_map to their "
                             "points, or make them balls: pairs of a center and a radius.");
  static_assert(are_known || !has_no_index || has_weight,
                "The elements of the range must be points or objects of a kernel of CGAL: pass a "
                "property map to such elements as point_map, or a model of ThickDistanceTraits_d "
                "as geom_traits.");
  if constexpr(are_known && !has_weight)
    return check_one_dimension<Object>();
  else
    return false;
}

// Checks the objects of a search for near ones, and the traits of the named parameters. With a
// profile, no traits are taken: what coordinates other objects have is not known. Returns whether
// the search can be compiled.
template <class Object, class NT, class NamedParameters, bool Has_profile>
constexpr bool check_near_objects()
{
  if constexpr(!has_traits_v<Object, NamedParameters>)
    return check_known_objects<Object>();
  else if constexpr(Has_profile) {
    static_assert(!Has_profile,
                  "A Scene_profile is for points and objects of a kernel, without geom_traits.");
    return false;
  }
  else {
    constexpr bool is_model = Has_distances<Given_traits<NamedParameters>, Object, Object,
                                            NT>::value;
    static_assert(is_model, "geom_traits must be a model of ThickDistanceTraits_d whose functors "
                            "take the elements of the range and the bound, or the kernel of "
                            "points.");
    return is_model;
  }
}

// Checks the objects, and makes their lazy coordinates final.
template <class Elements>
void check_near_kinds(const Elements& objects, const Threads& threads)
{
  check_denormals();
  threads.check_each(objects.size(), [&](std::size_t position) {
    settle(objects[position]);
    check_object(objects[position], position);
  });
}

template <class Elements, class Sets, class Test, class Callback, class NamedParameters>
bool report_near_boxes(const Elements& objects, const Sets& sets, const Test& test,
                       Callback& callback, const NamedParameters& np, const Threads& threads)
{
  using Object = typename Elements::value_type;
  // Traits may have another distance, for which stretches need other boxes.
  constexpr bool are_kinds_known = std::is_same_v<Test, Are_objects_near<Object>>;
  auto progress = make_progress(np, objects.size());
  const Near_object_boxes<Test::static_dimension, Elements, Test> boxes(objects, test);
  if constexpr(Sets::are_two && are_kinds_known && Has_segments<Object>::value)
    return report_segment_pairs(boxes, objects, sets, callback, progress, threads);
  else
    return report_meeting_boxes(boxes, sets, callback, progress, threads);
}

// Reports the near pairs of objects that the package knows. Takes the tier that is forced in a
// profile, and sets it to the profile of the scene, if there is one behind the threads.
template <class Elements, class Sets, class NT, class Callback, class NamedParameters,
          class... Profile>
bool report_near_kinds(const Elements& objects, const Sets& sets, const Distance_bound<NT>& bound,
                       Callback& callback, const NamedParameters& np, const Threads& threads,
                       Profile&... profile)
{
  using Object = typename Elements::value_type;
  check_near_kinds(objects, threads);
  const auto search = [&](Arithmetic_tier least_tier, Shared_decision_counts* counts) {
    const Are_objects_near<Object> test(bound, least_tier, counts);
    return report_near_boxes(objects, sets, test, callback, np, threads);
  };
  if constexpr(sizeof...(Profile) == 0)
    return search(Arithmetic_tier::INT64, nullptr);
  else {
    const double reach = Squared_bound<Common_exact_number_t<Object>>(bound).reach();
    Object_scene scene = scan_objects(objects);
    add_bound(scene, bounds(bound.value()), reach);
    return search_profiled(profile..., {scene, degree_of<Distance_degree, Object>()}, search);
  }
}

template <class Object>
struct Near_pairs_of<Object, false>
{
  // Reports the near pairs of objects. Returns false iff the search was stopped.
  template <class Elements, class Sets, class NT, class Callback, class NamedParameters,
            class... Profile>
  static bool report(const Elements& objects, const Sets& sets, const Distance_bound<NT>& bound,
                     Callback& callback, const NamedParameters& np, const Threads& threads,
                     Profile&... profile)
  {
    constexpr bool has_profile = sizeof...(Profile) != 0;
    if constexpr(!check_near_objects<Object, NT, NamedParameters, has_profile>())
      return false;
    else if constexpr(has_traits_v<Object, NamedParameters>) {
      const auto& traits = parameters::get_parameter_reference(np, internal_np::geom_traits);
      const Are_near_by_traits<Object, Given_traits<NamedParameters>, NT> test(traits, bound);
      check_denormals();
      check_objects(objects, traits, threads);
      return report_near_boxes(objects, sets, test, callback, np, threads);
    }
    else
      return report_near_kinds(objects, sets, bound, callback, np, threads, profile...);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_NEAR_OBJECTS_SEARCH_H
