// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_MESH_SELF_INTERSECTIONS_H
#define CGAL_THICK_MESH_SELF_INTERSECTIONS_H

// All pairs of faces of a triangle mesh that intersect, in the place of
// CGAL::Polygon_mesh_processing::self_intersections().

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/meshes/mesh_pairs_search.h>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

writes all pairs of faces of a range that intersect, each exactly once.

The function takes the arguments of `CGAL::Polygon_mesh_processing::self_intersections()` and writes
the same pairs, with one exception, in another order:

- Two faces intersect if their triangles have more in common than an edge or a vertex of the mesh
  that is incident to both faces. So neighbors intersect if one is folded onto the other. Triangles
  that touch are a pair if the mesh does not join them where they touch, as at two vertices at one
  point.
- Two faces with the same three vertices are a pair, as in \cgal 5.5. \cgal 6.1 does not write it.
- A face whose three points are on a line is degenerate. The pair of the face with itself is written
  for it, before all other pairs. It is in no other pair.

The predicates are exact, of degree 3. If the coordinates are doubles, a filter, integers and exact
numbers decide, as for `thick_self_intersection_d()`, whatever the kernel. If not, the predicates
are those of the kernel of the points if they are exact, or else those of a kernel whose predicates
are, on the same coordinates.

The search takes \f$ O(n \log^2 n + K) \f$ time and \f$ O(n) \f$ space for \f$ n \f$ faces, where
\f$ K \f$ is the number of pairs of faces whose bounding boxes meet. The faces around a vertex are
among these pairs. No pair is stored.

To ask whether a mesh intersects itself, set `maximum_number` to 1: the search then stops at the
first pair.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of pairs depends on the input alone. In parallel, the same pairs are written in
any order, one at a time, by several threads in turn. They read the mesh and the property map at the
same time, so these must allow this. `Parallel_tag` requires \tbb.

\tparam FaceRange is a range of face descriptors of the mesh. No face is in it twice.

\tparam TriangleMesh is a model of `FaceListGraph`, such as `Surface_mesh` and `Polyhedron_3`. All
faces in the range are triangles.

\tparam FacePairOutputIterator is a model of `OutputIterator` that takes pairs of face descriptors,
`std::pair<face_descriptor, face_descriptor>`.

\param face_range the faces.
\param tmesh the mesh.
\param out takes the pairs. The first face of a pair comes first in the range.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
    \cgalParamType{a model of `ReadablePropertyMap` from vertex descriptors to `Point_3`}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number}
    \cgalParamDescription{the number of pairs after which the search stops}
    \cgalParamType{an unsigned integer}
    \cgalParamDefault{no limit}
    \cgalParamExtra{In parallel, too, no more pairs are written.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor that is called with the progress between 0 and 1, and cancels
                          the search by returning `false`}
    \cgalParamType{a functor with `bool operator()(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{In parallel, one thread at a time calls it, but not always the same thread.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out` behind the last pair.

\throws std::invalid_argument if a face is no triangle, or if a coordinate is NaN, infinite or
beyond the range of doubles, before anything is written. The message gives the position of the face
in the range. Exceptions of `out` and of the property map pass through.
\throws std::length_error if there are 2<sup>31</sup> - 1 faces or more.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `thick_self_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class FaceRange, class TriangleMesh,
          class FacePairOutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
FacePairOutputIterator
thick_mesh_self_intersections(const FaceRange& face_range, const TriangleMesh& tmesh,
                              FacePairOutputIterator out,
                              const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::write_mesh_pairs(face_range, tmesh, out, np,
                                    internal::Threads(ConcurrencyTag()));
}

/*!
\ingroup PkgThickIntersectionDRef

writes all pairs of faces of a mesh that intersect, each exactly once.

The function is the other one with the range of all faces, `faces(tmesh)`.
*/
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class FacePairOutputIterator,
          class CGAL_NP_TEMPLATE_PARAMETERS>
FacePairOutputIterator
thick_mesh_self_intersections(const TriangleMesh& tmesh, FacePairOutputIterator out,
                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return thick_mesh_self_intersections<ConcurrencyTag>(faces(tmesh), tmesh, out, np);
}

} // namespace CGAL

#endif // CGAL_THICK_MESH_SELF_INTERSECTIONS_H
