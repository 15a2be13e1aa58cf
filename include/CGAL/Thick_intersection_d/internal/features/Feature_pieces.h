// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PIECES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PIECES_H

// The pieces of the boundaries of features: the segments of polylines, the edges of polygons, and
// the faces of meshes. A feature has parts, each of which is a polyline, a polygon, or a connected
// component of the faces of a mesh.

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Everywhere.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_reader.h>
#include <CGAL/Thick_intersection_d/internal/features/Ring_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/Solid_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Object` is that of a feature, or the common one of several. `Radius` is the type of the radii by
// which features are thickened, or void if none has a radius.
template <class Object, class Radius = void>
class Feature_pieces
{
  using Point = Piece_point<Object>;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Any_radius = std::conditional_t<std::is_void_v<Radius>, int, Radius>;

public:
  using value_type = Object;
  static constexpr int dimension = vertex_dimension_v<Point>;
  using Segment = std::conditional_t<dimension == 2, typename Kernel::Segment_2,
                                     typename Kernel::Segment_3>;
  using Box = Bbox_of_dimension<dimension>;

  // A piece with its radius, as a search sees it.
  using Thick = typename Thick_piece<Object, Radius>::type;
  static constexpr bool have_radii = !std::is_void_v<Radius>;

  // Whether there may be meshes.
  static constexpr bool have_faces = !std::is_same_v<Object, Segment>;

  struct Part
  {
    Place feature;
    Place piece;  // begins at the first vertex
    Place filled; // the polygon or closed mesh that the part bounds, or `none`
  };

  // A polygon, or the faces of a closed mesh.
  struct Filled
  {
    Place feature;
    Place part; // the first one
    Place first_piece, last_piece; // the one behind the last
    Place root; // of its tree
  };

  // Takes less than `limit` features and pieces, and parts and filled ones together, which places
  // must number.
  explicit Feature_pieces(std::size_t limit = max_place / 2) : limit_(limit), trees_(pieces_) {}
  Feature_pieces(const Feature_pieces&) = delete; // the trees refer to the pieces
  Feature_pieces& operator=(const Feature_pieces&) = delete;

  // Reads the features of a range. Throws if a coordinate is NaN or infinite, if a polygon has no
  // outer boundary, if a face is no triangle, or if there are too many of them.
  template <class Elements>
  void add_features(const Elements& features)
  {
    add_features(features, Everywhere());
  }

  // Takes pieces where features may meet others. `Where` is like Everywhere.
  template <class Elements, class Where>
  void add_features(const Elements& features, const Where& where)
  {
    for(std::size_t position = 0; position < features.size(); ++position) {
      check_count("features", feature_count_ + 1);
      first_parts_.push_back(static_cast<Place>(parts_.size()));
      Feature_reader<Feature_pieces, Where> reader(*this, where);
      if(where.takes(feature_count_))
        add_parts(features[position], reader);
      ++feature_count_;
    }
  }

  std::size_t feature_count() const { return feature_count_; }
  std::size_t size() const { return pieces_.size(); }
  const Object& operator[](std::size_t position) const { return pieces_[position]; }

  // Returns a piece with its radius, if features have radii.
  decltype(auto) thick(std::size_t position) const
  {
    if constexpr(!have_radii)
      return (pieces_[position]);
    else
      return with_type(pieces_[position], [&](const auto& piece) {
        return Thick(std::pair(piece, radii_[position]));
      });
  }

  Place feature_of(std::size_t position) const { return features_of_pieces_[position]; }

  // ---- what is inside ---------------------------------------------------------------------------

  std::size_t part_count() const { return parts_.size(); }
  const Part& part(std::size_t position) const { return parts_[position]; }

  std::size_t filled_count() const { return filled_.size(); }
  const Filled& filled(std::size_t position) const { return filled_[position]; }

  // The box of the first vertex of a part.
  Box box_of_part(std::size_t part) const
  {
    return with_kind(pieces_[parts_[part].piece], [](const auto& piece) {
      return bounding_box_of_vertex<Box>(piece, 0);
    });
  }

  const Box& box_of_filled(std::size_t position) const
  {
    return trees_.box(filled_[position].root);
  }

  // The piece that begins at the first vertex of a part.
  const Object& first_piece(std::size_t part) const { return pieces_[parts_[part].piece]; }

