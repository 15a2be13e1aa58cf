// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_LATTICE_BASIS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_LATTICE_BASIS_H

// A basis of short vectors of the lattice that periods span. Periods may be long and nearly
// parallel; then many of their multiples would have to be tried to find the images of a point that
// are near. Short vectors are made of them by integer steps, so they span the same lattice.
//
// Each vector has a dual vector: the inner product of a point with it is how many times the vector
// goes into the point. Exact rationals compute all of this, once per search.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Offsets have fewer than 2^30 periods, so that differences of offsets are integers.
inline constexpr double max_offset = 0x1p30;

template <int Dimension>
class Lattice_basis
{
  using Vector = std::array<Exact_rational, Dimension>;

public:
  // Throws if the periods are linearly dependent.
  template <class Lattice>
  explicit Lattice_basis(const Lattice& lattice)
  {
    for(int k = 0; k < Dimension; ++k)
      if(lattice.repeats(k)) {
        Vector vector;
        for(int axis = 0; axis < Dimension; ++axis)
          vector[axis] = to_exact_rational(lattice.ends(k, axis).second)
                         - to_exact_rational(lattice.ends(k, axis).first);
        vectors_.push_back(vector);
        steps_.push_back({});
        steps_.back()[k] = 1;
      }
    set_duals(); // which finds dependent vectors
    while(shorten())
      set_duals();
  }

  // The number of vectors.
  int rank() const { return static_cast<int>(vectors_.size()); }

  const Vector& vector(int k) const { return vectors_[k]; }
  const Vector& dual(int k) const { return duals_[k]; }

  // How many times each period goes into a vector.
  const std::array<std::int64_t, Dimension>& steps(int k) const { return steps_[k]; }

private:
  // Subtracts multiples of vectors from others that become shorter by it. Returns whether one did.
  // Three vectors of which none is shortened by another one may still nearly cancel, as in a plane
  // at 120 degrees. So the sums of all three are tried as well.
  bool shorten()
  {
    bool is_shorter = false;
    for(int k = 0; k < rank(); ++k)
      for(int l = 0; l < rank(); ++l)
        is_shorter = (k != l && shorten_by(k, l)) || is_shorter;
    if(rank() == 3)
      for(int k = 0; k < 3; ++k)
        for(const int sign : {-1, 1})
          for(const int other_sign : {-1, 1})
            is_shorter = shorten_by_both(k, sign, other_sign) || is_shorter;
    return is_shorter;
  }

  bool shorten_by(int k, int l)
  {
    const double ratio = CGAL::to_double(Exact_rational(
      dot_product(vectors_[k], vectors_[l]) / dot_product(vectors_[l], vectors_[l])));
    const double multiple = std::nearbyint(ratio);
    if(multiple == 0)
      return false;
    Vector shorter = vectors_[k];
    if(std::fabs(multiple) < max_offset)
      subtract(shorter, vectors_[l], Exact_rational(multiple));
    if(!(dot_product(shorter, shorter) < dot_product(vectors_[k], vectors_[k])))
      return false;
    subtract_steps(k, l, static_cast<std::int64_t>(multiple));
    vectors_[k] = shorter;
    return true;
  }

  // Subtracts the two other vectors, times signs, if this makes vector k shorter.
  bool shorten_by_both(int k, int sign, int other_sign)
  {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    Vector shorter = vectors_[k];
    subtract(shorter, vectors_[l], Exact_rational(sign));
    subtract(shorter, vectors_[m], Exact_rational(other_sign));
    if(!(dot_product(shorter, shorter) < dot_product(vectors_[k], vectors_[k])))
      return false;
    subtract_steps(k, l, sign);
    subtract_steps(k, m, other_sign);
    vectors_[k] = shorter;
    return true;
  }

  void subtract_steps(int k, int l, std::int64_t multiple)
  {
    for(int i = 0; i < Dimension; ++i) {
      steps_[k][i] -= multiple * steps_[l][i];
      if(std::fabs(static_cast<double>(steps_[k][i])) >= max_offset)
        throw std::length_error("The periods of the lattice are too nearly parallel.");
    }
  }

  static void subtract(Vector& v, const Vector& w, const Exact_rational& multiple)
  {
    for(int axis = 0; axis < Dimension; ++axis)
      v[axis] -= multiple * w[axis];
  }

  // Solves by elimination: a dual vector has the product 1 with its vector, and 0 with the others,
  // and is a sum of multiples of the vectors.
  void set_duals()
  {
    const int n = rank();
    std::vector<std::vector<Exact_rational>> products(n, std::vector<Exact_rational>(n));
    for(int k = 0; k < n; ++k)
      for(int l = 0; l < n; ++l)
        products[k][l] = dot_product(vectors_[k], vectors_[l]);
    duals_ = vectors_;
    for(int k = 0; k < n; ++k) { // the products are of full rank only if no diagonal entry is zero
      if(products[k][k] == 0)
        throw std::invalid_argument("The periods of the lattice are linearly dependent.");
      const Exact_rational pivot = products[k][k];
      for(int l = 0; l < n; ++l)
        products[k][l] /= pivot;
      for(Exact_rational& x : duals_[k])
        x /= pivot;
      for(int row = 0; row < n; ++row)
        if(row != k) {
          const Exact_rational multiple = products[row][k];
          for(int l = 0; l < n; ++l)
            products[row][l] -= multiple * products[k][l];
          subtract(duals_[row], duals_[k], multiple);
        }
    }
  }

  std::vector<Vector> vectors_;
  std::vector<Vector> duals_;
  std::vector<std::array<std::int64_t, Dimension>> steps_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_LATTICE_BASIS_H
