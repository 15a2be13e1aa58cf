// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes on which one or another way of computing a distance goes wrong: exact ties, near misses,
// magnitudes whose squares over- or underflow, cells that meet at a rounded boundary. Each has
// about 800 points, in two or three dimensions. The expected counts were obtained independently,
// in rational arithmetic; the families drawn at random have none, and leave it to brute force.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_ROBUSTNESS_FAMILIES_H
#define THICK_INTERSECTION_TEST_SUPPORT_ROBUSTNESS_FAMILIES_H

#include "point_generators.h"

namespace test_support {

class Robustness_families
{
public:
  explicit Robustness_families(int dimension) : dimension_(dimension) {}

  Scenes scenes()
  {
    append_lattices();
    append_extreme_lattices();
    append_meant_squares();
    append_near_misses();
    append_random();
    append_collinear();
    add("800 identical points, r = 0", identical_points(dimension_, 800, 0.1),
        Radius::of_length(0), Expected_count{319600, 319600});
    return std::move(scenes_);
  }

private:
  using Count = std::optional<Expected_count>;

  void add(std::string name, Points points, Radius radius, Count expected)
  {
    scenes_.push_back(
      {std::move(name), dimension_, std::move(points), std::move(radius), expected});
  }

  template <class Value>
  Value in_2_or_3(Value two, Value three) const { return dimension_ == 2 ? two : three; }

  // 28 x 28 or 9 x 9 x 9 points.
  Points lattice(double unit, double offset = 0) const
  {
    return lattice_points(dimension_, in_2_or_3(28, 9), unit, offset);
  }

  // Radius 5 units in the plane, 3 in space: where Pythagoras makes many ties off the axes.
  Radius units(double unit) const { return Radius::of_length(in_2_or_3(5, 3) * unit); }

  void append_lattices()
  {
    const Expected_count unit_count = in_2_or_3<Expected_count>({26656, 3688}, {29381, 6162});
    const double odd_27_bits = 87654321, odd_45_bits = 23456789012345;
    const double tiny = std::ldexp(1., -20);
    add("unit lattice", lattice(1), units(1), unit_count);
    add("lattice of an odd 27-bit unit", lattice(odd_27_bits), units(odd_27_bits), unit_count);
    add("lattice of an odd 45-bit unit", lattice(odd_45_bits), units(odd_45_bits), unit_count);
    add("lattice 2^-20 i + 2^30", lattice(tiny, std::ldexp(1., 30)), units(tiny), unit_count);
    add("lattice 0.1 i, r = 0.5 or 0.3", lattice(0.1), Radius::of_length(in_2_or_3(0.5, 0.3)),
        in_2_or_3<Expected_count>({24932, 952}, {24422, 243}));
    add("lattice 0.1 i, r = 0.1", lattice(0.1), Radius::of_length(0.1),
        in_2_or_3<Expected_count>({728, 112}, {1458, 486}));
  }

  // Squares that overflow, or underflow to a few bits or to nothing.
  void append_extreme_lattices()
  {
    const double smallest = std::numeric_limits<double>::denorm_min();
    add("lattice 1e200 i, r = 1e200", lattice(1e200), Radius::of_length(1e200),
        in_2_or_3<Expected_count>({840, 224}, {1458, 972}));
    add("lattice 2.5e153 i", lattice(2.5e153), units(2.5e153),
        in_2_or_3<Expected_count>({24928, 224}, {27509, 972}));
    add("lattice 1e-200 i, r = 1e-200", lattice(1e-200), Radius::of_length(1e-200),
        in_2_or_3<Expected_count>({840, 336}, {1701, 1458}));
    add("lattice 1e-160 i", lattice(1e-160), units(1e-160),
        in_2_or_3<Expected_count>({25004, 524}, {27458, 3807}));
    add("lattice 5e-324 i", lattice(smallest), units(smallest),
        in_2_or_3<Expected_count>({26656, 3688}, {29381, 6162}));
  }

