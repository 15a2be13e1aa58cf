// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_KINDS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_KINDS_H

// What a feature is: a point, a polyline, which is a range of points, a polygon, with holes or
// without, or a triangle mesh. A variant of features is a feature, and so is a range of them, which
// is their union.

#include <CGAL/Kernel_traits.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Polyhedron_3_fwd.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/properties.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The polygon or mesh that a class derives from; other classes are their own kinds, or points.
template <class Kernel, class Container>
Named_type<Polygon_2<Kernel, Container>> feature_of(const Polygon_2<Kernel, Container>*);
template <class Kernel, class Container>
Named_type<Polygon_with_holes_2<Kernel, Container>>
feature_of(const Polygon_with_holes_2<Kernel, Container>*);
template <class Point>
Named_type<Surface_mesh<Point>> feature_of(const Surface_mesh<Point>*);
template <class Traits, class Items, template <class, class, class> class Hds, class Alloc>
Named_type<Polyhedron_3<Traits, Items, Hds, Alloc>>
feature_of(const Polyhedron_3<Traits, Items, Hds, Alloc>*);
template <class Points, class Triples>
Named_type<std::pair<Points, Triples>> feature_of(const std::pair<Points, Triples>*);

template <class Feature, class = void>
struct Feature_kind : Named_type<Kind_t<Feature>> {};
template <class Feature>
struct Feature_kind<Feature, std::void_t<decltype(feature_of(std::declval<const Feature*>()))>>
  : decltype(feature_of(std::declval<const Feature*>())) {};
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

// The elements of a range, as features have them.
template <class Range>
using Element_of_range = std::decay_t<Reference_of<Iterator_of<const Range>>>;

// A polygon may be a range as well, of its vertices.
template <class Feature>
inline constexpr bool is_range_v
  = Is_range<const Feature>::value && !is_polygon_v<Feature_kind_t<Feature>>;

// ---- meshes -------------------------------------------------------------------------------------

// The kind of the points of a model of FaceListGraph that has points, or void for other types.
template <class Mesh, class = void>
struct Mesh_point : Named_type<void> {};
template <class Mesh>
struct Mesh_point<Mesh, std::enable_if_t<graph_has_property<Mesh, boost::vertex_point_t>::value>>
  : Named_type<Base_kind_t<typename boost::property_traits<
      typename boost::property_map<Mesh, boost::vertex_point_t>::const_type>::value_type>> {};

// The same of a pair of points, and of triples of their indices.
template <class Soup, class = void>
struct Soup_point : Named_type<void> {};
template <class Points, class Triples>
struct Soup_point<std::pair<Points, Triples>,
                  std::enable_if_t<Is_range<const Points>::value && std::is_integral_v<
                                     Element_of_range<Element_of_range<Triples>>>>>
  : Named_type<Base_kind_t<Element_of_range<Points>>> {};

template <class Feature>
inline constexpr bool is_mesh_v = !std::is_void_v<typename Mesh_point<Feature>::type>;
template <class Feature>
inline constexpr bool is_soup_v = !std::is_void_v<typename Soup_point<Feature>::type>;

// The faces of meshes whose points are in space.
template <class Point>
struct Face_at : Named_type<void> {};
template <class Kernel>
struct Face_at<Point_3<Kernel>> : Named_type<typename Kernel::Triangle_3> {};

// ---- pieces -------------------------------------------------------------------------------------

// The points of pieces: segments, triangles in space, or variants of both.
template <class Object>
using Piece_point = Vertex_t<typename Kinds<Object>::First>;

// The type that holds pieces of both types, or void if they have no points of one type.
template <class A, class B>
constexpr auto common_piece()
{
  if constexpr(std::is_same_v<A, B>)
    return Named_type<A>();
  else if constexpr(std::is_void_v<A> || std::is_void_v<B>)
    return Named_type<void>();
  else if constexpr(std::is_same_v<Piece_point<A>, Piece_point<B>>) {
    using Kernel = typename Kernel_traits<Piece_point<A>>::Kernel;
    return Named_type<std::variant<typename Kernel::Segment_3, typename Kernel::Triangle_3>>();
  }
  else
    return Named_type<void>();
}
template <class A, class B>
using Common_piece = typename decltype(common_piece<A, B>())::type;

// Returns task(piece) for the segment or triangle that a piece is, without its radius.
template <class Object, class Task>
auto with_points_of(const Object& piece, const Task& task)
{
  return with_kind(piece, [&](const auto& kind) { return task(hull_points(kind)); });
}

// The type of the pieces of the boundary of a feature, or void for what is no feature.
template <class Feature, class = void>
struct Feature_piece : Named_type<void> {};
template <class Feature>
using Feature_piece_t = typename Feature_piece<Feature>::type;

template <class Kernel>
struct Feature_piece<Point_2<Kernel>> : Named_type<typename Kernel::Segment_2> {};
template <class Kernel>
struct Feature_piece<Point_3<Kernel>> : Named_type<typename Kernel::Segment_3> {};
// Polygons of projected points are none: their points are in space.
template <class Kernel, class Container>
struct Feature_piece<Polygon_2<Kernel, Container>>
  : Named_type<std::conditional_t<Ambient_dimension<typename Kernel::Point_2>::value == 2,
                                  typename Kernel::Segment_2, void>> {};
