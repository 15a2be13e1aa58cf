// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DISTANCE_BOUND_H
#define CGAL_DISTANCE_BOUND_H

// What "near" means: a distance or a squared distance, closed or open, exactly as the user gave it.

#include <CGAL/Algebraic_structure_traits.h>

namespace CGAL {

namespace Thick_intersection_d {
namespace internal {

// The number type of an expression, which the expression templates of GMP and Boost hide.
template <class NT>
using Number_t = typename Algebraic_structure_traits<NT>::Type;

} // namespace internal
} // namespace Thick_intersection_d

/*!
\ingroup PkgThickIntersectionDRef

states which distances count as near: those of at most \f$ r \f$, or, if open, those less than
\f$ r \f$. A bound is made by `within_distance()` or `within_squared_distance()`, and holds the
number it was given: nothing is squared, rooted or rounded when it is made. The functions that take
a bound evaluate it exactly, so that \f$ r = 0.1 \f$ given as a `double` means the value of that
`double`, and given as an exact rational means one tenth.

An infinite bound holds for every pair of points. A negative bound or NaN is refused by the
functions that take it, with `std::invalid_argument`.

Objects of this type may be read by several threads at once if `NT` may.

\tparam NT is a built-in number type, an exact number type of \cgal, or another number type whose
values are rational numbers (`Gmpq`, `Lazy_exact_nt`, `Quotient`, Boost.Multiprecision, ...).

\sa `fixed_radius_near_neighbors()`
*/
template <class NT>
class Distance_bound
{
public:
  /// constructs the closed bound `value` on the distance, or on its square if `squared`.
  Distance_bound(const NT& value, bool squared, bool open = false)
    : value_(value), squared_(squared), open_(open)
  {}

  /// returns the number that was given, in the unit of the coordinates, or in its square.
  const NT& value() const { return value_; }

  /// returns whether `value()` bounds the squared distance.
  bool is_squared() const { return squared_; }

  /// returns whether the bound is strict: "closer than" instead of "at most".
  bool is_open() const { return open_; }

  /// returns the strict version of this bound.
  Distance_bound open() const { return Distance_bound(value_, squared_, true); }

private:
  NT value_;
  bool squared_;
  bool open_;
};

/*!
\ingroup PkgThickIntersectionDRef

returns the bound \f$ |pq| \leq r \f$, with \f$ r \f$ exactly as given: its square is never rounded.
*/
template <class NT>
auto within_distance(const NT& r)
{
  return Distance_bound<Thick_intersection_d::internal::Number_t<NT>>(r, false);
}

/*!
\ingroup PkgThickIntersectionDRef

returns the bound \f$ |pq|^2 \leq r_2 \f$, for radii that are known by their square, such as
\f$ \sqrt{13} \f$: no root is taken.
*/
template <class NT>
auto within_squared_distance(const NT& r2)
{
  return Distance_bound<Thick_intersection_d::internal::Number_t<NT>>(r2, true);
}

} // namespace CGAL

#endif // CGAL_DISTANCE_BOUND_H
