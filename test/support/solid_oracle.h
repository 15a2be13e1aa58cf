// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangle meshes and polylines on a lattice in space, and whether two unions of them intersect: by
// all pairs of their faces and segments, and by all vertices of one in the other.
//
// This shares nothing with the search. Coordinates differ by less than 2^8.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SOLID_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_SOLID_ORACLE_H

#include "distance_oracle.h"
#include "feature_oracle.h"
#include "hull_oracle.h"
#include "pairs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace test_support {

using Lattice_face = std::array<Lattice_point, 3>;
using Lattice_mesh = std::vector<Lattice_face>;

// A union.
struct Lattice_solid
{
  std::vector<Lattice_mesh> meshes;
  std::vector<Chain> chains;
};

using Lattice_solids = std::vector<Lattice_solid>;

// The vertices of each face and segment.
inline std::vector<Hull_vectors<std::int64_t>> hulls_of(const Lattice_solid& solid)
{
  std::vector<Hull_vectors<std::int64_t>> hulls;
  for(const Lattice_mesh& mesh : solid.meshes)
    for(const Lattice_face& face : mesh)
      hulls.emplace_back(face.begin(), face.end());
  for(const Lattice_segment& s : segments_of({Feature_kind::POLYLINE, solid.chains}))
    hulls.emplace_back(s.begin(), s.end());
  return hulls;
}

inline bool is_closed(const Lattice_mesh& mesh)
{
  std::map<std::pair<Lattice_point, Lattice_point>, std::size_t> faces_at;
  for(const Lattice_face& face : mesh)
    for(std::size_t k = 0; k < 3; ++k)
      if(face[k] != face[(k + 1) % 3])
        ++faces_at[std::minmax({face[k], face[(k + 1) % 3]})];
  return std::all_of(faces_at.begin(), faces_at.end(),
                     [](const auto& edge) { return edge.second % 2 == 0; });
}

// Whether a ray from p has a point of the face, which does not have p. The ray is in no plane of p
// and two points of the lattice: it would be normal to their cross product, whose coordinates are
// less than 2^17.
inline bool does_ray_meet(const Lattice_point& p, const Lattice_face& face)
{
  const Lattice_point ray = {1, std::int64_t(1) << 18, std::int64_t(1) << 36};
  const Lattice_point u = difference(face[0], p), v = difference(face[1], p),
                      w = difference(face[2], p);
  const auto is_positive = [](const Lattice_point& a, const Lattice_point& b,
                              const Lattice_point& c) { return dot(cross(a, b), c) > 0; };
  const auto is_negative = [](const Lattice_point& a, const Lattice_point& b,
                              const Lattice_point& c) { return dot(cross(a, b), c) < 0; };
  const auto are_all = [&](const auto& has_sign) {
    return has_sign(u, v, w) && has_sign(v, w, ray) && has_sign(w, u, ray) && has_sign(u, v, ray);
  };
  return are_all(is_positive) || are_all(is_negative);
}

// Whether a point that is on no face of a closed mesh is in it.
inline bool is_inside(const Lattice_point& p, const Lattice_mesh& mesh)
{
  return std::count_if(mesh.begin(), mesh.end(), [&](const Lattice_face& face) {
           return does_ray_meet(p, face);
         }) % 2 != 0;
}

inline bool has_vertex_inside(const Lattice_solid& a, const Lattice_solid& b)
{
  const auto hulls = hulls_of(a);
  return std::any_of(b.meshes.begin(), b.meshes.end(), [&](const Lattice_mesh& mesh) {
    return is_closed(mesh) && std::any_of(hulls.begin(), hulls.end(), [&](const auto& hull) {
             return std::any_of(hull.begin(), hull.end(),
                                [&](const Lattice_point& p) { return is_inside(p, mesh); });
           });
  });
}

// Whether two sets are within a bound on the squared distance, closed or open. A bound of zero that
// is closed asks whether they intersect.
struct Lattice_bound
{
  std::int64_t r2 = 0;
  bool is_open = false;

  bool operator()(const Hull_vectors<std::int64_t>& a, const Hull_vectors<std::int64_t>& b) const
  {
    std::int64_t least = 0; // of the squared distance
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const auto by_axis = [=](const auto& p, const auto& q) { return p[axis] < q[axis]; };
      const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), by_axis);
      const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), by_axis);
      const std::int64_t gap = (std::max)({(*a_low)[axis] - (*b_high)[axis],
                                           (*b_low)[axis] - (*a_high)[axis], std::int64_t(0)});
      least += gap * gap;
    }
    if(least > r2)
      return false;
    if(r2 == 0)
      return !is_open && do_hulls_intersect(a, b);
    const auto distance = squared_distance_of_hulls(a, b);
    return is_open ? distance < r2 : distance <= r2;
  }
};

inline bool are_near(const Lattice_solid& a, const Lattice_solid& b, const Lattice_bound& bound)
{
  for(const auto& hull_a : hulls_of(a))
    for(const auto& hull_b : hulls_of(b))
      if(bound(hull_a, hull_b))
        return true;
  return (bound.r2 != 0 || !bound.is_open) && (has_vertex_inside(a, b) || has_vertex_inside(b, a));
}

inline Pairs pairs_of_solids(const Lattice_solids& solids, const Lattice_bound& bound = {})
{
  return pairs_where(solids.size(), [&](std::size_t i, std::size_t j) {
    return are_near(solids[i], solids[j], bound);
  });
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SOLID_ORACLE_H
