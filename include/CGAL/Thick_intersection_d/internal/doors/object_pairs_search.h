// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_PAIRS_SEARCH_H

// The searches behind thick_self_intersection_d() and thick_intersection_d().

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_object_traits_d.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/doors/Object_route.h>
#include <CGAL/Thick_intersection_d/internal/doors/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/doors/check_traits.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <algorithm>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the traits given as `geom_traits`. Otherwise makes the traits for kernel objects. Only
// the recursive route needs the extents of objects, which take a pass over them.
template <class Elements, class NamedParameters>
decltype(auto) object_traits(const Elements& objects, const NamedParameters& np)
{
  if constexpr(!parameters::is_default_parameter<NamedParameters,
                                                 internal_np::geom_traits_t>::value)
    return parameters::get_parameter_reference(np, internal_np::geom_traits);
  else {
    using Traits = Thick_object_traits_d<typename Elements::value_type>;
    return fits_box_route(objects.size()) ? Traits() : Traits(objects);
  }
}

// Checks the objects, and reports the pairs. Returns false iff the search was stopped.
template <class ConcurrencyTag, class Elements, class Sets, class Callback, class NamedParameters>
bool report_object_pairs(const Elements& objects, const Sets& sets, Callback& callback,
                         const NamedParameters& np)
{
  if constexpr(check_objects_and_traits<typename Elements::value_type, NamedParameters>()) {
    check_denormals();
    const auto& traits = object_traits(objects, np);
    using Route = Object_route<std::decay_t<decltype(traits)>>;
    return Route::template report<ConcurrencyTag>(objects, sets, traits, callback, np);
  }
  else
    return false;
}

// Returns the first arithmetic after the filter. What the whole scene needs is more than most of
// its determinants do, so wider integers and exact numbers wait for these.
inline Arithmetic_tier least_tier_of(const Scene_profile& profile)
{
  return profile.forced_tier() ? profile.tier()
                               : (std::min)(profile.tier(), Arithmetic_tier::INT64);
}

// The same, with the tier that is forced in `profile`. Sets `profile` to the profile of the scene.
template <class ConcurrencyTag, class Elements, class Sets, class Callback, class NamedParameters>
bool report_object_pairs(const Elements& objects, const Sets& sets, Callback& callback,
                         Scene_profile& profile, const NamedParameters& np)
{
  using Object = typename Elements::value_type;
  if constexpr(check_profiled_objects<Object, NamedParameters>()) {
    check_denormals();
    Thick_object_traits_d<Object> traits = object_traits(objects, np);
    check_objects<ConcurrencyTag>(objects, traits);
    Scene_profile found(scan_objects(objects), test_degree<Object>());
    if(const std::optional<Arithmetic_tier> forced = profile.forced_tier())
      found.force_tier(*forced);
    Shared_decision_counts counts;
    traits.decide_by(least_tier_of(found), counts);
    const bool is_complete = report_objects<ConcurrencyTag>(objects, sets, traits, callback, np);
    found.set_counts(counts.total());
    profile = found;
    return is_complete;
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_OBJECT_PAIRS_SEARCH_H
