// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PAIRS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PAIRS_H

// Features in space, as the box route reads them: two of them are a pair if pieces of them meet, or
// if one has a vertex of the other inside.
//
// This finds all pairs. Let a solid and a mesh or a polyline have a point in common, but no pieces
// that meet. The mesh is its faces, and all points inside if it is closed. Each component of the
// boundary of one is inside the other altogether, or outside, because it is connected and meets no
// face of the other: one vertex tells. Assume that all are outside. Then the common point is on
// neither boundary, so it is inside both. A ray from there leaves both. Up to the first face that
// it reaches, it is inside both. So this face is inside the other one, which cannot be.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/features/Closed_meshes.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_regions.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/Solid_parts.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/features/Values_on_demand.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <atomic>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Pieces` are Solid_pieces, and `Test` is like Pieces_intersect.
template <class Features, class Pieces, class Test>
class Solid_pairs : public Objects_in_boxes<3>
{
  using Solids = Closed_meshes<typename Pieces::Triangle>;

public:
  Solid_pairs(const Features& features, const Feature_regions& regions, const Pieces& pieces,
              const Test& test, const Threads& threads)
    : features_(features), regions_(regions), pieces_(pieces), test_(test),
      read_counts_(features.size()), parts_(features.size(), threads),
      have_inside_(features.size(), threads), solids_(features.size(), threads)
  {}

  std::size_t size() const { return regions_.size(); }
  auto intervals(std::size_t position) const { return regions_.intervals(position); }

  void prefetch(std::size_t position) const
  {
    pieces_.trees().prefetch(pieces_.tree(position));
  }

  bool do_intersect(std::size_t i, std::size_t j) const
  {
    const auto do_meet = [&](Place a, Place b) { return test_.do_meet(pieces_, a, b); };
    return pieces_.trees().is_any_pair(pieces_.tree(i), pieces_.tree(j), do_meet)
           || (test_.takes_insides() && (is_part_inside(i, j) || is_part_inside(j, i)));
  }

private:
  // Whether a part of feature i is inside a solid of feature j. Finds the parts of the pieces that
  // are in the box of that, as these may be few. After some pairs, finds all parts, once. Without a
  // piece that may be inside a solid, needs no parts.
  bool is_part_inside(std::size_t i, std::size_t j) const
  {
    const Space_box& box = regions_.box(j);
    const Halved_range& tree = pieces_.tree(i);
    const auto is_inside = [&](Place p) { return is_vertex_inside(pieces_.thick(p), j); };
    if(read_counts_[i] > 4 * std::size_t(tree.last - tree.first))
      return parts_.get(i, [&] { return Solid_parts(pieces_, places_of(tree)); })
        .is_any_inside(box, is_inside);
    const auto is_piece_within = [&](Place p) { return is_within(pieces_.thick(p), box); };
    if(!pieces_.trees().is_any_in_box(tree, box, is_piece_within)
       || !have_inside_.get(j, [&] { return may_have_inside(features_[j], j); }))
      return false;
    std::vector<Place> near;
    pieces_.trees().is_any_in_box(tree, box, [&](Place p) {
      near.push_back(p);
      return false;
    });
    read_counts_[i] += near.size();
    return Solid_parts(pieces_, near).is_any_inside(box, is_inside);
  }

  static std::vector<Place> places_of(const Halved_range& tree)
  {
    std::vector<Place> places(tree.last - tree.first);
    std::iota(places.begin(), places.end(), tree.first);
    return places;
  }

  bool is_vertex_inside(const typename Pieces::Thick& piece, std::size_t j) const
  {
    const Solids& solids = solids_.get(j, [&] { return Solids(features_[j], j); });
    return with_points_of(piece, [&](const auto& source) { return solids.is_inside(source); });
  }

  const Features& features_;
  const Feature_regions& regions_;
  const Pieces& pieces_;
  const Test& test_;
  mutable std::vector<std::atomic<std::size_t>> read_counts_; // of pieces, for parts
  Values_on_demand<Solid_parts> parts_;
  Values_on_demand<bool> have_inside_;
  Values_on_demand<Solids> solids_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PAIRS_H
