// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CHECK_FEATURE_TYPES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CHECK_FEATURE_TYPES_H

// Checks the types of the features of a search, when a program is compiled.

#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements>
using Piece_of_features = Feature_piece_t<typename Elements::value_type>;
template <class Elements>
using Radius_of_features = Feature_radius_t<typename Elements::value_type>;

// Checks the features of one range, or of two.
template <class First, class Second, class NamedParameters>
constexpr bool check_features()
{
  using A = Piece_of_features<First>;
  using B = Piece_of_features<Second>;
  constexpr bool are_features = !std::is_void_v<A> && !std::is_void_v<B>;
  constexpr bool are_alike = !are_features || !std::is_void_v<Common_piece<A, B>>;
  static_assert(are_features, "The elements of the range must be polylines, polygons or triangle "
                              "meshes: ranges of Point_2 or Point_3, Polygon_2 or "
                              "Polygon_with_holes_2, models of FaceListGraph with points in space, "
                              "or pairs of points and triples of indices. For others, pass a "
                              "property map to such features as point_map.");
  static_assert(are_alike, "The features of the two ranges must have points of one type.");
  constexpr bool are_radii_alike
    = !std::is_same_v<Common_radius<Radius_of_features<First>, Radius_of_features<Second>>,
                      Radii_differ>;
  static_assert(are_radii_alike, "The radii of features must be numbers of one type.");
  if constexpr(are_features && are_alike && are_radii_alike)
    return check_no_traits<Piece_point<A>, NamedParameters>();
  else
    return false;
}

// Checks that features that are open have an interior.
template <class Elements>
constexpr bool check_open_features()
{
  constexpr bool have_interiors
    = !Elements::are_open || has_interior_v<typename Elements::value_type>;
  static_assert(have_interiors, "Features in interiors() must be polygons in the plane: points and "
                                "polylines have no interior, and solids are always closed.");
  return have_interiors;
}

// Checks that no feature is thickened if those of a range are open.
template <class First, class Second>
constexpr bool check_thick_features()
{
  using Radius = Common_radius<Radius_of_features<First>, Radius_of_features<Second>>;
  constexpr bool are_thin = (!First::are_open && !Second::are_open) || std::is_void_v<Radius>;
  static_assert(are_thin, "Beside interiors(), features must have no radius: one overlaps a "
                          "polygon iff this is closer than the radius. If all have the same one, "
                          "pass features and polygons without radii, and bound.open(), to "
                          "fixed_radius_near_features().");
  return are_thin;
}

// Checks the elements of one range, or of two.
template <class Elements, class NamedParameters>
constexpr bool check_feature_search()
{
  using A = std::decay_t<decltype(std::declval<const Elements&>().first())>;
  using B = std::decay_t<decltype(std::declval<const Elements&>().second())>;
  if constexpr(check_features<A, B, NamedParameters>())
    return check_open_features<A>() && check_open_features<B>() && check_thick_features<A, B>();
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CHECK_FEATURE_TYPES_H
