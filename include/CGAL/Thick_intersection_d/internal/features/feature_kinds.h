// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_KINDS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_KINDS_H

// What a feature is: a point, a polyline, which is a range of points, or a polygon, with holes or
// without. A variant of features is a feature, and so is a range of them, which is their union.

#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The polygon that a class derives from; other classes are their own kinds, or points.
template <class Kernel, class Container>
Named_type<Polygon_2<Kernel, Container>> polygon_of(const Polygon_2<Kernel, Container>*);
template <class Kernel, class Container>
Named_type<Polygon_with_holes_2<Kernel, Container>>
polygon_of(const Polygon_with_holes_2<Kernel, Container>*);

template <class Feature, class = void>
struct Feature_kind : Named_type<Kind_t<Feature>> {};
template <class Feature>
struct Feature_kind<Feature, std::void_t<decltype(polygon_of(std::declval<const Feature*>()))>>
  : decltype(polygon_of(std::declval<const Feature*>())) {};
template <class Feature>
using Feature_kind_t = typename Feature_kind<Feature>::type;

template <class Feature>
inline constexpr bool is_polygon_v = false;
template <class Kernel, class Container>
inline constexpr bool is_polygon_v<Polygon_2<Kernel, Container>> = true;

template <class Feature>
inline constexpr bool is_polygon_with_holes_v = false;
template <class Kernel, class Container>
inline constexpr bool is_polygon_with_holes_v<Polygon_with_holes_2<Kernel, Container>> = true;

template <class Feature>
inline constexpr bool is_variant_v = false;
template <class... Features>
inline constexpr bool is_variant_v<std::variant<Features...>> = true;

// The elements of a range, as features have them.
template <class Range>
using Element_of_range = std::decay_t<Reference_of<Iterator_of<const Range>>>;

// A polygon may be a range as well, of its vertices.
template <class Feature>
inline constexpr bool is_range_v
  = Is_range<const Feature>::value && !is_polygon_v<Feature_kind_t<Feature>>;

// The type of the points of a feature, or void for what is no feature.
template <class Feature, class = void>
struct Feature_point
{
  using type = void;
};
template <class Feature>
using Feature_point_t = typename Feature_point<Feature>::type;

template <class Kernel>
struct Feature_point<Point_2<Kernel>>
{
  using type = Point_2<Kernel>;
};
template <class Kernel>
struct Feature_point<Point_3<Kernel>>
{
  using type = Point_3<Kernel>;
};
// Polygons of projected points are none: their points are in space.
template <class Kernel, class Container>
struct Feature_point<Polygon_2<Kernel, Container>>
{
  using Point = typename Kernel::Point_2;
  using type = std::conditional_t<Ambient_dimension<Point>::value == 2, Point, void>;
};
template <class Kernel, class Container>
struct Feature_point<Polygon_with_holes_2<Kernel, Container>>
  : Feature_point<Polygon_2<Kernel, Container>>
{};
template <class First, class... Others>
struct Feature_point<std::variant<First, Others...>>
{
  static constexpr bool is_one_type
    = (std::is_same_v<Feature_point_t<First>, Feature_point_t<Others>> && ...);
  using type = std::conditional_t<is_one_type, Feature_point_t<First>, void>;
};
template <class Feature>
struct Feature_point<Feature, std::enable_if_t<is_range_v<Feature>>>
  : Feature_point<Element_of_range<Feature>>
{};
template <class Feature>
struct Feature_point<Feature, std::enable_if_t<!is_range_v<Feature> && !std::is_same_v<
                                Feature_kind_t<Feature>, Feature>>>
  : Feature_point<Feature_kind_t<Feature>>
{};

// Whether all features of a type have an interior: polygons, and unions of them.
template <class Feature, class = void>
inline constexpr bool has_interior_v
  = is_polygon_v<Feature_kind_t<Feature>> || is_polygon_with_holes_v<Feature_kind_t<Feature>>;
template <class... Features>
inline constexpr bool has_interior_v<std::variant<Features...>>
  = (has_interior_v<Features> && ...);
template <class Feature>
inline constexpr bool has_interior_v<Feature, std::enable_if_t<is_range_v<Feature>>>
  = has_interior_v<Element_of_range<Feature>>;

// Hands the parts of a feature to `parts`, by add_polyline(first, last), add_polygon(polygon) and
// add_polygon_with_holes(polygon).
template <class Feature, class Parts>
void add_parts(const Feature& feature, Parts& parts)
{
  using Kind = Feature_kind_t<Feature>;
  if constexpr(Vertex_count<Kind>::value == 1)
    parts.add_polyline(&feature, &feature + 1);
  else if constexpr(is_polygon_v<Kind>)
    parts.add_polygon(feature);
  else if constexpr(is_polygon_with_holes_v<Kind>)
    parts.add_polygon_with_holes(feature);
  else if constexpr(is_variant_v<Feature>)
    std::visit([&](const auto& alternative) { add_parts(alternative, parts); }, feature);
  else if constexpr(Vertex_count<Feature_kind_t<Element_of_range<Feature>>>::value == 1)
    parts.add_polyline(std::begin(feature), std::end(feature));
  else
    for(const auto& member : feature)
      add_parts(member, parts);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_KINDS_H
