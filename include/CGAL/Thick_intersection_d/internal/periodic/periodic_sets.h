// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SETS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SETS_H

// What all functions for periodic domains do with their arguments: check their types and number the
// points.

#include <CGAL/Dimension.h>
#include <CGAL/Periodic_lattice_d.h>

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The dimension of a domain, or 0 if it is none.
template <class Domain, class = void>
inline constexpr int domain_dimension_v = 0;
template <class Vector>
inline constexpr int domain_dimension_v<Periodic_lattice_d<Vector>>
  = Periodic_lattice_d<Vector>::dimension;
template <class Iso_box>
inline constexpr int domain_dimension_v<
  Iso_box, std::void_t<decltype(std::declval<const Iso_box&>().min_coord(0))>>
  = Ambient_dimension<Iso_box>::type::value;

template <class Domain, class... Elements>
constexpr bool check_domain()
{
  constexpr bool fits
    = ((dimension_or<typename Elements::value_type>(0) != 0
        && dimension_or<typename Elements::value_type>(0) == domain_dimension_v<Domain>) && ...);
  static_assert(fits, "The domain must be an Iso_rectangle_2 for points in the plane, an "
                      "Iso_cuboid_3 in space, or a Periodic_lattice_d of this dimension.");
  return fits;
}

// Returns search(elements, sets) for the points of one range, or of two. Explains to the compiler's
// user what cannot be searched, and returns nothing of use then.
template <class Domain, class NamedParameters, class Search, class... Ranges>
auto with_periodic_sets(const NamedParameters& np, const Search& search, Ranges&... ranges)
{
  if constexpr(!(check_range_of_points<Ranges, NamedParameters>() && ...))
    return false;
  else if constexpr(!check_domain<Domain, Elements_of<Ranges, NamedParameters>...>())
    return false;
  else
    return with_sets(search, make_elements(ranges, np)...);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODIC_SETS_H
