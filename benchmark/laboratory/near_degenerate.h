// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Questions of degree 1, 2, 4 and 5 about non-negative integers of b bits: drawn at random, or so
// that the polynomial in question is zero or nearly so.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_NEAR_DEGENERATE_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_NEAR_DEGENERATE_H

#include "support/point_generators.h"

#include <CGAL/predicates/kernel_ftC2.h>
#include <CGAL/predicates/kernel_ftC3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace lab {

using Question = std::vector<double>; // coordinates and radii, in the order of the predicate
using test_support::Random;

// A predicate: what it is called, its degree, how many bits the polynomial may take on input of b
// bits (robust bounds on its magnitude), and its sign in any number type.
struct Compare_x
{
  static constexpr const char* name = "x_A <= x_B";
  static constexpr int degree = 1;
  static double bits(int b) { return b; }

  template <class T>
  static int sign(const std::vector<T>& v)
  {
    return v[0] <= v[1];
  }
};

struct Compare_distance
{
  static constexpr const char* name = "|pq| <= r";
  static constexpr int degree = 2;
  static double bits(int b) { return 2 * b + 1; }

  template <class T>
  static int sign(const std::vector<T>& v)
  {
    const T dx = v[0] - v[2], dy = v[1] - v[3];
    return T(dx * dx + dy * dy) <= T(v[4] * v[4]);
  }
};

struct Compare_distance_of_disks
{
  static constexpr const char* name = "|pq| <= r1 + r2";
  static constexpr int degree = 2;
  static double bits(int b) { return 2 * b + 2; }

  template <class T>
  static int sign(const std::vector<T>& v)
  {
    const T dx = v[0] - v[2], dy = v[1] - v[3], sum = v[4] + v[5];
    return T(dx * dx + dy * dy) <= T(sum * sum);
  }
};

// The determinant of the points lifted to the paraboloid, expanded along the lifting.
struct Side_of_circle
{
  static constexpr const char* name = "in circle";
  static constexpr int degree = 4;
  static double bits(int b) { return 4 * b + 3.6; }

  template <class T>
  static int sign(const std::vector<T>& v)
  {
    const T ax = v[0] - v[6], ay = v[1] - v[7];
    const T bx = v[2] - v[6], by = v[3] - v[7];
    const T cx = v[4] - v[6], cy = v[5] - v[7];
    const T determinant = (ax * ax + ay * ay) * (bx * cy - by * cx)
                          + (bx * bx + by * by) * (cx * ay - cy * ax)
                          + (cx * cx + cy * cy) * (ax * by - ay * bx);
    return determinant < T(0) ? -1 : determinant > T(0) ? 1 : 0;
  }
};

// The same polynomial as CGAL has it, a comparison of two products. On an exact tie they are equal
// numbers, and are rounded in the same way.
struct Side_of_circle_by_products
{
  static constexpr const char* name = "in circle, as two products";
  static constexpr int degree = 4;
  static double bits(int b) { return Side_of_circle::bits(b); }

  template <class T>
  static int sign(const std::vector<T>& v)
  {
    return CGAL::side_of_oriented_circleC2(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
  }
};

struct Side_of_sphere
{
  static constexpr const char* name = "in sphere";
  static constexpr int degree = 5;
  static double bits(int b) { return 5 * b + 6.2; }

  template <class T>
  static int sign(const std::vector<T>& v)
  {
    return CGAL::side_of_oriented_sphereC3(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8],
                                           v[9], v[10], v[11], v[12], v[13], v[14]);
  }
};

using Place_2 = std::array<std::int64_t, 2>;

// All lattice points on a circle around (range / 2, range / 2). Its radius is, but for a factor, a
// product of primes that are sums of two squares, so that there are many.
inline std::vector<Place_2> lattice_circle(std::int64_t range)
{
  const std::int64_t half = range / 2;
  std::int64_t radius = 1;
  for(std::int64_t prime : {5, 13, 17, 29, 37, 41})
    if(radius * prime < half)
      radius *= prime;
  radius *= (half - 1) / radius;
  std::vector<Place_2> circle;
  for(std::int64_t x = -radius; x <= radius; ++x) {
    const std::int64_t square = radius * radius - x * x; // below 2^53: its root is exact or far off
    const auto y = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
    if(y * y == square) {
      circle.push_back({half + x, half - y});
      if(y != 0)
        circle.push_back({half + x, half + y});
    }
  }
  return circle;
}

class Question_generator
{
public:
  Question_generator(int bits, std::uint64_t seed)
    : random_(seed), range_(std::int64_t(1) << bits)
  {}

