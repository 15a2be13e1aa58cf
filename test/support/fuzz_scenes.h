// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes full of ties, and what is near in them. All coordinates are integers times
// one unit, so a comparison of distances is a comparison of integers of 128 bits.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_FUZZ_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_FUZZ_SCENES_H

#include "pairs.h"
#include "point_generators.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace test_support {

using Wide_integer = boost::multiprecision::int128_t;
using Lattice_place = std::array<std::int64_t, 5>; // axes beyond the dimension are zero

// What the numbers of a kernel hold: integers below 2^digits, times 2^exponent.
struct Number_range
{
  int digits;
  int min_exponent;
  int max_exponent; // differences of coordinates may still overflow
};
inline constexpr Number_range range_of_doubles = {53, -1074, 970};
inline constexpr Number_range range_of_floats = {24, -149, 103};
inline constexpr Number_range range_of_integers = {53, 0, 0};

struct Fuzz_scene
{
  int dimension;
  int exponent; // the unit is 2^exponent
  std::vector<Lattice_place> places;

  std::size_t size() const { return places.size(); }
};

inline Wide_integer squared_distance(const Lattice_place& p, const Lattice_place& q)
{
  Wide_integer sum = 0;
  for(std::size_t axis = 0; axis < p.size(); ++axis) {
    const Wide_integer difference = Wide_integer(p[axis]) - q[axis];
    sum += difference * difference;
  }
  return sum;
}

// A distance in units, or a squared one.
struct Fuzz_bound
{
  Wide_integer value;
  bool is_squared;
  bool is_open;

  bool holds_for(const Wide_integer& squared_distance) const
  {
    const Wide_integer square = is_squared ? value : Wide_integer(value * value);
    return is_open ? squared_distance < square : squared_distance <= square;
  }
};

class Fuzz_drawer
{
public:
  Fuzz_drawer(std::uint64_t seed, const Number_range& range) : random_(seed), range_(range) {}

  Random& random() { return random_; }
  bool is_chance(std::size_t one_in) { return random_.below(one_in) == 0; }
  std::int64_t below(std::uint64_t count)
  {
    return static_cast<std::int64_t>(random_.below(count));
  }

  // Points on a coarse lattice, of which some are moved by a unit: ties, and what is next to them.
  // Few of them, or so many that there are several slabs, or more than are searched each with each.
  Fuzz_scene scene(int dimension)
  {
    Fuzz_scene scene = {dimension, exponent(), {}};
    const int shifts[] = {0, 0, 1, 3, range_.digits / 2, range_.digits - 6};
    shift_ = shifts[random_.below(6)];
    const std::size_t side = 1 + random_.below(1 + random_.below(14));
    Lattice_place offset = {};
    for(int axis = 0; axis < dimension; ++axis)
      offset[axis] = this->offset();
    const bool has_outliers = is_chance(8);
    const std::size_t move_one_in = is_chance(2) ? 5 : 1000;
    const std::size_t size = random_.below(is_chance(64) ? 300 : 20);
    for(std::size_t i = 0; i < size; ++i) {
      if(i > 0 && is_chance(10)) {
        scene.places.push_back(scene.places[random_.below(i)]);
        continue;
      }
      Lattice_place place = {};
      for(int axis = 0; axis < dimension; ++axis)
        place[axis] = (has_outliers && is_chance(8) ? 0 : offset[axis])
                      + (below(side) << shift_) + (is_chance(move_one_in) ? below(3) - 1 : 0);
      scene.places.push_back(place);
    }
    return scene;
  }

  // A length of some steps of the lattice, or about that.
  std::int64_t length(std::uint64_t count)
  {
    return (std::max)(std::int64_t(0),
                      (below(count) << shift_) + (is_chance(4) ? below(3) - 1 : 0));
  }

  // Mostly the distance of a pair, or next to it.
  Fuzz_bound bound(const Fuzz_scene& scene)
  {
    const bool is_open = is_chance(3);
    if(scene.size() < 2 || is_chance(3))
      return {length(8), false, is_open};
    const Wide_integer square = squared_distance(scene.places[random_.below(scene.size())],
                                                 scene.places[random_.below(scene.size())]);
    const Wide_integer root = sqrt(square);
    if(root < (Wide_integer(1) << range_.digits) && (root * root == square || is_chance(2)))
      return {root, false, is_open};
    return {square == 0 || is_chance(2) ? square : Wide_integer(square + below(3) - 1), true,
            is_open};
  }

  // Partners at about one distance, in a box whose extent is at a limit of narrow coordinates. The
  // points 2 i and 2 i + 1 are partners, and their distance is off by some units, or by about a
  // step of such coordinates. The first two are the corners of the box.
  Fuzz_scene scene_of_partners(int dimension)
  {
    Fuzz_scene scene = {dimension, is_chance(2) ? 0 : exponent(), {}};
    const auto [extent, distance] = extent_and_distance();
    Lattice_place low = {}, high = {};
    for(int axis = 0; axis < dimension; ++axis) {
      low[axis] = is_chance(2) ? 0 : below((std::uint64_t(1) << range_.digits) - extent);
      high[axis] = low[axis] + (axis > 0 && is_chance(4) ? below(extent + 1) : extent);
    }
    scene.places = {low, high};
    const std::int64_t step = 1 + (std::max)(extent >> 30, distance >> 25);
    for(std::size_t pairs = random_.below(8); pairs > 0; --pairs) {
      Lattice_place p = {}, q = {};
      Wide_integer left = (std::max)(Wide_integer(0), Wide_integer(distance + near_zero(step)));
      left *= left;
      for(int axis = 0; axis < dimension; ++axis) {
        const auto root = static_cast<std::int64_t>(sqrt(left));
        const std::int64_t gap
          = axis == dimension - 1 || is_chance(3) ? root : below(root + 1) / (1 + below(8));
        left -= Wide_integer(gap) * gap;
        p[axis] = low[axis] + below(high[axis] - low[axis] + 1);
        q[axis] = p[axis] + gap <= high[axis] ? p[axis] + gap : p[axis] - gap;
        q[axis] = (std::max)(q[axis] + (is_chance(3) ? near_zero(1) : 0), low[axis]);
        q[axis] = (std::min)(q[axis], high[axis]);
      }
      scene.places.push_back(p);
      scene.places.push_back(q);
    }
    return scene;
  }

