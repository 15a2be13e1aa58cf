// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Families of segments with radii that touch, or nearly do; and those of open triangles and
// tetrahedra, and of solids, which share vertices, edges and planes, or are in each other.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_THICK_FAMILIES_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_THICK_FAMILIES_H

#include "near_contacts.h"
#include "object_families.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace lab {

// ---- capsules -----------------------------------------------------------------------------------

inline Place moved(const Place& p, const Place& direction, std::int64_t steps)
{
  return {p[0] + steps * direction[0], p[1] + steps * direction[1], p[2] + steps * direction[2]};
}

// The columns of the rotation of a quaternion of integers, times its square. A rotation of the
// plane has two of its numbers.
struct Orthogonal_vectors
{
  std::array<Place, 3> axes;
  std::int64_t length;

  // The numbers are not zero, and at most `largest`.
  Orthogonal_vectors(const Kind& kind, std::size_t largest, Random& random)
  {
    const bool is_plane = kind.dimension == 2;
    const auto number = [&] { return 1 + static_cast<std::int64_t>(random.below(largest)); };
    const std::int64_t a = number(), b = is_plane ? 0 : number(), c = is_plane ? 0 : number(),
                       d = number();
    length = a * a + b * b + c * c + d * d;
    axes = {{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
             {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
             {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}}};
  }
};

// Pairs of segments whose distance is an integer that is known.
class Segment_pairs
{
public:
  // Coordinates are less than 2^bits, which is 10 or 16, or less than 0.
  Segment_pairs(const Kind& kind, std::uint64_t seed, int bits)
    : kind_(kind), bits_(bits), random_(seed)
  {}

  struct Pair
  {
    Places first, second;
    std::int64_t distance;
  };

  // Perpendicular vectors of one length make the segments, which are at a multiple of it. If they
  // are parallel, their distance is that of many of their points.
  Pair pair(bool are_parallel)
  {
    const Orthogonal_vectors vectors(kind_, bits_ < 16 ? 2 : 8, random_);
    const std::array<Place, 3>& axes = vectors.axes;
    const std::int64_t height = 2 + below(4);
    Place corner = {};
    for(int axis = 0; axis < kind_.dimension; ++axis)
      corner[axis] = below(std::size_t(1) << (bits_ - 1));
    const std::size_t across = kind_.dimension == 2 ? 1 : 2; // the axis of the distance
    const Place foot = moved(corner, axes[across], height);
    const Place& along = axes[are_parallel ? 0 : 1];
    const std::int64_t back = kind_.dimension == 2 && !are_parallel ? 0 : 1 + below(3);
    return {{moved(corner, axes[0], -1 - below(3)), moved(corner, axes[0], 1 + below(3))},
            {moved(foot, along, -back), moved(foot, along, 1 + below(3))},
            height * vectors.length};
  }

private:
  std::int64_t below(std::size_t count) { return static_cast<std::int64_t>(random_.below(count)); }

  Kind kind_;
  int bits_;
  Random random_;
};

// The radii of a pair at a distance, in steps of a unit.
using Radii = std::array<double, 2>;

inline void add_capsule(Object_set& set, const Places& places, double unit, double radius)
{
  for(const Place& p : places)
    for(std::size_t axis = 0; axis < static_cast<std::size_t>(set.kind.dimension); ++axis)
      set.numbers.push_back(unit * static_cast<double>(p[axis]));
  set.radii.push_back(radius);
}

// Adds two capsules with the radii radii_of(distance, random).
template <class Radii_of>
void add_touching_capsules(Object_set& set, const Segment_pairs::Pair& pair, double unit,
                           const Radii_of& radii_of, Random& random)
{
  const Radii radii = radii_of(unit * static_cast<double>(pair.distance), random);
  add_capsule(set, pair.first, unit, radii[0]);
  add_capsule(set, pair.second, unit, radii[1]);
}

template <class Radii_of>
Object_set touching_capsules(const Kind& kind, const std::string& family, double unit,
                             bool are_parallel, const Radii_of& radii_of)
{
  Object_set set = {kind, family, {}};
  Segment_pairs pairs(kind, family.size(), 16);
  Random random(family.size());
  while(set.size() < objects_per_family)
    add_touching_capsules(set, pairs.pair(are_parallel), unit, radii_of, random);
  return set;
}

// They touch.
inline Radii halves(double distance, Random&)
{
  return {std::floor(distance / 3), distance - std::floor(distance / 3)};
}

// They touch, or are nearer or farther by one.
inline Radii off_by_one(double distance, Random& random)
{
  Radii radii = halves(distance, random);
  radii[1] += static_cast<double>(random.below(3)) - 1;
  return radii;
}

// Their rounded sum is the distance, and often not their sum.
inline Radii with_a_rounded_sum(double distance, Random& random)
{
  const double first = distance * random.uniform() / 1024;
  return {first, distance - first};
}

inline Object_set general_capsules(const Kind& kind)
{
  Object_set set = Family_maker(kind).general();
  Random random(1);
  for(std::size_t i = 0; i < set.size(); ++i)
    set.radii.push_back(0.1 * random.uniform());
  return set;
}

// Each number stays, or goes to the next double up or down.
inline void shift_by_an_ulp(std::vector<double>& numbers, Random& random)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for(double& x : numbers)
    if(const std::size_t choice = random.below(3); choice != 0)
      x = std::nextafter(x, choice == 1 ? infinity : -infinity);
}

