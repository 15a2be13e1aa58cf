// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_JOINED_PROFILE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_JOINED_PROFILE_H

// The profile of a search of points that are searched in two parts.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Adds the decisions of one profile to those of another one.
inline void add_decisions(const Scene_profile& profile, Scene_profile& sum)
{
  Decision_counts counts;
  for(std::size_t tier = 0; tier < arithmetic_tier_count; ++tier)
    for(const Scene_profile* part : {&profile, static_cast<const Scene_profile*>(&sum)})
      counts.add(static_cast<Arithmetic_tier>(tier),
                 part->decided(static_cast<Arithmetic_tier>(tier)));
  sum.set_counts(counts);
}

// Returns the profile of `size` points, from those of the points and of their images elsewhere.
inline Scene_profile joined_profile(std::size_t size, int dimension, double reach,
                                    const Scene_profile& points, const Scene_profile& images)
{
  std::vector<std::pair<double, double>> box;
  for(int axis = 0; axis < dimension; ++axis)
    box.emplace_back((std::min)(points.range(axis).first, images.range(axis).first),
                     (std::max)(points.range(axis).second, images.range(axis).second));
  std::optional<int> grid_exponent;
  if(points.has_grid() && images.has_grid())
    grid_exponent = (std::min)(points.grid_exponent(), images.grid_exponent());
  Scene_profile profile(size, box, reach, grid_exponent);
  if(points.forced_tier())
    profile.force_tier(*points.forced_tier());
  for(const Scene_profile* part : {&points, &images})
    add_decisions(*part, profile);
  profile.set_coordinates(points.coordinate_bits(), points.are_coordinates_rounded());
  return profile;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_JOINED_PROFILE_H
