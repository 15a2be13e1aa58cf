// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_INSIDES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_INSIDES_H

// The first vertices of parts, and polygons, as the box route reads them. They are a pair if the
// vertex is inside, and their features are none yet.
//
// This finds all pairs of parts of features whose boundaries do not meet.
//
// A polygon has one outer boundary, and its holes need not be asked. Let two parts
// have a point in common. They are connected, and so is the outer boundary of each. Assume that no
// vertex of an outer boundary is in the other part. Then neither outer boundary meets the other
// part, because it would have to cross the boundary of that part. So each part, which is connected
// and meets the other one, is inside the outer boundary of the other one. Then the rightmost point
// of each outer boundary is left of that of the other one, which cannot be. So an outer boundary
// has all of its vertices in the other part, or none: one vertex tells. A polyline is its own outer
// boundary.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The parts [first, last) of features, or the filled ones.
struct Part_range
{
  std::size_t first;
  std::size_t last;
};

// `Test` is like Pieces_intersect.
template <class Pieces, class Test>
class Feature_insides : public Objects_in_boxes<2>
{
public:
  // The vertices of some parts, and some polygons.
  Feature_insides(const Pieces& pieces, const Part_range& parts, const Part_range& filled,
                  const Test& test, Known_pairs& known)
    : pieces_(pieces), parts_(parts), filled_(filled), test_(test), known_(known)
  {}

  std::size_t point_count() const { return parts_.last - parts_.first; }
  std::size_t size() const { return point_count() + (filled_.last - filled_.first); }

  Place feature_of(std::size_t position) const
  {
    return position < point_count() ? pieces_.part(part_of(position)).feature
                                    : pieces_.filled(filled_of(position)).feature;
  }

  auto intervals(std::size_t position) const
  {
    return intervals_of(position < point_count() ? pieces_.box_of_part(part_of(position))
                                                 : pieces_.box_of_filled(filled_of(position)));
  }

  // What a feature has is a group.
  static constexpr bool may_have_groups = true;
  Place group_of(std::size_t position) const { return feature_of(position); }
  bool is_wanted(std::size_t i, std::size_t j) const
  {
    const Place a = feature_of(i), b = feature_of(j);
    return a != b && !known_.has(a, b);
  }

  // As that of Feature_boundaries.
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    const std::size_t point = (std::min)(i, j), filled = (std::max)(i, j);
    return test_.is_inside(pieces_, part_of(point), filled_of(filled))
           && known_.add(feature_of(point), feature_of(filled));
  }

private:
  std::size_t part_of(std::size_t point) const { return parts_.first + point; }
  std::size_t filled_of(std::size_t position) const
  {
    return filled_.first + (position - point_count());
  }

  const Pieces& pieces_;
  const Part_range parts_;
  const Part_range filled_;
  const Test& test_;
  Known_pairs& known_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_INSIDES_H
