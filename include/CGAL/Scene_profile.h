// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SCENE_PROFILE_H
#define CGAL_SCENE_PROFILE_H

// Describes a scene of points and a distance bound, or of objects. One pass over the coordinates
// finds the arithmetic that decides every pair exactly.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Named_function_parameters.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/print_profile.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

describes a scene of points together with a distance bound, or a scene of objects: its size and
extent, the coarsest grid that holds its coordinates, the arithmetic that the scene needs, and,
after a search, how many pairs each arithmetic has decided.

Coordinates that are doubles lie on a grid of step \f$ 2^e \f$. A difference of coordinates up to
the reach has at most `units()` steps, whatever the offset of the scene. Let \f$ S \f$ be the square
of this number times \f$ d \f$, the number of axes along which the points differ, or times 2 if that
is less. If \f$ S \f$ is at most \f$ 2^{53} \f$, doubles compute squared distances up to the bound
without error, and the results for larger distances are beyond the bound. So neither a filter nor
other numbers are needed. If \f$ S \f$ is below \f$ 2^{63} \f$, or below \f$ 2^{128} \f$ with fewer
than \f$ 2^{63} \f$ steps, integers of 64 or 128 bits decide the pairs that a filter in doubles
leaves undecided.

Whether two objects intersect is a question of the signs of determinants, of degree 2 in the plane
and 3 in space. Objects whose boxes meet lie in a box of twice the largest extents of objects; this
is the reach of each axis. With differences of \f$ b \f$ bits, in steps of the grid, determinants
have \f$ 2b+1 \f$ and \f$ 3b+3 \f$ bits. Doubles compute 53 bits without error. Integers of 64, 128
and 192 bits, if \f$ b \le 61 \f$, decide what a filter in doubles leaves undecided. Boxes and
points are compared, which is of degree 1, and needs doubles only. The squared distance of two
objects is a quotient, which is compared with a bound in degree 4 in the plane and 6 in space, or
2 for points and balls. Then the reach includes the bound, and integers have up to 128 bits. The
profile of tracks is one of objects, whose last axis is time.

`profile_scene()` makes a profile of points, and a search makes one if it is given a profile. A
profile does not refer to the points. Several threads may read it at once.
*/
class Scene_profile
{
public:
  /// \name Creation
  /// @{

  /// constructs the profile of a scene without points or objects.
  Scene_profile() : Scene_profile(0, {}, 0, 0) {}

  /// constructs the profile of `size` points with the given ranges of coordinates, reach, and
  /// exponent of the grid, or no exponent if the coordinates are not doubles. Coordinates along an
  /// axis whose range has no extent need not be on the grid.
  Scene_profile(std::size_t size, const std::vector<std::pair<double, double>>& box, double reach,
                std::optional<int> grid_exponent)
    : size_(size), box_(box), reach_(reach), grid_exponent_(grid_exponent),
      units_(Thick_intersection_d::internal::steps_within(reach, grid_exponent)),
      needed_tier_(Thick_intersection_d::internal::first_exact_tier(reach, grid_exponent,
                                                                    extended_axes()))
  {}

  /// constructs the profile of `size` objects with the given ranges of coordinates, the reach along
  /// each axis, the exponent of the grid, or no exponent if the coordinates are not doubles, and
  /// the degree of the intersection test: 1, 2 or 3.
  Scene_profile(std::size_t size, const std::vector<std::pair<double, double>>& box,
                const std::vector<double>& reaches, std::optional<int> grid_exponent, int degree)
    : size_(size), box_(box),
      reach_(reaches.empty() ? 0 : *std::max_element(reaches.begin(), reaches.end())),
      grid_exponent_(grid_exponent),
      units_(Thick_intersection_d::internal::steps_within(reach_, grid_exponent)),
      needed_tier_(
        Thick_intersection_d::internal::first_exact_tier(reaches, grid_exponent, degree)),
      degree_(degree), reaches_(reaches), are_objects_(true)
  {}

  /// @}
  /// \name The Scene
  /// @{

  /// returns the number of points or objects.
  std::size_t size() const { return size_; }

