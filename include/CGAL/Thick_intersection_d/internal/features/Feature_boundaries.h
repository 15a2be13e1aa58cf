// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_BOUNDARIES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_BOUNDARIES_H

// The pieces of the boundaries of features, as the box route reads them: two of them are a pair if
// they tell that their features are one, and no others have told it before.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/reports/Known_pairs.h>

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Test` is like Pieces_intersect.
template <class Pieces, class Test>
class Feature_boundaries : public Objects_in_boxes<Pieces::dimension>
{
public:
  Feature_boundaries(const Pieces& pieces, const Test& test, Known_pairs& known)
    : pieces_(pieces), test_(test), known_(known)
  {}

  std::size_t size() const { return pieces_.size(); }

  auto intervals(std::size_t position) const
  {
    return [this, box = bounding_box(pieces_.thick(position))](int axis) {
      return test_.grown({(box.min)(axis), (box.max)(axis)});
    };
  }

  void prefetch(std::size_t position) const { prefetch_to_read(&pieces_[position]); }

  // The pieces of a feature are a group. To look for a pair takes less time than most tests do.
  static constexpr bool may_have_groups = true;
  Place group_of(std::size_t position) const { return pieces_.feature_of(position); }
  bool is_wanted(std::size_t i, std::size_t j) const
  {
    const Place a = pieces_.feature_of(i), b = pieces_.feature_of(j);
    return a != b && !known_.has(a, b);
  }

  // Several threads ask at once. For them, this object is constant, but what is known is not: it
  // is outside, and grows by the answers.
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    return test_.do_meet(pieces_, i, j)
           && known_.add(pieces_.feature_of(i), pieces_.feature_of(j));
  }

private:
  const Pieces& pieces_;
  const Test& test_;
  Known_pairs& known_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_FEATURE_BOUNDARIES_H