  // The square was meant; a radius rounded to double loses or gains the whole boundary.
  void append_meant_squares()
  {
    const int small = in_2_or_3(2, 3), large = in_2_or_3(13, 6);
    const Expected_count small_count = in_2_or_3<Expected_count>({2970, 1458}, {7448, 2048});
    const Expected_count large_count = in_2_or_3<Expected_count>({15286, 2600}, {20573, 5376});
    append_meant_square(small, small_count);
    append_meant_square(large, large_count);
  }

  void append_meant_square(int square, const Expected_count& expected)
  {
    const std::string text = std::to_string(square);
    add("unit lattice, r^2 = " + text, lattice(1), Radius::of_square(text), expected);
    add("unit lattice, r = fl(sqrt " + text + ")", lattice(1), Radius::of_length(std::sqrt(square)),
        std::nullopt);
  }

  // 160 far apart triples: a corner c, and c + (x, y) and c + (x, -y), which are near each other.
  Points triples(double x, double y) const
  {
    Points points;
    for(int i = 0; i < 160; ++i) {
      const double corner = std::ldexp(static_cast<double>(i), 32);
      points.push_back({corner, 0});
      points.push_back({corner + x, y});
      points.push_back({corner + x, -y});
    }
    return embedded(std::move(points), dimension_);
  }

  // The fan's and the hair's sides are longer than r by less than one part in 2^53.
  void append_near_misses()
  {
    const double m = 16384; // 2 m^2 = 2^29
    add("integers, d^2 = r^2 + 1", triples(2 * m * m - 1, 2 * m), Radius::of_length(2 * m * m),
        Expected_count{160, 0});
    add("integers, d^2 = r^2 - 1", triples(2 * m * m, 2 * m), Radius::of_length(2 * m * m + 1),
        Expected_count{480, 0});
    Points fan(1, {0, 0}), hair(1, {1, 0});
    for(int i = 1; i < 800; ++i) {
      fan.push_back({1, std::ldexp(static_cast<double>(i), -34)});
      hair.push_back({-std::ldexp(static_cast<double>(i), -62), 0});
    }
    add("fan", embedded(fan, dimension_), Radius::of_length(1), Expected_count{318801, 0});
    add("hair", embedded(hair, dimension_), Radius::of_length(1), Expected_count{318801, 0});
  }

  void append_random()
  {
    add("random", uniform_points(dimension_, 800, 0, 1, 51), Radius::of_length(0.1), std::nullopt);
    add("random + 1e6", uniform_points(dimension_, 800, 1e6, 1, 52), Radius::of_length(0.1),
        std::nullopt);
    add("random + 1e9", uniform_points(dimension_, 800, 1e9, 1, 53), Radius::of_length(0.1),
        std::nullopt);
    append_axis_ties();
  }

  // 640 random points and 160 partners, each at exactly r along some axis.
  void append_axis_ties()
  {
    const double r = std::ldexp(69379583521., -40); // odd numerator, about 0.063
    Random random(54);
    Points points(640, Coordinates(dimension_));
    for(Coordinates& p : points)
      for(double& x : p)
        x = random.fixed_point(40);
    for(int i = 0; i < 160; ++i) {
      points.push_back(points[i]);
      points.back()[i % dimension_] += r;
    }
    add("random 40-bit, ties along the axes", points, Radius::of_length(r), std::nullopt);
  }

  void append_collinear()
  {
    add("collinear 0.1 i, r = 0.1", axis_points(dimension_, 800, 0, 0, 0.1),
        Radius::of_length(0.1), Expected_count{327, 2});
    add("collinear 49 i, r = 49", axis_points(dimension_, 800, 0, 0, 49), Radius::of_length(49),
        Expected_count{799, 799});
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Points cells;
    for(int k = 0; k < 260; ++k) {
      const double x = k * 0.3;
      for(double near_x : {std::nextafter(x, -infinity), x, std::nextafter(x, infinity)})
        cells.push_back({near_x});
    }
    add("collinear 0.3 k and its neighbours, r = 0.3", embedded(cells, dimension_),
        Radius::of_length(0.3), Expected_count{1979, 2});
  }

  int dimension_;
  Scenes scenes_;
};

// Dimension 2 or 3.
inline Scenes robustness_families(int dimension)
{
  return Robustness_families(dimension).scenes();
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_ROBUSTNESS_FAMILIES_H
