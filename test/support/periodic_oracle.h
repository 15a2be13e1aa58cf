// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The near pairs of images of points in a lattice, by exact rationals and by trying all offsets.
// Vector k of the lattice has no component along the axes after k. So the last offset is bounded by
// the last axis, the one before it by its axis and the last offset, and so on: no offset is missed.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PERIODIC_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_PERIODIC_ORACLE_H

#include "exact_points.h"

namespace test_support {

template <int Dimension>
using Offset_of = std::array<int, static_cast<std::size_t>(Dimension)>;

template <int Dimension>
using Image_pair = std::tuple<std::size_t, std::size_t, Offset_of<Dimension>>;

template <int Dimension>
struct Lattice_scene
{
  Points points;
  std::array<std::array<Rational, Dimension>, Dimension> vectors = {};
  std::array<bool, Dimension> repeats = {};
  Rational square; // of the bound
  bool is_open = false;
};

inline Integer floor_of(const Rational& x)
{
  Integer quotient = numerator(x) / denominator(x);
  return quotient * denominator(x) > numerator(x) ? Integer(quotient - 1) : quotient;
}

template <int Dimension>
class Periodic_oracle
{
  using Difference = std::array<Rational, Dimension>;

public:
  explicit Periodic_oracle(const Lattice_scene<Dimension>& scene) : scene_(scene) {}

  // Returns the squared distance of a pair.
  Rational square(const Image_pair<Dimension>& pair) const
  {
    Difference d = difference(std::get<0>(pair), std::get<1>(pair));
    for(int k = 0; k < Dimension; ++k)
      subtract(d, k, std::get<2>(pair)[k]);
    Rational sum = 0;
    for(const Rational& x : d)
      sum += x * x;
    return sum;
  }

  // Returns the pairs i < j, or i = j with a positive offset, in ascending order.
  std::vector<Image_pair<Dimension>> pairs() const
  {
    std::vector<Image_pair<Dimension>> all;
    for(std::size_t i = 0; i < scene_.points.size(); ++i)
      for(std::size_t j = i; j < scene_.points.size(); ++j)
        add_pairs(i, j, {}, Dimension - 1, difference(i, j), all);
    std::sort(all.begin(), all.end());
    return all;
  }

private:
  Difference difference(std::size_t i, std::size_t j) const
  {
    Difference d;
    for(int axis = 0; axis < Dimension; ++axis)
      d[axis] = Rational(scene_.points[i][axis]) - Rational(scene_.points[j][axis]);
    return d;
  }

  void subtract(Difference& d, int k, int times) const
  {
    for(int axis = 0; axis < Dimension; ++axis)
      d[axis] -= times * scene_.vectors[k][axis];
  }

  // Tries all offsets along vector k, where `d` is the difference moved along the vectors after it.
  void add_pairs(std::size_t i, std::size_t j, Offset_of<Dimension> offset, int k,
                 const Difference& d, std::vector<Image_pair<Dimension>>& all) const
  {
    if(k < 0) {
      const Image_pair<Dimension> pair(i, j, offset);
      const Rational s = square(pair);
      if((i < j || offset > Offset_of<Dimension>{})
         && (scene_.is_open ? s < scene_.square : s <= scene_.square))
        all.push_back(pair);
      return;
    }
    if(!scene_.repeats[k]) {
      add_pairs(i, j, offset, k - 1, d, all);
      return;
    }
    // |d - o v| <= r along axis k, so o is within r / |v| of d / v.
    const Rational v = scene_.vectors[k][k];
    const Rational middle = d[k] / v;
    const int nearest = static_cast<int>(floor_of(middle));
    for(const int step : {-1, 1})
      for(int o = step < 0 ? nearest : nearest + 1;; o += step) {
        const Rational rest = d[k] - o * v;
        if(rest * rest > scene_.square)
          break;
        Difference moved = d;
        subtract(moved, k, o);
        offset[k] = o;
        add_pairs(i, j, offset, k - 1, moved, all);
      }
  }

  const Lattice_scene<Dimension>& scene_;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_PERIODIC_ORACLE_H
