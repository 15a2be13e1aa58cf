// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PIECES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PIECES_H

// The pieces of features in space, which are meshes and polylines: those that are where their
// feature may meet others. Each feature has a tree of them.

#include <CGAL/Kernel_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_reader.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_regions.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/Solid_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/Space_box.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Object` is the type of pieces, and `Radius` as for Feature_pieces. `Test` is like
// Pieces_intersect.
template <class Object, class Radius, class Test>
class Solid_pieces
{
  using Any_radius = std::conditional_t<std::is_void_v<Radius>, int, Radius>;

public:
  using Point = Piece_point<Object>;
  using Segment = typename Kernel_traits<Point>::Kernel::Segment_3;
  using Triangle = typename Kernel_traits<Point>::Kernel::Triangle_3;
  using Thick = typename Thick_piece<Object, Radius>::type;

  // Throws as Feature_reader does, or if there are too many pieces.
  template <class Features>
  Solid_pieces(const Features& features, const Feature_regions& regions, const Test& test)
    : test_(test)
  {
    reserve(regions);
    for(std::size_t position = 0; position < features.size(); ++position) {
      const Place first = trees_.size();
      region_ = regions.region(position);
      if(!region_.is_empty()) {
        Feature_reader<Solid_pieces> reader(*this, position);
        add_parts(features[position], reader);
      }
      features_.push_back(trees_.add_tree(first));
    }
  }

  const Thick& thick(std::size_t piece) const { return trees_.piece(piece); }

  const Solid_trees<Thick>& trees() const { return trees_; }
  const Halved_range& tree(std::size_t feature) const { return features_[feature]; }

  // ---- for Feature_reader -----------------------------------------------------------------------

  void begin_part() {}

  void add_segment(const Segment& segment)
  {
    add_piece([&] { return segment; }, segment.source(), segment.target());
  }

  void add_face(const Point& p, const Point& q, const Point& r)
  {
    add_piece([&] { return Triangle(p, q, r); }, p, q, r);
  }

  template <class NT>
  void set_radius(const NT& radius)
  {
    radius_ = radius;
    radius_bound_ = bounds(radius).second;
  }

private:
  // Guesses how many pieces there are. A mesh has two for each point. If a feature has more than a
  // few, most of them may be elsewhere.
  void reserve(const Feature_regions& regions)
  {
    constexpr std::size_t few = 1000;
    std::size_t count = 0;
    for(std::size_t position = 0; position < regions.size(); ++position)
      if(!regions.region(position).is_empty())
        count += (std::min)(2 * regions.point_count(position), few);
    trees_.reserve(count);
  }

  template <class Make, class... Points>
  BOOST_FORCEINLINE void add_piece(const Make& make, const Points&... vertices)
  {
    Space_box box;
    (box.add_point(vertices), ...);
    for(std::size_t axis = 0; axis < 3; ++axis)
      box[axis] = searched_interval(box[axis], radius_bound_, test_);
    if(!do_boxes_meet(box, region_))
      return;
    check_feature_count("segments and faces of features", trees_.size() + 1);
    const auto piece = make();
    settle(piece);
    if constexpr(std::is_void_v<Radius>)
      trees_.add_piece(piece, box);
    else
      trees_.add_piece(std::pair(piece, radius_), box);
  }

  const Test& test_;
  Space_box region_;
  Any_radius radius_ = Any_radius(0);
  double radius_bound_ = 0;
  Solid_trees<Thick> trees_;
  std::vector<Halved_range> features_; // their trees
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SOLID_PIECES_H
