// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_PRINT_PROFILE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_PRINT_PROFILE_H

// Prints what is known about a scene: one fact per line, and a sentence that sums it up.

#include <CGAL/Arithmetic_tier.h>

#include <cmath>
#include <ostream>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Profile` is Scene_profile.
template <class Profile>
void print_bits(std::ostream& out, const Profile& profile)
{
  out << "bits        ";
  if(!profile.is_of_objects())
    out << profile.bits() << " for a squared distance";
  else {
    out << std::ceil(profile.difference_bits()) << " for a difference";
    if(profile.degree() > 1)
      out << ", " << profile.bits() << " for a "
          << (profile.is_of_distances() ? "squared distance" : "determinant") << " of degree "
          << profile.degree();
  }
  out << ", a double has 53\n";
}

template <class Profile>
void print_coordinates(std::ostream& out, const Profile& profile)
{
  if(profile.coordinate_bits() == 64)
    out << "coordinates 64 bits, doubles\n";
  else if(profile.coordinate_bits() == 32)
    out << "coordinates 32 bits, "
        << (profile.are_coordinates_rounded() ? "rounded\n" : "exact\n");
}

template <class Profile>
void print_counts(std::ostream& out, const Profile& profile)
{
  const char* separator = "decided     ";
  for(const Arithmetic_tier tier :
      {Arithmetic_tier::DOUBLE, Arithmetic_tier::INT64, Arithmetic_tier::INT128,
       Arithmetic_tier::INT192, Arithmetic_tier::FILTERED_EXACT})
    if(profile.decided(tier) != 0) {
      out << separator << profile.decided(tier) << " by ";
      if(tier == Arithmetic_tier::FILTERED_EXACT)
        out << "exact numbers";
      else
        out << tier;
      separator = ", ";
    }
  if(*separator == ',')
    out << '\n';
}

inline const char* sentence_of(Arithmetic_tier tier)
{
  switch(tier) {
  case Arithmetic_tier::DOUBLE: return "double is exact, no filter used.";
  case Arithmetic_tier::INT64: return "doubles filter, 64-bit integers decide the rest.";
  case Arithmetic_tier::INT128: return "doubles filter, 128-bit integers decide the rest.";
  case Arithmetic_tier::INT192: return "doubles filter, 192-bit integers decide the rest.";
  default: return "doubles filter, exact numbers decide the rest.";
  }
}

template <class Profile>
std::ostream& print_profile(std::ostream& out, const Profile& profile)
{
  out << (profile.is_of_objects() ? "objects     " : "points      ") << profile.size()
      << " in dimension " << profile.dimension() << '\n';
  for(int i = 0; i < profile.dimension(); ++i)
    out << "axis " << i << "      [" << profile.range(i).first << ", " << profile.range(i).second
        << "]\n";
  out << "reach       " << profile.reach() << '\n';
  if(profile.has_grid()) {
    out << "grid        2^" << profile.grid_exponent() << '\n';
    print_bits(out, profile);
  }
  else
    out << "grid        none, the coordinates are not doubles\n";
  out << "arithmetic  " << profile.tier() << (profile.forced_tier() ? ", forced\n" : "\n");
  print_coordinates(out, profile);
  print_counts(out, profile);
  const double bits = std::ceil(profile.bits()); // infinite without a grid or a finite bound
  if(std::isfinite(bits))
    out << std::lround(bits) << " bits: ";
  return out << sentence_of(profile.tier()) << '\n';
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_PRINT_PROFILE_H