  Question uniform(std::size_t numbers)
  {
    Question v(numbers);
    for(double& x : v)
      x = static_cast<double>(below(range_));
    return v;
  }

  // Equal, or one apart.
  Question near(Compare_x)
  {
    const std::int64_t x = 1 + below(range_ - 2);
    return numbers({x, x + below(3) - 1});
  }

  // Exact ties, by Pythagoras; or the lattice points next to the circle.
  Question near(Compare_distance)
  {
    const std::array<std::int64_t, 3> t = below(2) == 0 ? pythagorean() : next_to_circle();
    const std::int64_t x = below(range_ - t[0]), y = below(range_ - t[1]);
    return numbers({x, y + t[1], x + t[0], y, t[2]});
  }

  Question near(Compare_distance_of_disks)
  {
    Question v = near(Compare_distance());
    const double part = static_cast<double>(below(static_cast<std::int64_t>(v[4])));
    v[4] -= part;
    v.push_back(part);
    return v;
  }

  // Four lattice points on a circle; the last one is moved by one along an axis, or not.
  Question near(Side_of_circle)
  {
    if(circle_.empty())
      circle_ = lattice_circle(range_);
    const auto size = static_cast<std::int64_t>(circle_.size());
    std::vector<Place_2> chosen;
    add_distinct(4, chosen, [&] { return circle_[below(size)]; });
    return moved(chosen);
  }

  Question near(Side_of_circle_by_products) { return near(Side_of_circle()); }

  // Five of the 48 points that permutations and signs make of (x, y, z), the last one moved.
  Question near(Side_of_sphere)
  {
    const std::int64_t half = range_ / 2;
    Place<3> corner;
    for(std::int64_t& x : corner)
      x = 1 + below(half - 2);
    std::vector<Place<3>> chosen;
    add_distinct(5, chosen, [&] {
      Place<3> p = corner;
      std::swap(p[2], p[below(3)]);
      std::swap(p[1], p[below(2)]);
      for(std::int64_t& x : p)
        x = half + (below(2) == 0 ? x : -x);
      return p;
    });
    return moved(chosen);
  }

private:
  template <std::size_t Dimension>
  using Place = std::array<std::int64_t, Dimension>;

  std::int64_t below(std::int64_t n)
  {
    return static_cast<std::int64_t>(random_.below(static_cast<std::size_t>(n)));
  }

  static Question numbers(const std::vector<std::int64_t>& integers)
  {
    return Question(integers.begin(), integers.end());
  }

  // (x, y, r) with x^2 + y^2 = r^2, r odd and in the upper half of the range.
  std::array<std::int64_t, 3> pythagorean()
  {
    const std::int64_t most = static_cast<std::int64_t>(std::sqrt(static_cast<double>(range_) / 2));
    for(;;) {
      const std::int64_t m = 2 + below(most - 2), n = 1 + below(m - 1);
      if((m + n) % 2 == 0 || std::gcd(m, n) != 1)
        continue;
      const std::int64_t r = m * m + n * n;
      std::int64_t factor = (range_ - 1) / r;
      factor -= 1 - factor % 2; // odd
      if(factor > 0 && factor * r >= range_ / 2)
        return {factor * (m * m - n * n), factor * 2 * m * n, factor * r};
    }
  }

  // (x, y, r) with y the integer next to the root of r^2 - x^2.
  std::array<std::int64_t, 3> next_to_circle()
  {
    const std::int64_t r = range_ / 2 + below(range_ / 2), x = below(r);
    const double y = std::nearbyint(std::sqrt(static_cast<double>(r * r - x * x)));
    return {x, static_cast<std::int64_t>(y), r};
  }

  template <std::size_t Dimension, class Draw>
  static void add_distinct(std::size_t count, std::vector<Place<Dimension>>& chosen,
                           const Draw& draw)
  {
    while(chosen.size() < count) {
      const Place<Dimension> p = draw();
      if(std::find(chosen.begin(), chosen.end(), p) == chosen.end())
        chosen.push_back(p);
    }
  }

  template <std::size_t Dimension>
  Question moved(std::vector<Place<Dimension>>& points)
  {
    points.back()[below(Dimension)] += below(3) - 1;
    Question v;
    for(const Place<Dimension>& p : points)
      v.insert(v.end(), p.begin(), p.end());
    return v;
  }

  Random random_;
  std::int64_t range_;
  std::vector<Place_2> circle_;
};

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_NEAR_DEGENERATE_H