  // The distance of partners, or next to it.
  Fuzz_bound bound_of_partners(const Fuzz_scene& scene)
  {
    const std::size_t i = scene.size() == 2 ? 0 : 2 + 2 * random_.below(scene.size() / 2 - 1);
    const Wide_integer square = squared_distance(scene.places[i], scene.places[i + 1]);
    const bool is_open = is_chance(3);
    if(is_chance(2))
      return {sqrt(square) + below(2), false, is_open};
    return {(std::max)(Wide_integer(square + near_zero(1)), Wide_integer(0)), true, is_open};
  }

private:
  // An extent, and the distance of partners in it: at the limits of the integers of a grid, whose
  // extent is at most 2^30 and whose reach is at most 2^24, with squares of 24 bits or more; and at
  // those of rounded numbers, from where the reach is a 32nd of the extent to where it is too
  // short.
  std::pair<std::int64_t, std::int64_t> extent_and_distance()
  {
    const int max_bits = range_.digits - 2;
    const int bits = static_cast<int>(random_.below(static_cast<std::size_t>(max_bits - 24)));
    const std::int64_t distances[]
      = {1, 64, 4096, 1 << 24, std::int64_t(1) << bits, (std::int64_t(1) << bits) * 3 / 2};
    const std::int64_t distance
      = (std::max)(distances[random_.below(6)] + near_zero(2), std::int64_t(1));
    const std::int64_t ratios[] = {1, 2, 31, 32, 33, 1 << 6, 1 << 17, (1 << 21) - 4, (1 << 21) - 3,
                                   (1 << 21) - 2, (1 << 21) + 1};
    const std::int64_t most = std::int64_t(1) << max_bits;
    const std::int64_t extent
      = near_zero(2) + (is_chance(4) ? 1 << 30 : ratios[random_.below(11)] * distance);
    return {(std::min)((std::max)(extent, std::int64_t(1)), most), distance};
  }

  // At most `size` up or down.
  std::int64_t near_zero(std::int64_t size)
  {
    return is_chance(2) ? below(3) - 1 : below(2 * size + 1) - size;
  }

  // Squares that overflow or vanish, numbers that do, and others.
  int exponent()
  {
    const int low = range_.min_exponent;
    const int high = range_.max_exponent;
    const int spread = static_cast<int>(random_.below(64));
    const int exponents[] = {0, 0, 0, -3, -spread, spread, low, high,
                             (std::min)(low + spread, high), (std::max)(high - spread, low),
                             low / 2 - spread / 2, high / 2 - spread / 2};
    return std::clamp(exponents[random_.below(12)], low, high);
  }

  std::int64_t offset()
  {
    const std::int64_t offsets[] = {0, 0, 0, -5, std::int64_t(1) << (range_.digits / 2),
                                    -(std::int64_t(1) << (range_.digits / 2)),
                                    std::int64_t(1) << (range_.digits - 1),
                                    -(std::int64_t(1) << (range_.digits - 1))};
    return offsets[random_.below(8)];
  }

  Random random_;
  Number_range range_;
  int shift_ = 0; // of the lattice of the last scene
};

inline Pairs near_places(const Fuzz_scene& scene, const Fuzz_bound& bound,
                         std::optional<std::size_t> first_set_size = std::nullopt)
{
  return pairs_where(scene.size(), first_set_size, [&](std::size_t i, std::size_t j) {
    return bound.holds_for(squared_distance(scene.places[i], scene.places[j]));
  });
}

// The lexicographically smallest pair of those at the least distance.
inline Pair closest_places(const Fuzz_scene& scene)
{
  Pair closest(0, 1);
  Wide_integer least = squared_distance(scene.places[0], scene.places[1]);
  for(std::size_t i = 0; i < scene.size(); ++i)
    for(std::size_t j = i + 1; j < scene.size(); ++j) {
      const Wide_integer square = squared_distance(scene.places[i], scene.places[j]);
      if(square < least) {
        least = square;
        closest = Pair(i, j);
      }
    }
  return closest;
}

using Lattice_box = std::pair<Lattice_place, Lattice_place>; // the lower and the upper ends

inline bool do_boxes_meet(const Lattice_box& a, const Lattice_box& b, int dimension, bool is_closed)
{
  for(int axis = 0; axis < dimension; ++axis) {
    const std::int64_t low = (std::max)(a.first[axis], b.first[axis]);
    const std::int64_t high = (std::min)(a.second[axis], b.second[axis]);
    if(is_closed ? low > high : low >= high)
      return false;
  }
  return true;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_FUZZ_SCENES_H
