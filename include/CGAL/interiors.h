// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_INTERIORS_H
#define CGAL_INTERIORS_H

// Ranges whose objects are meant without their boundaries: they overlap, where closed ones touch.

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>

#include <iterator>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

marks a range whose objects are meant without their boundaries. `interiors()` makes it. It has the
iterators of the range.

\tparam Range is the type of the range, or a reference to it.
*/
template <class Range>
class Interiors
{
public:
  /// takes the range, or refers to it.
  explicit Interiors(Range&& range) : held_{std::forward<Range>(range)} {}

  /// returns the begin of the range.
  auto begin() const { return std::begin(held_.range); }

  /// returns the end of the range.
  auto end() const { return std::end(held_.range); }

#ifndef DOXYGEN_RUNNING
private:
  struct Held
  {
    Range range; // may be a reference, which cannot be mutable itself
  };
  mutable Held held_; // some views of C++20 can only be read if they are not const
#endif
};

/*!
\ingroup PkgThickIntersectionDRef

returns a range of the interiors of objects, which takes the place of a range in
`thick_self_intersection_d()`, `thick_intersection_d()`, `thick_feature_self_intersection_d()` and
`thick_feature_intersection_d()`: of the only range, of one of two, or of both.

Two objects without their boundaries intersect iff they overlap. Those that only touch do not. So
parcels that share a border are no pair, and neither are tiles of a floor. An object without its
boundary and a closed one intersect iff a point of the closed one is inside the other, and not on
its boundary.

\code{.cpp}
CGAL::thick_feature_self_intersection_d(CGAL::interiors(parcels), std::back_inserter(overlaps));
\endcode

Of features, polygons have an interior, and unions of polygons: the union of the interiors of their
members. `thick_feature_self_intersection_d()` says which points are in it.

\param range is a range of objects with an interior of full dimension. If the argument is an lvalue,
the result refers to it.
*/
template <class Range>
Interiors<Range> interiors(Range&& range)
{
  return Interiors<Range>(std::forward<Range>(range));
}

namespace Thick_intersection_d {
namespace internal {

template <class Range>
inline constexpr bool are_interiors_v<Interiors<Range>> = true;

} // namespace internal
} // namespace Thick_intersection_d

} // namespace CGAL

#endif // CGAL_INTERIORS_H
