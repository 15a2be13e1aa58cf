// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Speeds and courses; see velocity.h.

#include "velocity.h"

#include "error.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace near_pairs {
namespace {

constexpr double knot = 1852. / 3600, foot_per_minute = 0.3048 / 60; // in meters per second

Error bad_motion(const Place& place, std::size_t column, const std::string& fault)
{
  return Error(place.input.name(), place.row.line, place.reader.motion_names[column] + fault);
}

// Returns nothing if the field says that there is no number, or if there is no such column.
std::optional<double> motion_number(const Place& place, std::size_t column)
{
  if(column >= place.row.motion.size() || is_missing(place.row.motion[column]))
    return std::nullopt;
  const std::string& text = place.row.motion[column];
  const double value = parse_decimal(text) ? nearest_double(text) : HUGE_VAL;
  if(!std::isfinite(value))
    throw bad_motion(place, column, ": '" + text + "' is no finite number");
  return value;
}

double radians(double degrees)
{
  return degrees * std::acos(-1.) / 180;
}

} // namespace

Velocity read_velocity(const Place& place, bool is_geographic)
{
  if(place.row.motion.empty()) // a file of what stands still
    return {};
  const std::optional<double> speed = motion_number(place, 0), course = motion_number(place, 1);
  const double climb = motion_number(place, 2).value_or(0);
  const bool is_ship = is_geographic && place.reader.dimension == 2;
  const bool has_no_speed = !speed || (is_ship && (*speed == 102.2 || *speed == 102.3));
  const bool has_no_course = !course || (is_ship && (*course == 360 || *course == 511));
  if(!has_no_speed && *speed < 0)
    throw bad_motion(place, 0, ": a speed of " + place.row.motion[0] + " is negative");
  if(!has_no_course && std::abs(*course) > 360)
    throw bad_motion(place, 1, ": a course of " + place.row.motion[1]
                                 + " is outside [-360, 360] degrees");
  if(has_no_speed || (has_no_course && *speed != 0))
    return {0, 0, 0, false};
  return {*speed, course.value_or(0), climb, true};
}

std::array<double, 3> place_after(const std::array<double, 3>& place, const Velocity& velocity,
                                  double seconds)
{
  const double way = velocity.speed * seconds, course = radians(velocity.course);
  return {place[0] + way * std::sin(course), place[1] + way * std::cos(course),
          place[2] + velocity.climb * seconds};
}

std::array<double, 3> place_on_sphere_after(const std::array<double, 3>& place,
                                            const Velocity& velocity, double seconds)
{
  const auto [x, y, z] = place;
  const double ring = std::hypot(x, y), radius = std::hypot(ring, z);
  const double angle = velocity.speed * knot * seconds / radius, course = radians(velocity.course);
  // East is along the parallel; at a pole it is that of longitude 0. North is what is left.
  const double east_x = ring == 0 ? 0 : -y / ring, east_y = ring == 0 ? 1 : x / ring;
  const double north_x = -z / radius * east_y, north_y = z / radius * east_x;
  const double east = std::sin(angle) * std::sin(course);
  const double north = std::sin(angle) * std::cos(course);
  const double new_radius = radius + velocity.climb * foot_per_minute * seconds;
  return {new_radius * (std::cos(angle) * x / radius + east * east_x + north * north_x),
          new_radius * (std::cos(angle) * y / radius + east * east_y + north * north_y),
          new_radius * (std::cos(angle) * z / radius + north * ring / radius)};
}

} // namespace near_pairs
