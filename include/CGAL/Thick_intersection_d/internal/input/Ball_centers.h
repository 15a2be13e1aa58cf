// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BALL_CENTERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BALL_CENTERS_H

// Balls of one radius intersect if their centers are within twice the radius. So the search needs
// only the centers.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The centers of balls. A ball is a pair of a point and a radius.
template <class Balls>
class Ball_centers
{
  using Ball = decltype(std::declval<const Balls&>()[0]);

public:
  using value_type = typename Balls::value_type::first_type;

  explicit Ball_centers(const Balls& balls) : balls_(balls) {}

  std::size_t size() const { return balls_.size(); }

  // Returns a reference to the center of a ball, or a copy if the ball is a temporary object.
  std::conditional_t<std::is_reference_v<Ball>, const value_type&, value_type>
  operator[](std::size_t position) const
  {
    return balls_[position].first;
  }

private:
  const Balls& balls_;
};

// Returns an interval of doubles that holds all numbers within a radius of another interval. The
// next double is beyond what one addition may lose, in every rounding mode.
template <class NT>
std::pair<double, double> thickened_interval(const std::pair<double, double>& interval,
                                             const NT& radius)
{
  const double length = bounds(radius).second;
  return {double_before(interval.first - length), double_after(interval.second + length)};
}

// Returns an interval of doubles that holds a ball along an axis.
template <class Ball>
std::pair<double, double> ball_interval(const Ball& ball, int axis)
{
  return thickened_interval(coordinate_bounds(ball.first, axis), ball.second);
}

template <class NT>
bool is_radius(const NT& radius)
{
  return is_finite_number(radius) && radius >= NT(0);
}

// Throws if the radius of an object is negative, NaN or infinite.
template <class NT>
void check_radius(const NT& radius, std::size_t position)
{
  if(!is_radius(radius))
    throw std::invalid_argument("The radius of object " + std::to_string(position)
                                + " is negative, NaN or infinite.");
}

// Throws if a coordinate of the center is NaN or infinite, or if the radius is no radius.
template <class Ball>
void check_ball(const Ball& ball, int dimension, std::size_t position)
{
  check_point(ball.first, dimension, "object", position);
  check_radius(ball.second, position);
}

// Returns the radius that all balls have, if there is one.
template <class Balls>
auto common_radius(const Balls& balls)
{
  std::optional<typename Balls::value_type::second_type> radius;
  for(std::size_t i = 0; i < balls.size(); ++i) {
    const auto& ball = balls[i];
    if(!radius)
      radius = ball.second;
    else if(!(ball.second == *radius)) {
      radius.reset();
      break;
    }
  }
  return radius;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BALL_CENTERS_H
