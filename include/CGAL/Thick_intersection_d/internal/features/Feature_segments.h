// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_SEGMENTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_SEGMENTS_H

// The segments of features: those of polylines, and the edges of polygons. A feature has parts,
// each of which is a polyline or a polygon.

#include <CGAL/Bbox_2.h>
#include <CGAL/Dimension.h>
#include <CGAL/Kernel_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Ring_trees.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Feature_segments
{
  using Kernel = typename Kernel_traits<Point>::Kernel;

public:
  static constexpr int dimension = Ambient_dimension<Point>::value;
  using Segment = std::conditional_t<dimension == 2, typename Kernel::Segment_2,
                                     typename Kernel::Segment_3>;

  struct Part
  {
    Place feature;
    Place first_segment;
    Place root; // of the tree of its rings, or no_tree
  };

  // Takes less than `limit` features and segments, and parts and polygons together, which places
  // must number.
  explicit Feature_segments(std::size_t limit = max_place / 2) : limit_(limit), trees_(segments_) {}
  Feature_segments(const Feature_segments&) = delete; // the trees refer to the segments
  Feature_segments& operator=(const Feature_segments&) = delete;

  // Reads the features of a range. Throws if a coordinate is NaN or infinite, if a polygon has no
  // outer boundary, or if there are too many of them.
  template <class Elements>
  void add_features(const Elements& features)
  {
    for(std::size_t position = 0; position < features.size(); ++position) {
      check_count("features", feature_count_ + 1);
      first_parts_.push_back(static_cast<Place>(parts_.size()));
      add_parts(features[position], *this);
      ++feature_count_;
    }
  }

  std::size_t feature_count() const { return feature_count_; }
  std::size_t part_count() const { return parts_.size(); }
  std::size_t size() const { return segments_.size(); }
  const Segment& operator[](std::size_t position) const { return segments_[position]; }

  Place feature_of(std::size_t position) const { return features_of_segments_[position]; }

  // ---- parts ------------------------------------------------------------------------------------

  const Part& part(std::size_t position) const { return parts_[position]; }

  std::size_t polygon_count() const { return polygon_count_; }
  bool is_polygon(std::size_t part) const { return parts_[part].root != no_tree; }

  // The box of a polygon.
  const Bbox_2& box(std::size_t polygon) const { return trees_.box(parts_[polygon].root); }

  // The part of a segment. Most features have one.
  Place part_of(std::size_t segment) const
  {
    const std::size_t feature = feature_of(segment);
    auto first = parts_.begin() + first_parts_[feature];
    const auto last = feature + 1 == first_parts_.size()
                        ? parts_.end() : parts_.begin() + first_parts_[feature + 1];
    if(last - first > 1)
      first = std::upper_bound(first, last, segment, [](std::size_t position, const Part& part) {
                return position < part.first_segment;
              }) - 1;
    return static_cast<Place>(first - parts_.begin());
  }

  Place last_segment(std::size_t part) const
  {
    return part + 1 == parts_.size() ? segment_count() : parts_[part + 1].first_segment;
  }

  // Returns whether the first vertex of a part is inside a polygon. Their boundaries do not meet.
  bool is_inside(std::size_t part, std::size_t polygon) const
  {
    return trees_.is_inside(segments_[parts_[part].first_segment], parts_[polygon].root,
                            parts_[polygon].first_segment, last_segment(polygon));
  }

  // As Ring_trees says, of the edges of a polygon.
  template <class Ray, class Function, class Done>
  bool is_inside_beside(const Ray& ray, std::size_t polygon, const Function& does_cross,
                        const Done& is_done) const
  {
    return trees_.is_inside_beside(ray, parts_[polygon].root, parts_[polygon].first_segment,
                                   last_segment(polygon), does_cross, is_done);
  }
  template <class Function>
  bool is_any_in_box(const Bbox_2& box, std::size_t polygon, const Function& is_wanted) const
  {
    return trees_.is_any_in_box(box, parts_[polygon].root, parts_[polygon].first_segment,
                                last_segment(polygon), is_wanted);
  }

  // ---- for add_parts() --------------------------------------------------------------------------

  template <class Iterator, class Sentinel>
  void add_polyline(Iterator first, Sentinel last)
  {
    if(first != last) {
      begin_part();
      add_chain(first, last, false);
    }
  }

  template <class Polygon>
  void add_polygon(const Polygon& polygon)
  {
    if(polygon.is_empty())
      return;
    begin_part();
    add_ring(polygon);
    end_polygon();
  }

  template <class Polygon>
  void add_polygon_with_holes(const Polygon& polygon)
  {
    if(polygon.is_unbounded())
      throw std::invalid_argument("Feature " + std::to_string(feature_count_)
                                  + " has no outer boundary.");
    begin_part();
    add_ring(polygon.outer_boundary());
    for(auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      if(!hole->is_empty())
        add_ring(*hole);
    end_polygon();
  }

private:
  static constexpr Place no_tree = max_place;

  void begin_part()
  {
    check_count("parts of features and polygons", parts_.size() + 1 + polygon_count_);
    parts_.push_back({static_cast<Place>(feature_count_), segment_count(), no_tree});
  }

  void end_polygon()
  {
    if constexpr(dimension == 2)
      parts_.back().root = trees_.add_tree(parts_.back().first_segment, segment_count());
    ++polygon_count_;
    check_count("parts of features and polygons", parts_.size() + polygon_count_);
  }

  template <class Polygon>
  void add_ring(const Polygon& ring)
  {
    if constexpr(dimension == 2)
      trees_.begin_ring(segment_count());
    add_chain(ring.vertices_begin(), ring.vertices_end(), true);
  }

  // Adds the segments between consecutive points. One point is a segment of length zero.
  template <class Iterator, class Sentinel>
  void add_chain(Iterator point, Sentinel last, bool is_closed)
  {
    const Point first = checked(*point);
    Point previous = first;
    if(++point == last)
      is_closed = true;
    for(; point != last; ++point) {
      const Point next = checked(*point);
      add_segment(previous, next);
      previous = next;
    }
    if(is_closed)
      add_segment(previous, first);
  }

  void add_segment(const Point& source, const Point& target)
  {
    check_count("segments of features", segments_.size() + 1);
    segments_.emplace_back(source, target);
    settle(segments_.back());
    features_of_segments_.push_back(parts_.back().feature);
  }

  void check_count(const char* what, std::size_t count) const
  {
    if(count >= limit_)
      throw_too_many(what);
  }

  [[noreturn]] void throw_too_many(const char* what) const
  {
    std::string message("There are too many ");
    message.append(what).append(": ").append(std::to_string(limit_)).append(" or more.");
    throw std::length_error(message);
  }

  // Throws if a coordinate is NaN or infinite.
  const Point& checked(const Point& point) const
  {
    for(int i = 0; i < dimension; ++i)
      if(!are_bounds_of_finite(coordinate_bounds(point, i)))
        throw_not_finite("vertex of feature", feature_count_, i);
    return point;
  }

  Place segment_count() const { return static_cast<Place>(segments_.size()); }

  const std::size_t limit_;
  std::vector<Segment> segments_;
  std::vector<Place> features_of_segments_;
  std::vector<Part> parts_;
  std::vector<Place> first_parts_; // of features
  Ring_trees<Segment> trees_;
  std::size_t feature_count_ = 0;
  std::size_t polygon_count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_SEGMENTS_H