  /// returns the dimension of the points or objects, or 0 if there are none.
  int dimension() const { return static_cast<int>(box_.size()); }

  /// returns the smallest and the largest coordinate along axis `i`, rounded outwards.
  const std::pair<double, double>& range(int i) const { return box_[i]; }

  /// returns the number of axes along which the points, or points of the objects, differ. In the
  /// plane and in space, a search neither stores nor searches other axes.
  int extended_axes() const
  {
    int count = 0;
    for(const std::pair<double, double>& range : box_)
      count += range.first < range.second;
    return count;
  }

  /// returns an upper bound on the distance along an axis of points within the bound, or of points
  /// of two objects whose boxes meet.
  double reach() const { return reach_; }

  /// returns whether all coordinates are doubles without rounding, whatever their type. Then there
  /// is a grid.
  bool has_grid() const { return grid_exponent_.has_value(); }

  /// returns the exponent \f$ e \f$ of the coarsest grid \f$ 2^e \mathbb{Z} \f$ that holds all
  /// coordinates along the axes along which the points differ. \pre `has_grid()`
  int grid_exponent() const { return *grid_exponent_; }

  /// returns the reach in steps of the grid, or infinity if there is no grid.
  double units() const { return units_; }

  /// returns whether the profile is of objects, and not of points and a bound.
  bool is_of_objects() const { return are_objects_; }

  /// returns whether distances of the objects are compared with a bound, or the radius of a ball.
  bool is_of_distances() const { return are_distances_; }

  /// returns the algebraic degree of the question about a pair: 2 for points, 1 to 3 for objects
  /// that intersect, 2, 4 or 6 for objects within a bound, and 4 or 10 for points that move.
  int degree() const { return degree_; }

  /// returns how many bits a difference of coordinates up to the reach takes, in steps of the grid,
  /// or infinity if there is no grid.
  double difference_bits() const { return std::log2((std::max)(units_, 1.)); }

  /// returns how many bits a squared distance up to the bound takes, in squared steps of the grid,
  /// or the determinants of the test of objects, or infinity if there is no grid.
  double bits() const
  {
    if(are_distances_ && has_grid())
      return Thick_intersection_d::internal::distance_bits(reach_, *grid_exponent_, degree_);
    return are_objects_ && has_grid()
             ? Thick_intersection_d::internal::determinant_bits(reaches_, *grid_exponent_, degree_)
             : 2 * difference_bits()
                 + std::log2(Thick_intersection_d::internal::square_terms(extended_axes()));
  }

  /// @}
  /// \name The Arithmetic
  /// @{

  /// returns the first tier that is exact for the scene.
  Arithmetic_tier needed_tier() const { return needed_tier_; }

  /// returns the tier that the search uses: `needed_tier()`, unless another tier is forced.
  Arithmetic_tier tier() const
  {
    const Arithmetic_tier tier = forced_tier_.value_or(needed_tier_);
    return tier == Arithmetic_tier::INT192 && !are_objects_ ? Arithmetic_tier::FILTERED_EXACT
                                                            : tier;
  }

  /// makes searches that are given this profile use `tier`, which is `needed_tier()` or a later
  /// tier. The pairs are the same, but not the time.
  /// \throws std::invalid_argument if `tier` is not exact for the scene. The message names both.
  void force_tier(Arithmetic_tier tier)
  {
    if(tier < needed_tier_) {
      std::ostringstream message;
      message << "The arithmetic tier '" << tier << "' is not exact for this scene, which needs '"
              << needed_tier_ << "'.";
      throw std::invalid_argument(message.str());
    }
    forced_tier_ = tier;
  }

  /// returns the tier that is forced, if there is one.
  const std::optional<Arithmetic_tier>& forced_tier() const { return forced_tier_; }

  /// returns how many pairs the arithmetic that names a tier has decided, in the search that has
  /// made this profile: doubles, integers of 64, 128 or 192 bits, or exact numbers. Pairs of points
  /// that a filter in doubles finds beyond the bound are not counted. So the sum over all tiers is
  /// the number of pairs within the bound, plus the number of near ties beyond the bound, which the
  /// filter does not decide. Of objects, each pair whose boxes meet is counted once, for the
  /// hardest determinant that it needed. Of a long segment, these may be boxes of its stretches. A
  /// search that the callback stops may have decided a thousand pairs more than it reported.
  std::uint64_t decided(Arithmetic_tier tier) const { return counts_[tier]; }

