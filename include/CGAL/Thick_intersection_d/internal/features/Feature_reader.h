// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_READER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_READER_H

// Reads a feature of the user into pieces, as add_parts() hands over its parts.

#include <CGAL/Kernel_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/features/Mesh_shape.h>
#include <CGAL/Thick_intersection_d/internal/features/check_features.h>
#include <CGAL/Thick_intersection_d/internal/features/feature_kinds.h>
#include <CGAL/Thick_intersection_d/internal/features/mesh_faces.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Pieces` are Feature_pieces, and `Where` is like Everywhere. Throws if a coordinate is NaN or
// infinite, if a polygon has no outer boundary, if a face is no triangle, or if there are too many
// pieces.
template <class Pieces, class Where>
class Feature_reader
{
  using Point = Piece_point<typename Pieces::value_type>;
  using Segment = typename Pieces::Segment;

public:
  // Reads the next feature.
  Feature_reader(Pieces& pieces, const Where& where) : pieces_(pieces), where_(where) {}

  template <class Iterator, class Sentinel>
  void add_polyline(Iterator first, Sentinel last)
  {
    if(first != last) {
      pieces_.begin_part(pieces_.piece_count());
      add_chain(first, last, false);
    }
  }

  template <class Polygon>
  void add_polygon(const Polygon& polygon)
  {
    if(polygon.is_empty())
      return;
    const Place first = pieces_.piece_count();
    pieces_.begin_part(first);
    add_ring(polygon);
    pieces_.end_filled(pieces_.part_count() - 1, first);
  }

  template <class Polygon>
  void add_polygon_with_holes(const Polygon& polygon)
  {
    if(polygon.is_unbounded())
      throw std::invalid_argument("Feature " + std::to_string(pieces_.feature_count())
                                  + " has no outer boundary.");
    const Place first = pieces_.piece_count();
    pieces_.begin_part(first);
    add_ring(polygon.outer_boundary());
    for(auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      if(!hole->is_empty())
        add_ring(*hole);
    pieces_.end_filled(pieces_.part_count() - 1, first);
  }

  // A component of the faces has a part unless it goes on where it is not inside another feature.
  // If all faces are taken, closed ones are filled.
  template <class Mesh>
  void add_mesh(const Mesh& mesh)
  {
    const std::size_t feature = pieces_.feature_count();
    const Place first = pieces_.piece_count();
    add_faces(mesh, feature);
    const std::size_t count = pieces_.size() - first;
    if(count == 0)
      return;
    pieces_.check_count("vertices of the faces of a mesh", 3 * count);
    const auto face_at
      = [&](std::size_t i) -> const auto& { return as_face(pieces_[first + i]); };
    const std::size_t first_part = pieces_.part_count();
    const Mesh_shape shape(count, face_at);
    shape.for_each_component(
      [&](std::size_t i) { return where_.is_beyond(feature, face_at(i)); },
      [&](std::size_t i) { pieces_.begin_part(static_cast<Place>(first + i)); });
    if(Where::takes_all && shape.is_closed())
      pieces_.end_filled(first_part, first);
  }

  // Throws if the radius is negative, NaN or infinite.
  template <class NT>
  void begin_thick(const NT& radius)
  {
    if(!is_radius(radius))
      throw std::invalid_argument("The radius of feature "
                                  + std::to_string(pieces_.feature_count())
                                  + " is negative, NaN or infinite.");
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
      pieces_.add_piece(Segment(previous, next));
      previous = next;
    }
    if(is_closed)
      pieces_.add_piece(Segment(previous, first));
  }

  template <class Mesh>
  void add_faces(const Mesh& mesh, std::size_t feature)
  {
    std::size_t face = 0;
    for_each_face(mesh, feature, [&](const Point& p, const Point& q, const Point& r) {
      check_face(face++, feature, p, q, r);
      if(where_.takes_face(feature, p, q, r))
        pieces_.add_piece(typename Kernel_traits<Point>::Kernel::Triangle_3(p, q, r));
    });
  }

  const Point& checked(const Point& point) const
  {
    check_vertex(point, pieces_.feature_count());
    return point;
  }

  Pieces& pieces_;
  const Where& where_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_READER_H
