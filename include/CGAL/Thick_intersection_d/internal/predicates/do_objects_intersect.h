// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H

// The intersection test of kernel objects, which are closed, and may be flat or points. It is exact
// for the coordinates that they hold: in stages where these are doubles, whatever their type, and
// otherwise by the predicates of the kernel, if they are exact, or of a kernel of rational numbers.

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/spatial_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/tetrahedra.h>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether numbers of a type overflow. CGAL calls `long long` an exact type, and quotients of it.
template <class NT>
struct Has_limits : std::bool_constant<std::is_arithmetic_v<NT>
                                       || std::numeric_limits<NT>::is_bounded>
{};
template <class Integer>
struct Has_limits<Quotient<Integer>> : Has_limits<Integer> {};

template <class FT>
constexpr bool has_exact_predicates_v
  = Algebraic_structure_traits<FT>::Is_exact::value && !Has_limits<FT>::value;

// A kernel whose predicates are exact on the points of Kernel.
template <class Kernel>
using Kernel_with_exact_predicates
  = std::conditional_t<has_exact_predicates_v<typename Kernel::FT>, Kernel,
                       Simple_cartesian<Exact_rational>>;

// Returns a point in a kernel whose predicates are exact for it.
template <class Point>
decltype(auto) with_exact_predicates(const Point& p)
{
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Exact_kernel = Kernel_with_exact_predicates<Kernel>;
  if constexpr(std::is_same_v<Kernel, Exact_kernel>)
    return Point(p);
  else {
    const auto x = [&](int i) { return to_exact_rational(coordinate(p, i)); };
    if constexpr(Ambient_dimension<Point>::value == 2)
      return typename Exact_kernel::Point_2(x(0), x(1));
    else
      return typename Exact_kernel::Point_3(x(0), x(1), x(2));
  }
}

// Makes the bounding box of a lazy object final. Otherwise the box would shrink when a predicate
// evaluates the object exactly, in the middle of a search that has ordered objects by their boxes.
// Doubles are final as they are.
template <class Object>
void settle(const Object& object)
{
  if constexpr(Vertex_count<Object>::value != 0)
    if constexpr(Is_lazy<typename Kernel_traits<Object>::Kernel::FT>::value) {
      Vertex_doubles<Object> vertices;
      if(!read_vertices(object, vertices))
        CGAL::exact(object);
    }
}

// The algebraic degree of the test of two objects that are of a kernel or boxes.
template <class Object>
constexpr int test_degree()
{
  if constexpr(Vertex_count<Object>::value <= 1)
    return 1;
  else
    return is_iso_box_v<Object> ? 1 : vertex_dimension_v<Object>;
}

// ---- by vertices --------------------------------------------------------------------------------

template <class Orientation>
bool do_iso_boxes_intersect(const Simplex<Orientation, 2>& a, const Simplex<Orientation, 2>& b)
{
  for(int axis = 0; axis < Orientation::dimension; ++axis)
    if(Orientation::compare(a[1], b[0], axis) == NEGATIVE
       || Orientation::compare(b[1], a[0], axis) == NEGATIVE)
      return false;
  return true;
}

// Whether objects of the type Object intersect, by the vertices that have all their coordinates.
template <class Object, class Orientation, std::size_t Count>
bool do_simplices_intersect(Orientation& orientation, const Simplex<Orientation, Count>& a,
                            const Simplex<Orientation, Count>& b)
{
  if constexpr(Count == 1)
    return a == b;
  else if constexpr(is_iso_box_v<Object>)
    return do_iso_boxes_intersect<Orientation>(a, b);
  else if constexpr(Orientation::dimension == 2)
    return do_intersect_in_plane(orientation, a, b);
  else
    return do_intersect_in_space(orientation, a, b);
}

// Neighbors in meshes and roads share a vertex.
template <class Vertices>
bool have_common_vertex(const Vertices& a, const Vertices& b)
{
  bool is_any = false;
  for(const auto& p : a)
    for(const auto& q : b)
      is_any |= p == q;
  return is_any;
}

// ---- by coordinates -----------------------------------------------------------------------------

// Objects whose vertices are no doubles.
template <class Object>
bool do_objects_intersect_by_kernel(const Object& a, const Object& b)
{
  using Kernel = Kernel_with_exact_predicates<typename Kernel_traits<Object>::Kernel>;
  using Orientation = Kernel_orientation<Kernel, vertex_dimension_v<Object>>;
  const auto vertices_of = [](const Object& object) {
    Simplex<Orientation, corner_count_v<Object>> vertices;
    int v = 0;
    for(auto& vertex : vertices) {
      vertex = with_exact_predicates(vertex_of(object, v));
      v += Vertex_step<Object>::value;
    }
    return vertices;
  };
  Orientation orientation;
  return do_simplices_intersect<Object>(orientation, vertices_of(a), vertices_of(b));
}

// Tests two objects of a kernel. `tier` is the first arithmetic after the filter, as for
// Staged_orientation, and becomes the one that was needed.
template <class Object>
bool do_kernel_objects_intersect(const Object& a, const Object& b, Arithmetic_tier& tier)
{
  Vertex_doubles<Object> vertices_a, vertices_b;
  if(!read_vertices(a, vertices_a) || !read_vertices(b, vertices_b)) {
    tier = Arithmetic_tier::FILTERED_EXACT;
    return do_objects_intersect_by_kernel(a, b);
  }
  Staged_orientation<vertex_dimension_v<Object>> orientation(tier);
  const bool do_intersect
    = have_common_vertex(vertices_a, vertices_b)
      || do_simplices_intersect<Object>(orientation, vertices_a, vertices_b);
  tier = orientation.needed_tier();
  return do_intersect;
}

// do_intersect() of other objects is found in their namespace.
template <class Object>
bool do_objects_intersect(const Object& a, const Object& b, Arithmetic_tier& tier)
{
  if constexpr(Vertex_count<Object>::value != 0)
    return do_kernel_objects_intersect(a, b, tier);
  else
    return do_intersect(a, b);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H