template <class Kernel, class Container>
struct Feature_piece<Polygon_with_holes_2<Kernel, Container>>
  : Feature_piece<Polygon_2<Kernel, Container>> {};
template <class Feature>
struct Feature_piece<std::variant<Feature>> : Feature_piece<Feature> {};
template <class First, class... Others>
struct Feature_piece<std::variant<First, Others...>>
  : Named_type<Common_piece<Feature_piece_t<First>, Feature_piece_t<std::variant<Others...>>>> {};
template <class Feature>
struct Feature_piece<Feature, std::enable_if_t<is_mesh_v<Feature>>>
  : Face_at<typename Mesh_point<Feature>::type> {};
template <class Feature>
struct Feature_piece<Feature, std::enable_if_t<is_soup_v<Feature>>>
  : Face_at<typename Soup_point<Feature>::type> {};
template <class Feature>
struct Feature_piece<Feature, std::enable_if_t<is_range_v<Feature>>>
  : Feature_piece<Element_of_range<Feature>> {};
template <class Feature>
struct Feature_piece<
  Feature, std::enable_if_t<!is_range_v<Feature> && !is_mesh_v<Feature>
                            && !std::is_same_v<Feature_kind_t<Feature>, Feature>>>
  : Feature_piece<Feature_kind_t<Feature>> {};

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

// ---- radii --------------------------------------------------------------------------------------

// Whether a feature is a pair of another one, and a radius by which that is thickened.
template <class Feature>
inline constexpr bool is_thick_v = false;
template <class Feature, class NT>
inline constexpr bool is_thick_v<std::pair<Feature, NT>> = is_number_v<NT>;

// The type of the radii of two features, of which some have none, and then it is that of the
// others. It is `Radii_differ` if they have two types.
struct Radii_differ {};
template <class A, class B>
using Common_radius
  = std::conditional_t<std::is_void_v<A> || std::is_same_v<A, B>, B,
                       std::conditional_t<std::is_void_v<B>, A, Radii_differ>>;

// The type of the radii of a feature and of its members, or void if it has none.
template <class Feature, class = void>
struct Feature_radius : Named_type<void> {};
template <class Feature>
using Feature_radius_t = typename Feature_radius<Feature>::type;

template <class Feature, class NT>
struct Feature_radius<std::pair<Feature, NT>, std::enable_if_t<is_number_v<NT>>>
  : Named_type<NT> {};
template <class Feature>
struct Feature_radius<std::variant<Feature>> : Feature_radius<Feature> {};
template <class First, class... Others>
struct Feature_radius<std::variant<First, Others...>>
  : Named_type<Common_radius<Feature_radius_t<First>, Feature_radius_t<std::variant<Others...>>>>
{};
template <class Feature>
struct Feature_radius<Feature, std::enable_if_t<is_range_v<Feature>>>
  : Feature_radius<Element_of_range<Feature>> {};

// An integer next to a feature may be an index. A feature of which a member has a radius has no
// other one: radii of one number type may have no sum in it.
template <class Feature, class NT>
struct Feature_piece<std::pair<Feature, NT>, std::enable_if_t<is_number_v<NT>>>
  : Named_type<std::conditional_t<
      !std::is_void_v<Feature_radius_t<Feature>>
        || (std::is_integral_v<NT> && !Is_coordinate<Feature_piece_t<Feature>, NT>::value),
      void, Feature_piece_t<Feature>>> {};

// A piece with a radius, as an object that is searched.
template <class Object, class Radius>
struct Thick_piece : Named_type<std::pair<Object, Radius>> {};
template <class... Kinds, class Radius>
struct Thick_piece<std::variant<Kinds...>, Radius>
  : Named_type<std::variant<std::pair<Kinds, Radius>...>> {};
template <class Object>
struct Thick_piece<Object, void> : Named_type<Object> {};
template <class... Kinds>
struct Thick_piece<std::variant<Kinds...>, void> : Named_type<std::variant<Kinds...>> {};

// ---- parts --------------------------------------------------------------------------------------

// Hands the parts of a feature to `parts`, by add_polyline(first, last), add_polygon(polygon),
// add_polygon_with_holes(polygon) and add_mesh(mesh). Those of a feature with a radius are between
// begin_thick(radius) and end_thick().
template <class Feature, class Parts>
void add_parts(const Feature& feature, Parts& parts)
{
  using Kind = Feature_kind_t<Feature>;
  if constexpr(Is_one_of_two<Feature>::value)
    of_range(feature, [&](const auto& one) { add_parts(one, parts); });
  else if constexpr(Vertex_count<Kind>::value == 1)
    parts.add_polyline(&feature, &feature + 1);
  else if constexpr(is_polygon_v<Kind>)
    parts.add_polygon(static_cast<const Kind&>(feature)); // members of its class may hide others
  else if constexpr(is_polygon_with_holes_v<Kind>)
    parts.add_polygon_with_holes(static_cast<const Kind&>(feature));
  else if constexpr(is_mesh_v<Feature>)
    parts.add_mesh(feature);
  else if constexpr(is_mesh_v<Kind> || is_soup_v<Kind>)
    parts.add_mesh(static_cast<const Kind&>(feature));
  else if constexpr(is_thick_v<Feature>) {
    parts.begin_thick(feature.second);
    add_parts(feature.first, parts);
    parts.end_thick();
  }
  else if constexpr(Is_variant<Feature>::value)
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