  // Returns whether the first vertex of a piece is inside a filled feature, or part of one. It is
  // not on its boundary.
  bool is_inside(const Object& piece, std::size_t position) const
  {
    const Filled& filled = filled_[position];
    return trees_.is_inside(piece, filled.root, filled.first_piece, filled.last_piece);
  }

  // ---- polygons ---------------------------------------------------------------------------------

  // The part of a segment. Most features have one.
  Place part_of(std::size_t segment) const
  {
    const std::size_t feature = feature_of(segment);
    auto first = parts_.begin() + first_parts_[feature];
    const auto last = feature + 1 == first_parts_.size()
                        ? parts_.end() : parts_.begin() + first_parts_[feature + 1];
    if(last - first > 1)
      first = std::upper_bound(first, last, segment, [](std::size_t position, const Part& part) {
                return position < part.piece;
              }) - 1;
    return static_cast<Place>(first - parts_.begin());
  }

  Place last_segment(std::size_t part) const
  {
    return part + 1 == parts_.size() ? piece_count() : parts_[part + 1].piece;
  }

  bool is_polygon(std::size_t part) const { return parts_[part].filled != none; }

  // As Ring_trees says, of the edges of a polygon.
  template <class Ray, class Function, class Done>
  bool is_inside_beside(const Ray& ray, std::size_t polygon, const Function& does_cross,
                        const Done& is_done) const
  {
    const Filled& filled = filled_[parts_[polygon].filled];
    return trees_.is_inside_beside(ray, filled.root, filled.first_piece, filled.last_piece,
                                   does_cross, is_done);
  }
  template <class Function>
  bool is_any_in_box(const Bbox_2& box, std::size_t polygon, const Function& is_wanted) const
  {
    const Filled& filled = filled_[parts_[polygon].filled];
    return trees_.is_any_in_box(box, filled.root, filled.first_piece, filled.last_piece,
                                is_wanted);
  }

  // ---- for Feature_reader -----------------------------------------------------------------------

  Place piece_count() const { return static_cast<Place>(pieces_.size()); }

  // Throws if there are too many.
  void check_count(const char* what, std::size_t count) const
  {
    if(count >= limit_)
      throw_too_many_features(what, limit_);
  }

  void begin_ring() { trees_.begin_ring(piece_count()); }

  void begin_part(Place piece)
  {
    check_count(parts_and_filled, parts_.size() + 1 + filled_.size());
    parts_.push_back({static_cast<Place>(feature_count_), piece, none});
  }

  // The parts and pieces from these on bound what is filled.
  void end_filled(std::size_t first_part, Place first)
  {
    for(std::size_t part = first_part; part != parts_.size(); ++part)
      parts_[part].filled = static_cast<Place>(filled_.size());
    const Place last = piece_count();
    filled_.push_back({static_cast<Place>(feature_count_), static_cast<Place>(first_part), first,
                       last, trees_.add_tree(first, last)});
    check_count(parts_and_filled, parts_.size() + filled_.size());
  }

  template <class Kind>
  void add_piece(const Kind& piece)
  {
    check_count("segments and faces of features", pieces_.size() + 1);
    pieces_.emplace_back(piece);
    settle(pieces_.back());
    features_of_pieces_.push_back(static_cast<Place>(feature_count_));
    if constexpr(have_radii)
      radii_.push_back(radius_);
  }

  // Pieces that are added have this radius, which is checked and settled.
  void set_radius([[maybe_unused]] const Any_radius& radius)
  {
    if constexpr(have_radii)
      radius_ = radius;
  }

private:
  static constexpr Place none = max_place;
  static constexpr const char* parts_and_filled
    = "parts of features, polygons and closed meshes";

  const std::size_t limit_;
  std::vector<Object> pieces_;
  std::vector<Any_radius> radii_; // of pieces, if features have radii
  std::vector<Place> features_of_pieces_;
  std::vector<Part> parts_;
  std::vector<Place> first_parts_; // of features
  std::vector<Filled> filled_;
  std::conditional_t<dimension == 2, Ring_trees<Object>, Solid_trees<Object>> trees_;
  std::size_t feature_count_ = 0;
  Any_radius radius_ = Any_radius(0);
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PIECES_H
