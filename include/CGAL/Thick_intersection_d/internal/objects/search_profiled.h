// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_SEARCH_PROFILED_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_SEARCH_PROFILED_H

// A search that describes its scene, and counts which arithmetic decides.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>

#include <algorithm>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns search(least_tier, &counts), and sets `profile` to `found`, the profile of the scene,
// with the tier that is forced in `profile`, and the counts.
//
// The least tier is the first arithmetic after the filter. What the whole scene needs is more than
// most of its pairs do, so wider integers and exact numbers wait for these.
template <class Search>
bool search_profiled(Scene_profile& profile, Scene_profile found, const Search& search)
{
  if(const std::optional<Arithmetic_tier> forced = profile.forced_tier())
    found.force_tier(*forced);
  Shared_decision_counts counts;
  const bool is_complete
    = search(found.forced_tier() ? found.tier()
                                 : (std::min)(found.tier(), Arithmetic_tier::INT64), &counts);
  found.set_counts(counts.total());
  profile = found;
  return is_complete;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_SEARCH_PROFILED_H
