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

// The number type of an expression. Expression templates of GMP and Boost hide this type.
template <class NT>
using Number_t = typename Algebraic_structure_traits<NT>::Type;

} // namespace internal
} // namespace Thick_intersection_d

/*!
\ingroup PkgThickIntersectionDRef

states which distances count as near: distances of at most \f$ r \f$, or less than \f$ r \f$ if the
bound is open. `within_distance()` and `within_squared_distance()` make bounds. A bound holds the
number that it was given. Making a bound takes no square, no root and no rounding. The functions
that take a bound evaluate it exactly: \f$ r = 0.1 \f$ given as a `double` means the value of that
`double`, and given as an exact rational it means one tenth.

An infinite bound holds for every pair of points. The functions that take a bound refuse a negative
bound or NaN with `std::invalid_argument`.

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

  /// returns the number that was given, in the unit of the coordinates or in the squared unit.
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

returns the bound \f$ |pq| \leq r \f$, with \f$ r \f$ exactly as given. The square of \f$ r \f$ is
never rounded.
*/
template <class NT>
auto within_distance(const NT& r)
{
  return Distance_bound<Thick_intersection_d::internal::Number_t<NT>>(r, false);
}

/*!
\ingroup PkgThickIntersectionDRef

returns the bound \f$ |pq|^2 \leq r_2 \f$, for radii that are known by their square, such as
\f$ \sqrt{13} \f$. The function takes no root.
*/
template <class NT>
auto within_squared_distance(const NT& r2)
{
  return Distance_bound<Thick_intersection_d::internal::Number_t<NT>>(r2, true);
}

} // namespace CGAL

#endif // CGAL_DISTANCE_BOUND_H
