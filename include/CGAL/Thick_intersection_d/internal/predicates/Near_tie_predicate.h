// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIE_PREDICATE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIE_PREDICATE_H

// Decides most near ties without the number type of the points. Integers decide all of them where
// the grid of the scene allows it. Elsewhere doubles of twice the precision decide all near ties
// except exact ties.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Scaled_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Twofold_filter.h>

#include <cstdint>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Near_tie_predicate
{
public:
  Near_tie_predicate() = default; // decides nothing

  // For points of any coordinates, if doubles hold their type.
  template <class Exact>
  CGAL_RARELY_CALLED Near_tie_predicate(const Squared_bound<Exact>& bound, int dimension)
    : twofold_(bound, dimension), scaled_(bound, dimension)
  {}

  // For the points of a scene, and no other points. Decides nothing if the scene has no grid.
  template <class Exact>
  CGAL_RARELY_CALLED
  Near_tie_predicate(const Squared_bound<Exact>& bound, const Scene& scene, Arithmetic_tier tier)
  {
    if(!scene.grid_exponent)
      return;
    if(tier == Arithmetic_tier::INT64)
      in_64_bits_.emplace(bound, *scene.grid_exponent);
    else if(tier == Arithmetic_tier::INT128)
      in_128_bits_.emplace(bound, *scene.grid_exponent);
    else if(tier == Arithmetic_tier::FILTERED_EXACT) {
      twofold_ = Twofold_filter(bound, scene.dimension());
      scaled_ = Scaled_filter(bound, scene.dimension());
    }
  }

  // Returns whether points with coordinates x(i) and y(i) are within the bound. Returns nothing if
  // this remains undecided.
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
    if(twofold_.is_usable()) {
      const auto difference = [&](int i) { return twofold_sum(x(i), -y(i)); };
      if(const int sign = twofold_.compare(difference, dimension)) {
        counts.add(Arithmetic_tier::DOUBLE);
        return sign < 0;
      }
    }
    const std::optional<bool> is_within = scaled_.decide(x, y, dimension);
    if(is_within)
      counts.add(Arithmetic_tier::DOUBLE);
    return is_within;
  }

private:
  std::optional<Integer_distance<std::uint64_t>> in_64_bits_;
  std::optional<Integer_distance<Uint128>> in_128_bits_;
  Twofold_filter twofold_;
  Scaled_filter scaled_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIE_PREDICATE_H
