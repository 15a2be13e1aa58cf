// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SCENE_PROFILE_H
#define CGAL_SCENE_PROFILE_H

// What a scene of points and a distance bound need: one pass over the coordinates tells which
// arithmetic decides every pair exactly.

#include <CGAL/Distance_bound.h>
#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/Coordinate_scan.h>
#include <CGAL/Thick_intersection_d/internal/Elements.h>
#include <CGAL/Thick_intersection_d/internal/Squared_bound.h>

#include <optional>
#include <ostream>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

names the arithmetic that decides whether a pair of points is within a bound. The answer is the
exact one in each case.
*/
enum class Arithmetic_tier {
  DOUBLE,          ///< Doubles compute all squared distances near the bound without rounding.
  FILTERED_EXACT   ///< Doubles decide what they safely can, exact numbers decide the rest.
};

/// \ingroup PkgThickIntersectionDRef
/// prints `tier` in words.
inline std::ostream& operator<<(std::ostream& out, Arithmetic_tier tier)
{
  return out << (tier == Arithmetic_tier::DOUBLE ? "double" : "filter + exact");
}

/*!
\ingroup PkgThickIntersectionDRef

describes a scene of points together with a distance bound: its size and extent, the coarsest grid
that holds its coordinates, and the arithmetic that the scene needs.

All coordinates that are doubles lie on a grid of step \f$ 2^e \f$. A difference of coordinates that
is at most the reach is a number of at most `units()` steps, whatever the offset of the scene. If
\f$ d \f$ times the square of that number is at most \f$ 2^{53} \f$ then doubles evaluate squared
distances up to the bound without error, and larger ones come out larger than the bound: neither a
filter nor exact numbers are needed.

A profile is made by `profile_scene()`, and does not refer to the points. It may be read by several
threads at once.
*/
class Scene_profile
{
public:
  /// constructs the profile of `size` points with the given ranges of coordinates, `reach`, and
  /// exponent of the grid, or none if the coordinates are not doubles.
  Scene_profile(std::size_t size, const std::vector<std::pair<double, double>>& box, double reach,
                std::optional<int> grid_exponent)
    : size_(size), box_(box), reach_(reach), grid_exponent_(grid_exponent),
      units_(grid_exponent ? std::floor(std::ldexp(reach, -*grid_exponent))
                           : std::numeric_limits<double>::infinity()),
      tier_(is_exact_in_double() ? Arithmetic_tier::DOUBLE : Arithmetic_tier::FILTERED_EXACT)
  {}

  /// returns the number of points.
  std::size_t size() const { return size_; }

  /// returns the dimension of the points, or 0 if there are none.
  int dimension() const { return static_cast<int>(box_.size()); }

  /// returns the smallest and the largest coordinate along axis `i`, rounded outwards.
  const std::pair<double, double>& range(int i) const { return box_[i]; }

  /// returns an upper bound on the distance along an axis of points within the bound.
  double reach() const { return reach_; }

  /// returns whether all coordinates are doubles without rounding, so that there is a grid.
  bool has_grid() const { return grid_exponent_.has_value(); }

  /// returns the exponent \f$ e \f$ of the coarsest grid \f$ 2^e \mathbb{Z} \f$ that holds all
  /// coordinates. \pre `has_grid()`
  int grid_exponent() const { return *grid_exponent_; }

  /// returns the reach in steps of the grid, or infinity if there is no grid.
  double units() const { return units_; }

  /// returns how many bits a squared distance up to the bound takes, in squared steps of the grid,
  /// or infinity if there is no grid.
  double bits() const { return 2 * std::log2((std::max)(units_, 1.)) + std::log2(terms()); }

  /// returns the arithmetic that is used.
  Arithmetic_tier tier() const { return tier_; }

  /// prints the profile, a line per fact.
  friend std::ostream& operator<<(std::ostream& out, const Scene_profile& profile)
  {
    out << "points      " << profile.size() << " in dimension " << profile.dimension() << '\n';
    for(int i = 0; i < profile.dimension(); ++i)
      out << "axis " << i << "      [" << profile.range(i).first << ", " << profile.range(i).second
          << "]\n";
    out << "reach       " << profile.reach() << '\n';
    if(profile.has_grid())
      out << "grid        2^" << profile.grid_exponent() << '\n'
          << "bits        " << profile.bits() << " for a squared distance, a double has 53\n";
    else
      out << "grid        none, the coordinates are not doubles\n";
    return out << "arithmetic  " << profile.tier() << '\n';
  }

private:
  // A sum of one square is treated as one of two, so that the square of units() + 1 is exact too.
  double terms() const { return (std::max)(dimension(), 2); }

  // Whether squared distances up to the bound are exact in double: their terms have at most 53 bits
  // together, do not underflow and do not overflow. A longer difference, of at least units() + 1
  // steps, has a square beyond the bound; rounding is monotone, so the sum comes out beyond it too.
  bool is_exact_in_double() const
  {
    static const double two_to_53 = std::ldexp(1., 53);
    static const double huge = std::ldexp(1., 500);
    return has_grid() && 2 * grid_exponent() >= -1074 && reach_ <= huge
           && terms() * units_ * units_ <= two_to_53;
  }

  std::size_t size_;
  std::vector<std::pair<double, double>> box_;
  double reach_;
  std::optional<int> grid_exponent_;
  double units_;
  Arithmetic_tier tier_;
};

namespace Thick_intersection_d {
namespace internal {

template <class Number, class Exact>
Scene_profile make_profile(std::size_t size, const Coordinate_scan& scan,
                           const Squared_bound<Exact>& bound)
{
  return Scene_profile(size, scan.box, bound.reach(),
                       is_held_by_double_v<Number> ? std::optional<int>(scan.grid.exponent())
                                                   : std::nullopt);
}

// Throws if a point has a NaN or infinite coordinate or another dimension than the first one.
template <class Elements, class Exact>
Scene_profile profile_elements(const Elements& points, const Squared_bound<Exact>& bound,
                               const std::string& name)
{
  const auto store_nothing = [](std::size_t, int, double) {};
  return make_profile<Coordinate_t<typename Elements::value_type>>(
    points.size(), scan_coordinates<Sequential_tag>(points, name, store_nothing), bound);
}

} // namespace internal
} // namespace Thick_intersection_d

/*!
\ingroup PkgThickIntersectionDRef

returns the profile of the scene of `points` and `bound`, in one pass over the coordinates.

\tparam PointRange is a range of `Point_2`, `Point_3` or `Point_d` of any kernel of \cgal.
\tparam NT is a number type as in `Distance_bound`.

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of `points`}
    \cgalParamDefault{the elements are the points}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument if a coordinate is NaN or infinite, if the points differ in dimension,
or if the bound is negative or NaN. The message tells the position of the point.
*/
template <class PointRange, class NT, class NamedParameters = parameters::Default_named_parameters>
Scene_profile profile_scene(const PointRange& points, const Distance_bound<NT>& bound,
                            const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const auto elements = internal::make_elements(points, np);
  using Point = typename std::decay_t<decltype(elements)>::value_type;
  using Exact = internal::Exact_number_t<internal::Coordinate_t<Point>>;
  return internal::profile_elements(elements, internal::Squared_bound<Exact>(bound), "point");
}

} // namespace CGAL

#endif // CGAL_SCENE_PROFILE_H
