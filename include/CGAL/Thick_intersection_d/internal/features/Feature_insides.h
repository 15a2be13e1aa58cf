// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_INSIDES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_INSIDES_H

// The first vertices of parts, and polygons, as the box route reads them. They are a pair if the
// vertex is inside the polygon, and their features are none yet.
//
// This finds all pairs of parts whose boundaries do not meet. Let two such parts have a point in
// common. They are connected, and so is the outer boundary of each. Assume that no vertex of an
// outer boundary is in the other part. Then neither outer boundary meets the other part, because it
// would have to cross the boundary of that part. So each part, which is connected and meets the
// other one, is inside the outer boundary of the other one. Then the rightmost point of each outer
// boundary is left of that of the other one, which cannot be. So an outer boundary has all of its
// vertices in the other part, or none: one vertex tells. A polyline is its own outer boundary.

#include <CGAL/Bbox_2.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/features/Known_pairs.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The parts [first, last) of features.
struct Part_range
{
  std::size_t first;
  std::size_t last;
};

// `Test` is like Segments_intersect.
template <class Segments, class Test>
class Feature_insides : public Objects_in_boxes
{
public:
  static constexpr int static_dimension = 2;

  // The vertices of some parts, and the polygons among others.
  Feature_insides(const Segments& segments, const Test& test, const Part_range& points,
                  const Part_range& parts, Known_pairs& known)
    : segments_(segments), test_(test), points_(points), known_(known)
  {
    for(std::size_t part = parts.first; part != parts.last; ++part)
      if(segments.is_polygon(part))
        polygons_.push_back(part);
  }

  std::size_t point_count() const { return points_.last - points_.first; }
  std::size_t size() const { return point_count() + polygons_.size(); }
  int dimension() const { return 2; }

  Place feature_of(std::size_t position) const { return segments_.part(part_of(position)).feature; }

  auto intervals(std::size_t position) const
  {
    return [box = box_at(position)](int axis) {
      return Interval{(box.min)(axis), (box.max)(axis)};
    };
  }


  // The vertices and polygons of a feature are a group.
  static constexpr bool have_groups = true;
  Place group_of(std::size_t position) const { return feature_of(position); }
  bool is_wanted(std::size_t i, std::size_t j) const
  {
    const Place a = feature_of(i), b = feature_of(j);
    return a != b && !known_.has(a, b);
  }

  // As that of Feature_boundaries.
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    const std::size_t point = (std::min)(i, j), polygon = (std::max)(i, j);
    return test_.is_inside(segments_, part_of(point), part_of(polygon))
           && known_.add(feature_of(point), feature_of(polygon));
  }

private:
  std::size_t part_of(std::size_t position) const
  {
    return position < point_count() ? points_.first + position
                                    : polygons_[position - point_count()];
  }

  Bbox_2 box_at(std::size_t position) const
  {
    const std::size_t part = part_of(position);
    if(position >= point_count())
      return segments_.box(part);
    return bounding_box_of_vertex<Bbox_2>(segments_[segments_.part(part).first_segment], 0);
  }

  const Segments& segments_;
  const Test& test_;
  const Part_range points_;
  std::vector<std::size_t> polygons_;
  Known_pairs& known_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_INSIDES_H
