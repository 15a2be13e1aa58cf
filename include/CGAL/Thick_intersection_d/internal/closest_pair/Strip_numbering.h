// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_STRIP_NUMBERING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_STRIP_NUMBERING_H

// Cells by comparisons: strips along an axis.

#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Numbers the strips of elements that come in order along an axis. A strip ends behind the last
// element within a distance of its first element. So elements within the distance are in one strip
// or in adjacent strips.
template <class Element, class Is_beyond>
class Strip_numbering
{
public:
  // is_beyond(b, a) returns whether b, which comes behind a, is beyond the distance from a.
  explicit Strip_numbering(const Is_beyond& is_beyond) : is_beyond_(is_beyond) {}

  // Returns the number of the strip of the next element. The first strip has number 1.
  Cell_number operator()(const Element& element)
  {
    if(number_ == 0 || is_beyond_(element, first_)) {
      ++number_;
      first_ = element;
    }
    return number_;
  }

private:
  Is_beyond is_beyond_;
  Element first_ = Element(); // the first element of the strip
  Cell_number number_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_STRIP_NUMBERING_H
