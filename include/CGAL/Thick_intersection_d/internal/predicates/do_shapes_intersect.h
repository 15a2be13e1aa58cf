// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_SHAPES_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_SHAPES_INTERSECT_H

// The intersection test of two objects by their vertices, whatever kernel they are of: a shape is
// all that it knows of a type.
//
// A program compiles the test of vertices that are doubles, unless it defines
// CGAL_THICK_INTERSECTION_D_COMPILED. Then it links the library that src/objects.cpp makes.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/iso_boxes.h>
#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/spatial_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/tetrahedra.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// In the order in which a question names them. A simplex is the number of its vertices.
enum class Shape { POINT = 1, SEGMENT, TRIANGLE, TETRAHEDRON, ISO_BOX };

// How many vertices a question about A and B reads of A. Two opposite ones are all of an iso-box to
// points and other iso-boxes.
template <int Dimension, Shape A, Shape B>
constexpr std::size_t asked_count_v
  = A != Shape::ISO_BOX                        ? static_cast<std::size_t>(A)
    : B == Shape::POINT || B == Shape::ISO_BOX ? 2 : std::size_t(1) << Dimension;

// Those of A, and behind them those of B.
template <class Orientation, Shape A, Shape B>
using Asked_vertices = typename Orientation::template Vertices<
  asked_count_v<Orientation::dimension, A, B> + asked_count_v<Orientation::dimension, B, A>>;

template <class Orientation>
bool are_points_equal(const typename Orientation::Point& p, const typename Orientation::Point& q)
{
  for(int axis = 0; axis < Orientation::dimension; ++axis)
    if(Orientation::compare(p, q, axis) != ZERO)
      return false;
  return true;
}

// A does not come behind B. A point is a segment, and next to an iso-box an iso-box.
template <Shape A, Shape B, class Orientation, std::size_t Count_a, std::size_t Count_b>
bool do_shapes_intersect(Orientation& orientation, const Simplex<Orientation, Count_a>& a,
                         const Simplex<Orientation, Count_b>& b)
{
  if constexpr(B == Shape::POINT)
    return are_points_equal<Orientation>(a[0], b[0]);
  else if constexpr(A == Shape::POINT)
    return do_shapes_intersect<B == Shape::ISO_BOX ? B : Shape::SEGMENT, B>(
      orientation, Simplex<Orientation, 2>{a[0], a[0]}, b);
  else if constexpr(A == Shape::ISO_BOX)
    return do_iso_boxes_intersect<Orientation>(a, b);
  else if constexpr(B == Shape::ISO_BOX)
    return does_meet_iso_box(orientation, a, b);
  else if constexpr(Orientation::dimension == 2)
    return do_intersect_in_plane(orientation, a, b);
  else
    return do_intersect_in_space(orientation, a, b);
}

// Returns question(orientation, a, b) for two objects by their vertices. `tier` is the first
// arithmetic after the filter, and becomes the one that was needed.
template <class Orientation, Shape A, Shape B, class Question>
bool ask_vertices(Asked_vertices<Orientation, A, B>& vertices, Arithmetic_tier& tier,
                  const Question& question)
{
  constexpr std::size_t count_a = asked_count_v<Orientation::dimension, A, B>;
  constexpr std::size_t count_b = asked_count_v<Orientation::dimension, B, A>;
  Simplex<Orientation, count_a> a;
  Simplex<Orientation, count_b> b;
  for(std::size_t k = 0; k < count_a; ++k)
    a[k] = typename Orientation::Point(vertices[k]);
  for(std::size_t k = 0; k < count_b; ++k)
    b[k] = typename Orientation::Point(vertices[count_a + k]);
  Orientation orientation(vertices, tier);
  const bool answer = question(orientation, a, b);
  tier = orientation.needed_tier();
  return answer;
}

template <class Orientation, Shape A, Shape B>
bool do_vertices_intersect(Asked_vertices<Orientation, A, B>& vertices, Arithmetic_tier& tier)
{
  return ask_vertices<Orientation, A, B>(
    vertices, tier, [](Orientation& orientation, const auto& a, const auto& b) {
      return do_shapes_intersect<A, B>(orientation, a, b);
    });
}

// Neighbors in meshes and roads share a vertex. No branch depends on which one it is, and most of
// those that share none have no first coordinate in common either. The first object has the first
// `Count` vertices.
template <std::size_t Count, class Vertex, std::size_t Size>
bool have_common_vertex(const std::array<Vertex, Size>& vertices)
{
  const auto is_any_pair = [&](const auto& is_common) {
    bool is_any = false;
    for(std::size_t a = 0; a < Count; ++a)
      for(std::size_t b = Count; b < Size; ++b)
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

// ---- the library --------------------------------------------------------------------------------

// All pairs of shapes, by the macro `pair(dimension, a, b)`.
#define CGAL_THICK_INTERSECTION_D_SHAPE_PAIRS(pair) \
  pair(2, POINT, POINT) pair(2, POINT, SEGMENT) pair(2, POINT, TRIANGLE) pair(2, POINT, ISO_BOX) \
  pair(2, SEGMENT, SEGMENT) pair(2, SEGMENT, TRIANGLE) pair(2, SEGMENT, ISO_BOX) \
  pair(2, TRIANGLE, TRIANGLE) pair(2, TRIANGLE, ISO_BOX) \
  pair(2, ISO_BOX, ISO_BOX) \
  pair(3, POINT, POINT) pair(3, POINT, SEGMENT) pair(3, POINT, TRIANGLE) \
  pair(3, POINT, TETRAHEDRON) pair(3, POINT, ISO_BOX) \
  pair(3, SEGMENT, SEGMENT) pair(3, SEGMENT, TRIANGLE) pair(3, SEGMENT, TETRAHEDRON) \
  pair(3, SEGMENT, ISO_BOX) \
  pair(3, TRIANGLE, TRIANGLE) pair(3, TRIANGLE, TETRAHEDRON) pair(3, TRIANGLE, ISO_BOX) \
  pair(3, TETRAHEDRON, TETRAHEDRON) pair(3, TETRAHEDRON, ISO_BOX) \
  pair(3, ISO_BOX, ISO_BOX)

#define CGAL_THICK_INTERSECTION_D_DO_INTERSECT(dimension, a, b) \
  template bool do_vertices_intersect<Staged_orientation<dimension>, Shape::a, Shape::b>( \
    Asked_vertices<Staged_orientation<dimension>, Shape::a, Shape::b>&, Arithmetic_tier&);

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
#define CGAL_THICK_INTERSECTION_D_EXTERN_DO_INTERSECT(dimension, a, b) \
  extern CGAL_THICK_INTERSECTION_D_DO_INTERSECT(dimension, a, b)
CGAL_THICK_INTERSECTION_D_SHAPE_PAIRS(CGAL_THICK_INTERSECTION_D_EXTERN_DO_INTERSECT)
#undef CGAL_THICK_INTERSECTION_D_EXTERN_DO_INTERSECT
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_SHAPES_INTERSECT_H
