// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The ways in which programs ask whether two points are within a distance of r, in floating point.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_DISTANCE_FORMS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_DISTANCE_FORMS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace thick_benchmark {

template <std::size_t Dimension>
using Array_point = std::array<double, Dimension>;

// The sum of the squared differences, in the number type Float, into which coordinates are rounded.
template <class Float, std::size_t Dimension>
Float squared_distance_in(const Array_point<Dimension>& p, const Array_point<Dimension>& q)
{
  Float sum = 0;
  for(std::size_t i = 0; i < Dimension; ++i) {
    const Float difference = static_cast<Float>(p[i]) - static_cast<Float>(q[i]);
    sum += difference * difference;
  }
  return sum;
}

template <class Float>
struct Squared_in
{
  template <std::size_t Dimension>
  static bool is_near(const Array_point<Dimension>& p, const Array_point<Dimension>& q, double r)
  {
    const Float radius = static_cast<Float>(r);
    return squared_distance_in<Float>(p, q) <= radius * radius;
  }
};

struct With_square_root
{
  template <std::size_t Dimension>
  static bool is_near(const Array_point<Dimension>& p, const Array_point<Dimension>& q, double r)
  {
    return std::sqrt(squared_distance_in<double>(p, q)) <= r;
  }
};

struct With_hypot
{
  template <std::size_t Dimension>
  static bool is_near(const Array_point<Dimension>& p, const Array_point<Dimension>& q, double r)
  {
    if constexpr(Dimension == 2)
      return std::hypot(p[0] - q[0], p[1] - q[1]) <= r;
    else
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= r;
  }
};

// |p|^2 + |q|^2 - 2 p.q, by which matrix products compute distances.
struct Expanded
{
  template <std::size_t Dimension>
  static bool is_near(const Array_point<Dimension>& p, const Array_point<Dimension>& q, double r)
  {
    double pp = 0, qq = 0, pq = 0;
    for(std::size_t i = 0; i < p.size(); ++i) {
      pp += p[i] * p[i];
      qq += q[i] * q[i];
      pq += p[i] * q[i];
    }
    return pp + qq - 2 * pq <= r * r;
  }
};

// A form by its name.
template <std::size_t Dimension>
struct Named_form
{
  using Point = Array_point<Dimension>;

  std::string name;
  std::function<bool(const Point&, const Point&, double)> is_near;
};

// Those that the tables of the laboratory have in common.
template <std::size_t Dimension>
std::vector<Named_form<Dimension>> common_forms()
{
  return {{"double", Squared_in<double>::is_near<Dimension>},
          {"double, sqrt", With_square_root::is_near<Dimension>},
          {"double, hypot", With_hypot::is_near<Dimension>},
          {"double, expanded", Expanded::is_near<Dimension>},
          {"float", Squared_in<float>::is_near<Dimension>}};
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_DISTANCE_FORMS_H
