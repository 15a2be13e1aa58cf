// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CARRIED_NUMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CARRIED_NUMBERS_H

// A point of any rational numbers, on its way to the part that searches it.

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/parts/Byte_reader.h>
#include <CGAL/Thick_intersection_d/internal/parts/Carried_doubles.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether all numbers of a type are rational, and can be written down.
template <class NT>
struct Is_rational
  : std::bool_constant<std::is_arithmetic_v<NT> || floating::Is_floating<NT>::value
                       || std::is_constructible_v<Exact_rational, const NT&>
                       || Fraction_traits<NT>::Is_fraction::value || is_integer_type_v<NT>>
{};
template <class ET>
struct Is_rational<Lazy_exact_nt<ET>> : Is_rational<ET> {};
template <class Integer>
struct Is_rational<Quotient<Integer>> : Is_rational<Integer> {};

// Searches read it like a point of CGAL. Coordinates that are doubles are carried as doubles.
template <int Dimension>
class Carried_numbers
{
public:
  using Ambient_dimension = Carried_dimension<Dimension>;

  struct Approximate_coordinate
  {
    double low, high;
    double inf() const { return low; }
    double sup() const { return high; }
  };

  struct Approximation
  {
    const Carried_numbers& point;
    Approximate_coordinate cartesian(int axis) const
    {
      return {point.bounds_along(axis).first, point.bounds_along(axis).second};
    }
  };

  Carried_numbers() = default;

  template <class Point>
  explicit Carried_numbers(const Point& point)
  {
    resize_values<Dimension, Bounds>(bounds_, point.dimension());
    bool are_doubles = true;
    for(int axis = 0; axis < dimension(); ++axis) {
      const Bounds x = coordinate_bounds(point, axis);
      bounds_[static_cast<std::size_t>(axis)] = x;
      are_doubles = are_doubles && x.first == x.second;
    }
    for(int axis = 0; axis < dimension() && !are_doubles; ++axis)
      exact_.push_back(to_exact_rational(coordinate(point, axis)));
  }

  int dimension() const { return static_cast<int>(bounds_.size()); }

  Exact_rational cartesian(int axis) const
  {
    return exact_.empty() ? Exact_rational(bounds_along(axis).first)
                          : exact_[static_cast<std::size_t>(axis)];
  }

  Approximation approx() const { return {*this}; }

  // Where the approximation is, by the name that lazy points of CGAL have for it.
  const void* for_compact_container() const { return this; }

  std::pair<double, double> bounds_along(int axis) const
  {
    return bounds_[static_cast<std::size_t>(axis)];
  }

  // The least number of bytes that a point is packed into.
  static std::size_t packed_size(int dimension)
  {
    return static_cast<std::size_t>(dimension) * sizeof(double) + 1;
  }

  void pack(std::vector<char>& bytes) const
  {
    bytes.push_back(exact_.empty() ? 0 : 1);
    if(exact_.empty())
      for(const Bounds& x : bounds_)
        write_bytes(&x.first, 1, bytes);
    for(const Exact_rational& x : exact_) {
      std::ostringstream stream;
      stream << x;
      const std::string text = stream.str();
      const std::uint64_t size = text.size();
      write_bytes(&size, 1, bytes);
      write_bytes(text.data(), text.size(), bytes);
    }
  }

  void unpack(Byte_reader& bytes, int dimension)
  {
    resize_values<Dimension, Bounds>(bounds_, dimension);
    char is_exact;
    bytes.read(&is_exact, 1);
    for(Bounds& x : bounds_)
      if(is_exact) {
        exact_.push_back(unpack_number(bytes));
        x = bounds(exact_.back());
      }
      else {
        bytes.read(&x.first, 1);
        x.second = x.first;
      }
  }

private:
  using Bounds = std::pair<double, double>;

  static Exact_rational unpack_number(Byte_reader& bytes)
  {
    std::uint64_t size;
    bytes.read(&size, 1);
    std::istringstream stream(bytes.read_text(static_cast<std::size_t>(size)));
    Exact_rational value;
    stream >> value;
    return value;
  }

  Values_along_axes<Dimension, Bounds> bounds_{};
  std::vector<Exact_rational> exact_; // empty if all coordinates are doubles
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CARRIED_NUMBERS_H
