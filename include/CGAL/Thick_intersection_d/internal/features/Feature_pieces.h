// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PIECES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PIECES_H

// The pieces of the boundaries of features without meshes: the segments of polylines, and the edges
// of polygons. A feature has parts, each of which is a polyline or a polygon.

#include <CGAL/Bbox_2.h>

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Feature_reader.h>
#include <CGAL/Thick_intersection_d/internal/features/Halved_range.h>
#include <CGAL/Thick_intersection_d/internal/features/Ring_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Segment` is that of the points. `Radius` is the type of the radii by which features are
// thickened, or void if none has a radius.
template <class Segment_, class Radius = void>
class Feature_pieces
{
  using Any_radius = std::conditional_t<std::is_void_v<Radius>, int, Radius>;

public:
  using Segment = Segment_;
  using Point = Vertex_t<Segment>;
  static constexpr int dimension = vertex_dimension_v<Segment>;
  using Box = Bbox_of_dimension<dimension>;

  // A segment with its radius, as a search sees it.
  using Thick = typename Thick_piece<Segment, Radius>::type;
  static constexpr bool have_radii = !std::is_void_v<Radius>;

  struct Part
  {
    Place feature;
    Place piece;  // begins at the first vertex
    Place filled; // the polygon that the part is, or `none`
  };

  struct Filled
  {
    Place feature;
    Place part;
    Halved_range tree; // of its edges
  };

  // Takes less than `limit` features and segments, and parts and polygons together, which places
  // must number.
  explicit Feature_pieces(std::size_t limit = max_place / 2) : limit_(limit), trees_(pieces_) {}
  Feature_pieces(const Feature_pieces&) = delete; // the trees refer to the pieces
  Feature_pieces& operator=(const Feature_pieces&) = delete;

  // Reads features. Throws as Feature_reader does, or if there are too many.
  template <class Elements>
  void add_features(const Elements& features)
  {
    for(std::size_t position = 0; position < features.size(); ++position) {
      check_feature_count("features", first_parts_.size() + 1, limit_);
      first_parts_.push_back(static_cast<Place>(parts_.size()));
      Feature_reader<Feature_pieces> reader(*this, first_parts_.size() - 1);
      add_parts(features[position], reader);
    }
  }

  std::size_t feature_count() const { return first_parts_.size(); }
  std::size_t size() const { return pieces_.size(); }
  const Segment& operator[](std::size_t position) const { return pieces_[position]; }

  // Returns a segment with its radius, if features have radii.
  decltype(auto) thick(std::size_t position) const
  {
    if constexpr(!have_radii)
      return (pieces_[position]);
    else
      return Thick(pieces_[position], radii_[position]);
  }

  Place feature_of(std::size_t position) const { return features_of_pieces_[position]; }

  // ---- what is inside ---------------------------------------------------------------------------

  std::size_t part_count() const { return parts_.size(); }
  const Part& part(std::size_t position) const { return parts_[position]; }

  std::size_t filled_count() const { return filled_.size(); }
  const Filled& filled(std::size_t position) const { return filled_[position]; }

  // How many pieces, parts and polygons the features before a position have.
  std::size_t first_piece_from(std::size_t feature) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(features_of_pieces_.begin(), features_of_pieces_.end(), feature)
      - features_of_pieces_.begin());
  }
  std::size_t first_part_from(std::size_t feature) const
  {
    return feature == feature_count() ? part_count() : first_parts_[feature];
  }
  std::size_t first_filled_from(std::size_t feature) const
  {
    return static_cast<std::size_t>(
      std::count_if(filled_.begin(), filled_.end(),
                    [=](const Filled& filled) { return filled.feature < feature; }));
  }

  // The box of the first vertex of a part.
  Box box_of_part(std::size_t part) const
  {
    return bounding_box_of_vertex<Box>(first_piece(part), 0);
  }

  const Box& box_of_filled(std::size_t position) const
  {
    return trees_.box(filled_[position].tree);
  }

  // The piece that begins at the first vertex of a part.
  const Segment& first_piece(std::size_t part) const { return pieces_[parts_[part].piece]; }

  // Returns whether the first vertex of a piece is inside a polygon. It is not on its boundary.
  bool is_inside(const Segment& piece, std::size_t position) const
  {
    return trees_.is_inside(piece, filled_[position].tree);
  }

  // ---- polygons ---------------------------------------------------------------------------------

  // The part of a segment. Most features have one.
  Place part_of(std::size_t segment) const
  {
    const std::size_t feature = feature_of(segment);
    auto first = parts_.begin() + first_parts_[feature];
    const auto last = parts_.begin() + first_part_from(feature + 1);
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

  // Returns whether a point next to the first vertex of `ray` is inside a polygon: at a small
  // distance to the right, and above by a smaller distance. The functions are those of Ring_trees.
  // Edges at the vertex are not crossed: behind the point, or at the vertex only.
  template <class Ray, class Function, class Done>
  bool is_inside_beside(const Ray& ray, std::size_t polygon, const Function& does_cross,
                        const Done& is_done) const
  {
    return trees_.is_crossed_odd(ray, tree_of(polygon), does_cross, is_done);
  }

  // As Ring_trees says, of the edges of a polygon.
  template <class Function>
  bool is_any_in_box(const Bbox_2& box, std::size_t polygon, const Function& is_wanted) const
  {
    return trees_.is_any_in_box(box, tree_of(polygon), is_wanted);
  }

  // ---- for Feature_reader -----------------------------------------------------------------------

  void begin_ring() { trees_.begin_ring(piece_count()); }

  void begin_part()
  {
    check_feature_count(parts_and_polygons, parts_.size() + 1 + filled_.size(), limit_);
    parts_.push_back({last_feature(), piece_count(), none});
  }

  // The last part is a polygon.
  void end_polygon()
  {
    Part& part = parts_.back();
    part.filled = static_cast<Place>(filled_.size());
    filled_.push_back({part.feature, static_cast<Place>(parts_.size() - 1),
                       trees_.add_tree(part.piece, piece_count())});
    check_feature_count(parts_and_polygons, parts_.size() + filled_.size(), limit_);
  }

  void add_segment(const Segment& segment)
  {
    check_feature_count("segments and faces of features", pieces_.size() + 1, limit_);
    pieces_.push_back(segment);
    settle(pieces_.back());
    features_of_pieces_.push_back(last_feature());
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
  static constexpr const char* parts_and_polygons
    = "parts of features, polygons and closed meshes";

  Place piece_count() const { return static_cast<Place>(pieces_.size()); }
  Place last_feature() const { return static_cast<Place>(first_parts_.size() - 1); }
  const Halved_range& tree_of(std::size_t polygon) const
  {
    return filled_[parts_[polygon].filled].tree;
  }

  const std::size_t limit_;
  std::vector<Segment> pieces_;
  std::vector<Any_radius> radii_; // of pieces, if features have radii
  std::vector<Place> features_of_pieces_;
  std::vector<Part> parts_;
  std::vector<Place> first_parts_; // of features
  std::vector<Filled> filled_;
  Ring_trees<Segment> trees_; // of polygons
  Any_radius radius_ = Any_radius(0);
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_PIECES_H
