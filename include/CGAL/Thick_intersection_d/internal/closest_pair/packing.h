// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PACKING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PACKING_H

// The number of points that fit in a cell if no two of them are close. It bounds the work of [L]
// (Closest_pair_search.h).

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns N = (floor(sqrt(D)) + 1)^D, or a large number if N is larger: 4 in the plane, 8 in space.
//
// Lemma. Of more than N points in a closed cube of side r in dimension D, two are closer than r.
// Proof: divide the edges of the cube into m = floor(sqrt(D)) + 1 equal parts. Two of the points
// are in one of the m^D small closed cubes. Their distance is at most r sqrt(D) / m < r.
//
// So N serves closed bounds, where pairs at distance r are close, and open bounds. It also serves
// cubes that are larger than r by less than the factor m / sqrt(D). In the plane the best constants
// differ. For an open bound 4 points fit, the corners of the square. For a closed bound 3 points
// fit: among any 4 points in the plane, some three have an angle of 90 degrees or more. If all
// distances are more than r, the distance of the outer two points is more than sqrt(2) r, the
// diagonal of the square.
inline std::size_t max_points_per_cell(int dimension)
{
  const double parts = std::floor(std::sqrt(static_cast<double>(dimension))) + 1;
  return static_cast<std::size_t>((std::min)(std::pow(parts, dimension), 1e9));
}

// Returns the number of cells of the strip that touch a cell, itself included: the
// strip of the divide and conquer is cut along all axes but the first and the last.
inline double touching_cell_count(int dimension)
{
  return std::pow(3., (std::max)(dimension - 2, 0));
}

// Returns a bound on the number of points that a point of the strip is compared with.
// Closest_pair_divide.h proves it.
inline std::size_t max_candidate_count(int dimension)
{
  const double candidates = 2 * static_cast<double>(max_points_per_cell(dimension))
                            * touching_cell_count(dimension) - 1;
  return static_cast<std::size_t>((std::min)(candidates, 1e9));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PACKING_H
