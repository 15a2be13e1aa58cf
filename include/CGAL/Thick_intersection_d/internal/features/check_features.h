// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CHECK_FEATURES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CHECK_FEATURES_H

// What is wrong with features.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws if there are `limit` of something or more. By default, places must number them.
inline void check_feature_count(const char* what, std::size_t count,
                                std::size_t limit = max_place / 2)
{
  if(count < limit)
    return;
  std::string message("There are too many ");
  message.append(what).append(": ").append(std::to_string(limit)).append(" or more.");
  throw std::length_error(message);
}

// Throws for a face of a mesh: "Face 1 of feature 2 is no triangle."
[[noreturn]] inline void throw_wrong_face(std::size_t face, std::size_t feature, const char* what)
{
  std::string message("Face ");
  message.append(std::to_string(face)).append(" of feature ").append(std::to_string(feature));
  throw std::invalid_argument(message.append(what));
}

// Throws if a coordinate is NaN or infinite.
template <class Point>
void check_vertex(const Point& point, std::size_t feature)
{
  for(int i = 0; i < dimension_or<Point>(0); ++i)
    if(!are_bounds_of_finite(coordinate_bounds(point, i)))
      throw_not_finite("vertex of feature", feature, i);
}

// The same of a face: "Coordinate 0 of vertex of face 1 of feature 2 is ..."
template <class Point>
void check_face(std::size_t face, std::size_t feature, const Point& p, const Point& q,
                const Point& r)
{
  for(const Point* vertex : {&p, &q, &r})
    for(int i = 0; i < 3; ++i)
      if(!are_bounds_of_finite(coordinate_bounds(*vertex, i))) {
        const std::string name = "vertex of face " + std::to_string(face) + " of feature";
        throw_not_finite(name.c_str(), feature, i);
      }
}

// Throws if the radius is negative, NaN or infinite.
template <class NT>
void check_feature_radius(const NT& radius, std::size_t feature)
{
  if(!is_radius(radius))
    throw std::invalid_argument("The radius of feature " + std::to_string(feature)
                                + " is negative, NaN or infinite.");
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_CHECK_FEATURES_H
