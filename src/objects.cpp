// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The predicates of objects whose coordinates are doubles, for programs that define
// CGAL_THICK_INTERSECTION_D_COMPILED.

#include <CGAL/Thick_intersection_d/internal/features/Ring_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/does_ray_cross_face.h>
#include <CGAL/Thick_intersection_d/internal/meshes/mesh_triangles.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/are_objects_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_shapes_intersect.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

CGAL_THICK_INTERSECTION_D_SHAPE_PAIRS(CGAL_THICK_INTERSECTION_D_DO_INTERSECT)

template class Hull_distance<2>;
template class Hull_distance<3>;
template bool are_exact_hulls_near<2>(
  const Hull<2>&, const Hull<2>&, const Hull_distance<2>&, const Hull_bound&,
  const Squared_bound<Exact_number_t<double>>&, Arithmetic_tier, Arithmetic_tier&);
template bool are_exact_hulls_near<3>(
  const Hull<3>&, const Hull<3>&, const Hull_distance<3>&, const Hull_bound&,
  const Squared_bound<Exact_number_t<double>>&, Arithmetic_tier, Arithmetic_tier&);

template bool is_degenerate_face<Staged_orientation<3>>(Staged_orientation<3>::Vertices<3>&);
template bool do_faces_intersect<Staged_orientation<3>, 4>(Staged_orientation<3>::Vertices<4>&);
template bool do_faces_intersect<Staged_orientation<3>, 5>(Staged_orientation<3>::Vertices<5>&);
template bool do_faces_intersect<Staged_orientation<3>, 6>(Staged_orientation<3>::Vertices<6>&);

template Sign orientation_of_vertices<Staged_orientation<2>>(
  Staged_orientation<2>::Vertices<3>&);
template bool does_ray_cross_face<Staged_orientation<3>>(Staged_orientation<3>::Vertices<4>&);

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL
