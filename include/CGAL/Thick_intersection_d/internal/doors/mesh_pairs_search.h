// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_MESH_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_MESH_PAIRS_SEARCH_H

// The search behind thick_mesh_self_intersections().

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/doors/Mesh_triangles.h>
#include <CGAL/Thick_intersection_d/internal/doors/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/reports/Limited_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Writes the pairs of faces that intersect. Degenerate faces come first, each as a pair with
// itself. Returns the iterator behind the last pair.
template <class ConcurrencyTag, class FaceRange, class Mesh, class Iterator, class NamedParameters>
Iterator write_mesh_pairs(const FaceRange& face_range, const Mesh& mesh, Iterator out,
                          const NamedParameters& np)
{
  check_denormals();
  using Point_map = typename GetVertexPointMap<Mesh, NamedParameters>::const_type;
  Mesh_triangles<Mesh, Point_map> triangles(
    mesh, parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(boost::vertex_point, mesh)));
  triangles.read(face_range);
  Limited_output<Iterator> output(
    out, parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_number),
                                      (std::numeric_limits<std::size_t>::max)()));
  triangles.remove_degenerate([&](const auto& face) { return output.write(face, face); });
  if(!output.is_full()) {
    const auto write = [&](std::size_t i, std::size_t j) {
      return output.write(triangles[i].face, triangles[j].face);
    };
    auto progress = make_progress(np, triangles.size());
    report_meeting_boxes<ConcurrencyTag>(triangles, One_set(), write, progress);
  }
  return output.iterator();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_MESH_PAIRS_SEARCH_H
