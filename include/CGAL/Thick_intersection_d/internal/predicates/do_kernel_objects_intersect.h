// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_KERNEL_OBJECTS_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_KERNEL_OBJECTS_INTERSECT_H

// The intersection test of kernel objects, which are closed, and may be degenerate or points. It is
// exact for the coordinates that they hold: in stages where these are doubles, whatever their type,
// and otherwise by the predicates of the kernel, if they are exact, or of a kernel of rational
// numbers.

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Kernel_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_shapes_intersect.h>

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

// Returns vertex k of the `Count` ones that a question reads, as a point of an exact kernel.
template <class Exact_kernel, std::size_t Count, class Object>
auto exact_vertex(const Object& object, std::size_t k)
{
  using Point = Vertex_t<Object>;
  const auto vertex
    = [&](int axis) { return vertex_of(object, place_of_vertex<Object, Count>(k, axis)); };
  if constexpr(std::is_same_v<typename Kernel_traits<Point>::Kernel, Exact_kernel>
               && Count == corner_count_v<Object>)
    return Point(vertex(0));
  else {
    const auto x = [&](int axis) { return to_exact_rational(coordinate(vertex(axis), axis)); };
    if constexpr(Ambient_dimension<Point>::value == 2)
      return typename Exact_kernel::Point_2(x(0), x(1));
    else
      return typename Exact_kernel::Point_3(x(0), x(1), x(2));
  }
}

// Returns a point in a kernel whose predicates are exact for it.
template <class Point>
auto with_exact_predicates(const Point& p)
{
  return exact_vertex<Kernel_with_exact_predicates<typename Kernel_traits<Point>::Kernel>, 1>(p, 0);
}

// Makes the bounding box of a lazy object final. Otherwise the box would shrink when a predicate
// evaluates the object exactly, in the middle of a search that has ordered objects by their boxes.
// Doubles are final as they are.
template <class Object>
void settle(const Object& object)
{
  if constexpr(is_mixed_v<Object>)
    with_kind(object, [](const auto& kind) { internal::settle(kind); });
  else if constexpr(Is_thickened<Object>::value) {
    settle(hull_points(object));
    if constexpr(Is_lazy<typename Object::second_type>::value)
      CGAL::exact(object.second);
  }
  else if constexpr(Vertex_count<Object>::value != 0)
    if constexpr(Is_lazy<Vertex_number_t<Object>>::value)
      if(!read_vertices(object, [](std::size_t, int, double) {}))
        CGAL::exact(object);
}

// ---- two objects --------------------------------------------------------------------------------

template <class Object>
constexpr Shape shape_v = is_iso_box_v<Object> ? Shape::ISO_BOX
                                               : static_cast<Shape>(Vertex_count<Object>::value);

// How many vertices a question about A and B reads of A.
template <class A, class B>
constexpr std::size_t asked_vertices_v
  = asked_count_v<vertex_dimension_v<A>, shape_v<A>, shape_v<B>>;

// A kernel whose predicates are exact on the points of A and of B. The corners of an iso-box are
// made of the coordinates of others.
template <class A, class B>
struct Common_exact_kernel
{
  using Kernel = Kernel_with_exact_predicates<typename Kernel_traits<Vertex_t<A>>::Kernel>;
  static constexpr bool has_common_kernel
    = std::is_same_v<Kernel,
                     Kernel_with_exact_predicates<typename Kernel_traits<Vertex_t<B>>::Kernel>>;
  static constexpr bool has_made_corners
    = (is_iso_box_v<A> && asked_vertices_v<A, B> > 2)
      || (is_iso_box_v<B> && asked_vertices_v<B, A> > 2);
  using type = std::conditional_t<has_common_kernel && !has_made_corners, Kernel,
                                  Simple_cartesian<Exact_rational>>;
};

// A question about the vertices of two objects, by any orientation.
struct Do_vertices_intersect
{
  template <class Orientation, Shape A, Shape B>
  static bool ask(Asked_vertices<Orientation, A, B>& vertices, Arithmetic_tier& tier)
  {
    return do_vertices_intersect<Orientation, A, B>(vertices, tier);
  }

  // The answer if two objects have a vertex in common.
  static constexpr bool knows_common_vertex = true;

  // The same question about B and A.
  static Do_vertices_intersect swapped() { return {}; }
};

// Objects whose coordinates are not all doubles.
template <class Question, class A, class B>
bool ask_by_kernel(const Question& question, const A& a, const B& b, Arithmetic_tier& tier)
{
  constexpr std::size_t count_a = asked_vertices_v<A, B>, count_b = asked_vertices_v<B, A>;
  using Kernel = typename Common_exact_kernel<A, B>::type;
  using Orientation = Kernel_orientation<Kernel, vertex_dimension_v<A>>;
  Asked_vertices<Orientation, shape_v<A>, shape_v<B>> vertices;
  for(std::size_t k = 0; k < count_a; ++k)
    vertices[k] = exact_vertex<Kernel, count_a>(a, k);
  for(std::size_t k = 0; k < count_b; ++k)
    vertices[count_a + k] = exact_vertex<Kernel, count_b>(b, k);
  return question.template ask<Orientation, shape_v<A>, shape_v<B>>(vertices, tier);
}

// Asks about two objects of CGAL. `tier` is the first arithmetic after the filter, as for
// Staged_orientation, and becomes the one that was needed.
template <class Question, class A, class B>
bool ask_kernel_objects(const Question& question, const A& a, const B& b, Arithmetic_tier& tier)
{
  constexpr Shape shape_a = shape_v<A>, shape_b = shape_v<B>;
  if constexpr(shape_a > shape_b)
    return ask_kernel_objects(question.swapped(), b, a, tier);
  else {
    constexpr std::size_t count_a = asked_vertices_v<A, B>, count_b = asked_vertices_v<B, A>;
    using Orientation = Staged_orientation<vertex_dimension_v<A>>;
    Asked_vertices<Orientation, shape_a, shape_b> vertices;
    const auto put_at = [&](std::size_t first) {
      return [&, first](std::size_t k, int axis, double x) { vertices[first + k].x[axis] = x; };
    };
    [[maybe_unused]] const bool are_doubles = read_vertices<count_a>(a, put_at(0))
                                              && read_vertices<count_b>(b, put_at(count_a));
    if constexpr(!has_double_vertices_v<A> || !has_double_vertices_v<B>)
      if(!are_doubles)
        return ask_by_kernel(question, a, b, tier);
    if constexpr(Question::knows_common_vertex)
      if(have_common_vertex<count_a>(vertices)) {
        tier = Arithmetic_tier::DOUBLE;
        return true;
      }
    return question.template ask<Orientation, shape_a, shape_b>(vertices, tier);
  }
}

// Tests two objects of CGAL.
template <class A, class B>
bool do_kernel_objects_intersect(const A& a, const B& b, Arithmetic_tier& tier)
{
  return ask_kernel_objects(Do_vertices_intersect(), a, b, tier);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_KERNEL_OBJECTS_INTERSECT_H
