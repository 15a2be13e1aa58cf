// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_READER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_READER_H

// Reads a feature of the user into pieces, as add_parts() hands over its parts.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/mesh_faces.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Pieces` are Feature_pieces or Solid_pieces. Throws if a coordinate is NaN or infinite, if a
// polygon has no outer boundary, or if a face is no triangle.
template <class Pieces>
class Feature_reader
{
  using Point = typename Pieces::Point;
  using Segment = typename Pieces::Segment;

public:
  // Reads the feature at a position.
  Feature_reader(Pieces& pieces, std::size_t feature) : pieces_(pieces), feature_(feature) {}

  template <class Iterator, class Sentinel>
  void add_polyline(Iterator first, Sentinel last)
  {
    if(first != last) {
      pieces_.begin_part();
      add_chain(first, last, false);
    }
  }

  template <class Polygon>
  void add_polygon(const Polygon& polygon)
  {
    if(polygon.is_empty())
      return;
    pieces_.begin_part();
    add_ring(polygon);
    pieces_.end_polygon();
  }

  template <class Polygon>
  void add_polygon_with_holes(const Polygon& polygon)
  {
    if(polygon.is_unbounded())
      throw std::invalid_argument("Feature " + std::to_string(feature_)
                                  + " has no outer boundary.");
    pieces_.begin_part();
    add_ring(polygon.outer_boundary());
    for(auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      if(!hole->is_empty())
        add_ring(*hole);
    pieces_.end_polygon();
  }

  // Does not check the faces.
  template <class Mesh>
  void add_mesh(const Mesh& mesh)
  {
    for_each_face(mesh, feature_, [&](const Point& p, const Point& q, const Point& r) {
      pieces_.add_face(p, q, r);
    });
  }

  // Throws if the radius is negative, NaN or infinite.
  template <class NT>
  void begin_thick(const NT& radius)
  {
    check_feature_radius(radius, feature_);
    if constexpr(Is_lazy<NT>::value)
      CGAL::exact(radius);
    pieces_.set_radius(radius);
  }

  void end_thick() { pieces_.set_radius(0); }

private:
  template <class Polygon>
  void add_ring(const Polygon& ring)
  {
    pieces_.begin_ring();
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
      pieces_.add_segment(Segment(previous, next));
      previous = next;
    }
    if(is_closed)
      pieces_.add_segment(Segment(previous, first));
  }

  const Point& checked(const Point& point) const
  {
    check_vertex(point, feature_);
    return point;
  }

  Pieces& pieces_;
  const std::size_t feature_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_READER_H
