// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CLOSED_MESHES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CLOSED_MESHES_H

// The closed meshes of a feature, which are solids. Each has a tree of all of its faces.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/Mesh_shape.h>
#include <CGAL/Thick_intersection_d/internal/features/Solid_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/mesh_faces.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The parts of a feature, for add_parts(), that have nothing inside, whatever its radius.
struct Parts_without_inside
{
  template <class Iterator, class Sentinel>
  void add_polyline(Iterator, Sentinel)
  {}
  template <class NT>
  void begin_thick(const NT&)
  {}
  void end_thick() {}
};

// Whether a mesh of a feature may be closed. To see this takes less time than to make a tree.
struct Inside_finder : Parts_without_inside
{
  template <class Mesh>
  void add_mesh(const Mesh& mesh)
  {
    is_found = is_found || is_closed_by_count(mesh) || !has_odd_edge(mesh, feature);
  }

  std::size_t feature; // its position
  bool is_found = false;
};

template <class Feature>
bool may_have_inside(const Feature& feature, std::size_t position)
{
  Inside_finder finder{{}, position};
  add_parts(feature, finder);
  return finder.is_found;
}

template <class Triangle>
class Closed_meshes : public Parts_without_inside
{
public:
  // Reads the feature at a position.
  template <class Feature>
  Closed_meshes(const Feature& feature, std::size_t position) : feature_(position)
  {
    add_parts(feature, *this);
  }

  // Whether the first vertex of a segment or triangle is inside a mesh. It is on none.
  template <class Source>
  bool is_inside(const Source& source) const
  {
    return std::any_of(solids_.begin(), solids_.end(), [&](const Halved_range& faces) {
      return trees_.is_inside(source, faces);
    });
  }

  // ---- for add_parts() --------------------------------------------------------------------------

  template <class Mesh>
  void add_mesh(const Mesh& mesh)
  {
    const Place first = trees_.size();
    for_each_face(mesh, feature_, [&](const auto& p, const auto& q, const auto& r) {
      Space_box box;
      for(const auto* vertex : {&p, &q, &r})
        box.add_point(*vertex);
      const Triangle face(p, q, r);
      settle(face);
      trees_.add_piece(face, box);
    });
    const auto face_at
      = [&](std::size_t i) -> const Triangle& { return trees_.piece(first + i); };
    if(is_closed_by_count(mesh) || Mesh_shape(trees_.size() - first, face_at).is_closed())
      solids_.push_back(trees_.add_tree(first));
    else
      trees_.remove_pieces(first);
  }

private:
  const std::size_t feature_;
  Solid_trees<Triangle> trees_;
  std::vector<Halved_range> solids_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CLOSED_MESHES_H
