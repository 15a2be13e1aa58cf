// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_RANDOM_NUMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_RANDOM_NUMBERS_H

// Random numbers for samples, without <random>, which takes longer to compile than all headers of a
// search.

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The numbers of std::minstd_rand.
class Random_numbers
{
public:
  explicit Random_numbers(std::uint32_t seed = 1) : state_(seed % modulus)
  {
    if(state_ == 0)
      state_ = 1;
  }

  static constexpr std::uint32_t largest() { return modulus - 1; }

  // Returns a number from 1 to largest().
  std::uint32_t operator()()
  {
    state_ = static_cast<std::uint32_t>(std::uint64_t(state_) * 48271 % modulus);
    return state_;
  }

  // Returns a number below n, without a division.
  std::size_t below(std::size_t n)
  {
    return static_cast<std::size_t>((*this)() * std::uint64_t(n) >> 31);
  }

private:
  static constexpr std::uint32_t modulus = 2147483647;

  std::uint32_t state_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_RANDOM_NUMBERS_H
