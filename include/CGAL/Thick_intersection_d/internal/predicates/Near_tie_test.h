// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIE_TEST_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIE_TEST_H

// Decides the pairs that the filter does not, from coordinates that are doubles, whatever their
// type: in integers where the scene's grid allows it, and otherwise, but for exact ties, in doubles
// of twice the precision.

#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Twofold_filter.h>

#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Close_call
{
public:
  Close_call() = default; // decides nothing

  // For points of any coordinates of a type that a double holds.
  template <class Exact>
  Close_call(const Squared_bound<Exact>& bound, int dimension) : twofold_filter_(bound, dimension)
  {}

  // For the points of a scene, and no others. Decides nothing if the scene has no grid.
  template <class Exact>
  Close_call(const Squared_bound<Exact>& bound, const Scene_profile& profile)
  {
    if(!profile.has_grid())
      return;
    if(profile.tier() == Arithmetic_tier::INT64)
      in_64_bits_.emplace(bound, profile.units(), profile.grid_exponent());
    else if(profile.tier() == Arithmetic_tier::INT128)
      in_128_bits_.emplace(bound, profile.units(), profile.grid_exponent());
    else if(profile.tier() == Arithmetic_tier::FILTERED_EXACT)
      twofold_filter_ = Twofold_filter(bound, profile.dimension());
  }

  // Returns whether points with coordinates x(i) and y(i) are within the bound, or nothing if that
  // remains undecided.
  template <class X, class Y>
  std::optional<bool> decide(const X& x, const Y& y, int dimension, Decision_counts& counts) const
  {
    if(in_64_bits_) {
      counts.add(Arithmetic_tier::INT64);
      return in_64_bits_->holds_for(x, y, dimension);
    }
    if(in_128_bits_) {
      counts.add(Arithmetic_tier::INT128);
      return in_128_bits_->holds_for(x, y, dimension);
    }
    if(twofold_filter_.is_usable()) {
      const auto difference = [&](int i) { return twofold_sum(x(i), -y(i)); };
      if(const int sign = twofold_filter_.compare(difference, dimension)) {
        counts.add(Arithmetic_tier::DOUBLE);
        return sign < 0;
      }
    }
    return std::nullopt;
  }

private:
  std::optional<Grid_distance<std::uint64_t>> in_64_bits_;
  std::optional<Grid_distance<Uint128>> in_128_bits_;
  Twofold_filter twofold_filter_;
};

// Returns the one for points of any coordinates of type Number.
template <class Number, class Exact>
Close_call make_close_call(const Squared_bound<Exact>& bound, int dimension)
{
  if constexpr(is_held_by_double_v<Number>)
    return Close_call(bound, dimension);
  else
    return Close_call();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIE_TEST_H
