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
#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
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

#include <array>
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
    if constexpr(Is_lazy<typename Kernel_traits<Object>::Kernel::FT>::value)
      if(!read_vertices(object, [](std::size_t, int, double) {}))
        CGAL::exact(object);
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

template <class Orientation>
bool are_points_equal(const typename Orientation::Point& p, const typename Orientation::Point& q)
{
  for(int axis = 0; axis < Orientation::dimension; ++axis)
    if(Orientation::compare(p, q, axis) != ZERO)
      return false;
  return true;
}

// Whether objects of the type Object intersect, by the vertices that have all their coordinates.
template <class Object, class Orientation, std::size_t Count>
bool do_simplices_intersect(Orientation& orientation, const Simplex<Orientation, Count>& a,
                            const Simplex<Orientation, Count>& b)
{
  if constexpr(Count == 1)
    return are_points_equal<Orientation>(a[0], b[0]);
  else if constexpr(is_iso_box_v<Object>)
    return do_iso_boxes_intersect<Orientation>(a, b);
  else if constexpr(Orientation::dimension == 2)
    return do_intersect_in_plane(orientation, a, b);
  else
    return do_intersect_in_space(orientation, a, b);
}

// Whether objects of the type Object intersect, which have one half of the vertices each.
template <class Object, class Orientation>
bool do_vertices_intersect(typename Orientation::Vertices& vertices, Arithmetic_tier& tier)
{
  constexpr std::size_t count = corner_count_v<Object>;
  Simplex<Orientation, count> a, b;
  for(std::size_t k = 0; k < count; ++k) {
    a[k] = typename Orientation::Point(vertices[k]);
    b[k] = typename Orientation::Point(vertices[count + k]);
  }
  Orientation orientation(vertices, tier);
  const bool do_intersect = do_simplices_intersect<Object>(orientation, a, b);
  tier = orientation.needed_tier();
  return do_intersect;
}

// Neighbors in meshes and roads share a vertex. No branch depends on which one it is, and most of
// those that share none have no first coordinate in common either.
template <class Vertex, std::size_t Count>
bool have_common_vertex(const std::array<Vertex, Count>& vertices)
{
  const auto is_any_pair = [&](const auto& is_common) {
    bool is_any = false;
    for(std::size_t a = 0; a < Count / 2; ++a)
      for(std::size_t b = Count / 2; b < Count; ++b)
        is_any |= is_common(vertices[a].x, vertices[b].x);
    return is_any;
  };
  return is_any_pair([](const auto& x, const auto& y) { return x[0] == y[0]; })
         && is_any_pair([](const auto& x, const auto& y) {
              bool are_equal = true;
              for(std::size_t i = 0; i < x.size(); ++i)
                are_equal &= x[i] == y[i];
              return are_equal;
            });
}

// ---- by coordinates -----------------------------------------------------------------------------

// Objects whose coordinates are not all doubles.
template <class Object>
bool do_objects_intersect_by_kernel(const Object& a, const Object& b, Arithmetic_tier& tier)
{
  using Kernel = Kernel_with_exact_predicates<typename Kernel_traits<Object>::Kernel>;
  constexpr std::size_t count = corner_count_v<Object>;
  using Orientation = Kernel_orientation<Kernel, vertex_dimension_v<Object>, 2 * count>;
  typename Orientation::Vertices vertices;
  for(std::size_t k = 0; k < count; ++k) {
    const int v = static_cast<int>(k) * Vertex_step<Object>::value;
    vertices[k] = with_exact_predicates(vertex_of(a, v));
    vertices[count + k] = with_exact_predicates(vertex_of(b, v));
  }
  return do_vertices_intersect<Object, Orientation>(vertices, tier);
}

// Tests two objects of a kernel. `tier` is the first arithmetic after the filter, as for
// Staged_orientation, and becomes the one that was needed.
template <class Object>
bool do_kernel_objects_intersect(const Object& a, const Object& b, Arithmetic_tier& tier)
{
  constexpr std::size_t count = corner_count_v<Object>;
  using Orientation = Staged_orientation<vertex_dimension_v<Object>, 2 * count>;
  typename Orientation::Vertices vertices;
  const auto read = [&](const Object& object, std::size_t first) {
    return read_vertices(object, [&](std::size_t k, int axis, double x) {
      vertices[first + k].x[axis] = x;
    });
  };
  [[maybe_unused]] const bool are_doubles = read(a, 0) && read(b, count);
  if constexpr(!has_double_vertices_v<Object>)
    if(!are_doubles)
      return do_objects_intersect_by_kernel(a, b, tier);
  if(!have_common_vertex(vertices))
    return do_vertices_intersect<Object, Orientation>(vertices, tier);
  tier = Arithmetic_tier::DOUBLE;
  return true;
}

// do_intersect() of objects that are not of CGAL is found in their namespace.
template <class Object>
bool do_objects_intersect(const Object& a, const Object& b, Arithmetic_tier& tier)
{
  if constexpr(Vertex_count<Object>::value != 0)
    return do_kernel_objects_intersect(a, b, tier);
  else if constexpr(std::is_same_v<Object, Bbox_2> || std::is_same_v<Object, Bbox_3>)
    return do_overlap(a, b);
  else
    return do_intersect(a, b);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_OBJECTS_INTERSECT_H
