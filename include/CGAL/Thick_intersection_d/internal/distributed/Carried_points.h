// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_CARRIED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_CARRIED_POINTS_H

// Points that travel between processes: their coordinates as doubles, or as exact numbers.

#include <CGAL/Dimension.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Searches read it like a point of CGAL. `Dimension` is 0 if it is known at run time only.
template <int Dimension>
class Carried_doubles
{
public:
  using Ambient_dimension
    = std::conditional_t<Dimension == 0, Dynamic_dimension_tag, Dimension_tag<Dimension>>;

  Carried_doubles() = default;

  // Of other numbers, it carries their lower bounds.
  template <class Point>
  explicit Carried_doubles(const Point& point)
  {
    resize(dimension_of(point));
    for(std::size_t axis = 0; axis < x_.size(); ++axis)
      x_[axis] = coordinate_bounds(point, static_cast<int>(axis)).first;
  }

  int dimension() const { return static_cast<int>(x_.size()); }
  double operator[](std::size_t axis) const { return x_[axis]; }
  double cartesian(int axis) const { return x_[static_cast<std::size_t>(axis)]; }
  std::pair<double, double> bounds_along(int axis) const
  {
    return {cartesian(axis), cartesian(axis)};
  }

  // The least number of bytes that a point is packed into.
  static std::size_t packed_size(int dimension)
  {
    return static_cast<std::size_t>(dimension) * sizeof(double);
  }

  void pack(std::vector<char>& bytes) const { write_bytes(x_.data(), x_.size(), bytes); }

  void unpack(Byte_reader& bytes, int dimension)
  {
    resize(dimension);
    bytes.read(x_.data(), x_.size());
  }

protected:
  void resize([[maybe_unused]] int dimension)
  {
    if constexpr(Dimension == 0)
      x_.resize(static_cast<std::size_t>(dimension));
  }

  std::conditional_t<Dimension == 0, std::vector<double>,
                     std::array<double, static_cast<std::size_t>(Dimension)>> x_{};
};

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

// Searches read it like a lazy point of CGAL. Coordinates that are doubles are carried as doubles.
template <int Dimension>
class Carried_numbers : public Carried_doubles<Dimension>
{
  using Lower_bounds = Carried_doubles<Dimension>;

public:
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
  explicit Carried_numbers(const Point& point) : Lower_bounds(point)
  {
    bool are_doubles = true;
    for(int axis = 0; axis < this->dimension(); ++axis)
      are_doubles = are_doubles && coordinate_bounds(point, axis).second == (*this)[place(axis)];
    for(int axis = 0; axis < this->dimension() && !are_doubles; ++axis)
      add_exact(to_exact_rational(coordinate(point, axis)));
  }

  Exact_rational cartesian(int axis) const
  {
    return exact_.empty() ? Exact_rational((*this)[place(axis)]) : exact_[place(axis)].value;
  }

  Approximation approx() const { return {*this}; }

  // Where the approximation is, by the name that lazy points of CGAL have for it.
  const void* for_compact_container() const { return this; }

  std::pair<double, double> bounds_along(int axis) const
  {
    const double low = (*this)[place(axis)];
    return {low, exact_.empty() ? low : exact_[place(axis)].high};
  }

  static std::size_t packed_size(int dimension)
  {
    return Lower_bounds::packed_size(dimension) + 1;
  }

  void pack(std::vector<char>& bytes) const
  {
    bytes.push_back(exact_.empty() ? 0 : 1);
    if(exact_.empty())
      Lower_bounds::pack(bytes);
    for(const Exact_coordinate& x : exact_) {
      std::ostringstream stream;
      stream << x.value;
      const std::string text = stream.str();
      const std::uint64_t size = text.size();
      write_bytes(&size, 1, bytes);
      write_bytes(text.data(), text.size(), bytes);
    }
  }

  void unpack(Byte_reader& bytes, int dimension)
  {
    char is_exact;
    bytes.read(&is_exact, 1);
    if(!is_exact)
      return Lower_bounds::unpack(bytes, dimension);
    this->resize(dimension);
    for(int axis = 0; axis < dimension; ++axis) {
      std::uint64_t size;
      bytes.read(&size, 1);
      std::string text(static_cast<std::size_t>(size), ' ');
      bytes.read(&text[0], text.size());
      std::istringstream stream(text);
      Exact_rational x;
      stream >> x;
      add_exact(std::move(x));
    }
  }

private:
  struct Exact_coordinate
  {
    Exact_rational value;
    double high; // its upper bound
  };

  static std::size_t place(int axis) { return static_cast<std::size_t>(axis); }

  // Adds the next coordinate, with bounds of its own. Those that a lazy point has would be narrower
  // in another search, after this one has asked for the exact number.
  void add_exact(Exact_rational x)
  {
    double& low = this->x_[exact_.size()];
    exact_.push_back({std::move(x), 0});
    std::tie(low, exact_.back().high) = bounds(exact_.back().value);
  }

  std::vector<Exact_coordinate> exact_; // empty if all coordinates are doubles
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_CARRIED_POINTS_H
