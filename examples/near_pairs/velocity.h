// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Where a point is after a while, by its speed and its course.

#ifndef NEAR_PAIRS_VELOCITY_H
#define NEAR_PAIRS_VELOCITY_H

#include "row_numbers.h"

#include <array>

namespace near_pairs {

struct Velocity
{
  double speed = 0, course = 0, climb = 0; // the course in degrees, clockwise from north
  bool is_known = true;
};

// Reads what --velocity names. A point whose speed or course is not known stands still. They are
// empty then; or, of ships, which are on the sphere and not above it, a speed of 102.3 knots or of
// 102.2, which is any higher one, or a course of 360 or 511 degrees (ITU-R M.1371). Throws Error if
// the row has something else than numbers. Where no columns are named, all points stand still.
Velocity read_velocity(const Place& place, bool is_geographic);

// In the plane or in space, in the unit of the coordinates and in seconds: y is north, z is up.
std::array<double, 3> place_after(const std::array<double, 3>& place, const Velocity& velocity,
                                  double seconds);

// From a place in meters from the center of a sphere: along a great circle by so many knots, at its
// height, and up by so many feet per minute.
std::array<double, 3> place_on_sphere_after(const std::array<double, 3>& place,
                                            const Velocity& velocity, double seconds);

} // namespace near_pairs

#endif // NEAR_PAIRS_VELOCITY_H
