// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a scene tells of its points; see scene.h.

#include "scene.h"

#include "decimal.h"
#include "rational.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace near_pairs {
namespace {

// Divides an integer, or any double if the scale is 0, by 10^scale, and rounds once: larger powers
// of ten are no doubles.
double over_power_of_ten(double number, int scale)
{
  const int largest_exact_scale = 22;
  if(scale <= largest_exact_scale)
    return number / std::pow(10., scale);
  const auto integer = static_cast<std::int64_t>(number);
  return nearest_double(std::to_string(integer) + "e-" + std::to_string(scale));
}

} // namespace

std::size_t Scene::size() const
{
  return std::max(doubles.size(), exact.size()) / dimension;
}

std::size_t Scene::position(std::size_t point) const
{
  if(!rows.empty())
    return rows[point];
  return first_size && point >= *first_size ? point - *first_size : point;
}

int Scene::file(std::size_t point) const
{
  return first_size && point >= *first_size ? 2 : 1;
}

double Scene::coordinate(std::size_t point, int axis) const
{
  const std::size_t at = point * dimension + axis;
  return exact.empty() ? over_power_of_ten(doubles[at], scale) : exact.rounded(at);
}

// Doubles would lose their digits as soon as a period is added and most of it cancels out.
std::array<double, 3> Scene::difference(std::size_t i, std::size_t j, const Offset& offset) const
{
  std::array<double, 3> result = {0, 0, 0};
  for(int axis = 0; axis < dimension; ++axis) {
    const std::size_t a = i * dimension + axis, b = j * dimension + axis;
    if(offset != Offset{})
      result[axis] = to_double(exact_difference(i, j, offset, axis));
    else
      result[axis] = exact.empty() ? over_power_of_ten(doubles[b] - doubles[a], scale)
                                   : exact.rounded_difference(b, a);
  }
  return result;
}

Exact_number Scene::exact_difference(std::size_t i, std::size_t j, const Offset& offset,
                                     int axis) const
{
  CGAL::Exact_rational sum(doubles[j * dimension + axis]);
  sum -= CGAL::Exact_rational(doubles[i * dimension + axis]);
  sum /= power_of_ten(scale);
  for(int k = 0; k < dimension; ++k)
    if(offset[k] != 0)
      sum += offset[k] * cell->vectors[k][axis]->value;
  return Exact_number(Rational{sum});
}

double Scene::distance(std::size_t i, std::size_t j, const Offset& offset) const
{
  const std::array<double, 3> d = difference(i, j, offset);
  return std::hypot(std::hypot(d[0], d[1]), d[2]);
}

int Scene::columns() const
{
  return is_geographic ? 2 : dimension;
}

double Scene::column(std::size_t point, int axis) const
{
  if(!is_geographic)
    return coordinate(point, axis);
  return degrees_of({coordinate(point, 0), coordinate(point, 1), coordinate(point, 2)})[axis];
}

std::array<double, 2> Scene::degrees(std::size_t point) const
{
  return is_geographic ? std::array<double, 2>{column(point, 1), column(point, 0)}
                       : std::array<double, 2>{coordinate(point, 0), coordinate(point, 1)};
}

std::array<double, 2> degrees_of(const std::array<double, 3>& place)
{
  const auto in_degrees = [](double radians) {
    const double digits = 1e9; // a tenth of a millimeter; the errors of the sphere are behind it
    return std::round(radians * 180 / std::acos(-1.) * digits) / digits;
  };
  const auto [x, y, z] = place;
  return {in_degrees(std::atan2(z, std::hypot(x, y))), in_degrees(std::atan2(y, x))};
}

} // namespace near_pairs