inline Object_set shifted_capsules(Object_set set)
{
  Random random(2);
  shift_by_an_ulp(set.numbers, random);
  shift_by_an_ulp(set.radii, random);
  return set;
}

inline Object_set without_radii(Object_set set)
{
  set.radii.assign(set.size(), 0);
  return set;
}

// The unit of 17 bits makes integers of 32 to 33 bits, whose products no double holds.
inline std::vector<Object_set> capsule_families(const Kind& kind)
{
  constexpr double unit = 0x19E37p0;
  Family_maker make(kind);
  return {
    general_capsules(kind),
    touching_capsules(kind, "touching, small integers", 1, false, halves),
    touching_capsules(kind, "touching, 33 bits", unit, false, halves),
    touching_capsules(kind, "parallel, 33 bits", unit, true, halves),
    touching_capsules(kind, "off by a step", unit, false, off_by_one),
    touching_capsules(kind, "radii that tie", 1, false, with_a_rounded_sum),
    shifted_capsules(touching_capsules(kind, "shifted by an ulp", unit, false, halves)),
    without_radii(make.lattice("radius zero", {1, 1, 1})),
  };
}

// ---- capsules of integers -----------------------------------------------------------------------

// Questions about the capsules 2i and 2i + 1, of integers of so many bits: 10, 16 or 24.
inline Object_set capsule_pairs(const Kind& kind, int bits, bool are_near, std::size_t count)
{
  Object_set set = {kind, are_near ? "contacts" : "random", {}};
  Segment_pairs pairs(kind, static_cast<std::uint64_t>(bits), bits < 16 ? 10 : 16);
  Contact_generator generator(kind, bits, static_cast<std::uint64_t>(bits));
  Random random(static_cast<std::uint64_t>(bits));
  while(set.size() < 2 * count)
    if(are_near)
      add_touching_capsules(set, pairs.pair(random.below(4) == 0), bits == 24 ? 251 : 1,
                            off_by_one, random);
    else {
      const auto [a, b] = generator.random_pair();
      for(const Places* places : {&a, &b})
        add_capsule(set, *places, 1, static_cast<double>(random.below(std::size_t(1) << bits) / 8));
    }
  return set;
}

// ---- all ----------------------------------------------------------------------------------------

// No object is degenerate.
inline std::vector<Object_set> thick_families(const Kind& kind)
{
  if(kind.meaning == Meaning::THICK)
    return capsule_families(kind);
  constexpr double odd = 0x19E3779B97F5p0;
  const std::string tilted = kind.dimension == 2 ? "tilted line" : "tilted plane";
  Family_maker make(kind);
  return {
    make.general(),
    make.shared_vertices(),
    make.lattice("small integers", {1, 1, 1}),
    make.lattice("50-bit integers", {odd, odd, odd}),
    make.nested("nested, common vertex", odd, false),
    make.nested("nested", odd, true),
    make.floor(),
    make.tilted(tilted + ", 50 bits", [=](std::int64_t i) { return odd * double(i); }),
    make.tilted(tilted + ", decimals", [](std::int64_t i) { return double(i) / 10; }),
    make.shifted_by_an_ulp("shifted by an ulp", 1),
  };
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_THICK_FAMILIES_H