  /// returns how many bits the search that has made this profile held a coordinate in, to find near
  /// pairs: 32, 64, or 0 if it did not use slabs. 32 bits are integers: steps of the grid, if the
  /// scene is that small, or else rounded, and then the coordinates of the user decide the few
  /// pairs near the bound. 64 bits are doubles: for scenes that extend over more than
  /// \f$ 2^{21} \f$ reaches, and for lattices whose grid is too fine.
  int coordinate_bits() const { return coordinate_bits_; }

  /// returns whether that search rounded coordinates to 32 bits.
  bool are_coordinates_rounded() const { return are_coordinates_rounded_; }

  /// @}
#ifndef DOXYGEN_RUNNING
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Scene_profile(const Thick_intersection_d::internal::Scene& scene, double reach)
    : Scene_profile(scene.size, ends_of(scene.box), reach, scene.grid_exponent)
  {}
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Scene_profile(const Thick_intersection_d::internal::Object_scene& scene, int degree)
    : Scene_profile(scene.size, ends_of(scene.box), scene.reaches, scene.grid_exponent, degree)
  {
    if(are_distances_ = scene.has_distances; are_distances_)
      needed_tier_
        = Thick_intersection_d::internal::first_distance_tier(reach_, grid_exponent_, degree);
  }

  void set_counts(const Thick_intersection_d::internal::Decision_counts& counts)
  {
    counts_ = counts;
  }
  void add_counts(const Scene_profile& other) { counts_.add(other.counts_); }
  void set_coordinates(int bits, bool are_rounded)
  {
    coordinate_bits_ = bits;
    are_coordinates_rounded_ = are_rounded;
  }
#endif

  /// prints the profile, one fact per line, and a sentence that sums it up.
  friend std::ostream& operator<<(std::ostream& out, const Scene_profile& profile)
  {
    return Thick_intersection_d::internal::print_profile(out, profile);
  }

private:
  std::size_t size_;
  std::vector<std::pair<double, double>> box_;
  double reach_;
  std::optional<int> grid_exponent_;
  double units_;
  Arithmetic_tier needed_tier_;
  std::optional<Arithmetic_tier> forced_tier_;
  Thick_intersection_d::internal::Decision_counts counts_;
  int coordinate_bits_ = 0;
  bool are_coordinates_rounded_ = false;
  int degree_ = 2;
  std::vector<double> reaches_; // of objects, along each axis
  bool are_objects_ = false, are_distances_ = false; // distances of objects
};

/*!
\ingroup PkgThickIntersectionDRef

returns the profile of the scene of `points` and `bound`, in one pass over the coordinates.

\tparam PointRange is a range of `Point_2`, `Point_3` or `Point_d` of any kernel of \cgal.
\tparam NT is a number type as in `Distance_bound`.

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of `points`}
    \cgalParamType{a model of `ReadablePropertyMap` from these elements to points}
    \cgalParamDefault{as for `fixed_radius_near_neighbors()`}
  \cgalParamNEnd
\cgalNamedParamsEnd
\throws std::invalid_argument if a coordinate is NaN or infinite, if the points differ in dimension,
or if the bound is negative or NaN. The message gives the position of the point.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.
*/
template <class PointRange, class NT, class NamedParameters = parameters::Default_named_parameters>
Scene_profile profile_scene(PointRange&& points, const Distance_bound<NT>& bound,
                            const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const auto elements = internal::make_elements(points, np);
  using Point = typename std::decay_t<decltype(elements)>::value_type;
  using Exact = internal::Exact_number_t<internal::Coordinate_t<Point>>;
  const double reach = internal::Squared_bound<Exact>(bound).reach();
  return Scene_profile(internal::scan_points(elements, "point"), reach);
}

} // namespace CGAL

#endif // CGAL_SCENE_PROFILE_H
