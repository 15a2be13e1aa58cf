// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Families of segments, triangles and tetrahedra about which predicates go wrong: objects that
// touch, that are in one plane or nearly so, that are degenerate, and of extreme exponents.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_FAMILIES_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_FAMILIES_H

#include "object_sets.h"

#include "support/hull_oracle.h"
#include "support/point_generators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace lab {

using test_support::Random;

// ---- lattices -----------------------------------------------------------------------------------

using Place = test_support::Hull_vector<std::int64_t>;
using Places = std::vector<Place>; // the vertices of an object
using test_support::cross;
using test_support::difference;
using test_support::dot;

// Of small integers. The last coordinate of places in the plane is zero.
inline bool is_degenerate(const Places& object)
{
  const Place u = difference(object[1], object[0]);
  if(object.size() == 2)
    return u == Place{};
  const Place normal = cross(u, difference(object[2], object[0]));
  return object.size() == 3 ? normal == Place{}
                            : dot(normal, difference(object[3], object[0])) == 0;
}

constexpr std::size_t objects_per_family = 300;

// Objects with vertices in cells of 3 steps, so that vertices lie on vertices, edges and faces of
// others.
class Lattice_objects
{
public:
  Lattice_objects(const Kind& kind, std::uint64_t seed) : kind_(kind), random_(seed) {}

  Places any()
  {
    Place corner = {};
    for(int axis = 0; axis < kind_.dimension; ++axis)
      corner[axis] = below(kind_.dimension == 2 ? 18 : 7);
    Places object(static_cast<std::size_t>(kind_.vertices), corner);
    for(Place& vertex : object)
      for(int axis = 0; axis < kind_.dimension; ++axis)
        vertex[axis] += below(4);
    return object;
  }

  // Half of the objects or more are degenerate: all vertices are equal, on a line, or in a plane.
  Places any_with_degenerate()
  {
    Places object = any();
    const std::int64_t choice = below(4);
    const Place& first = object[0];
    const Place step = difference(object[1], first);
    for(std::size_t k = 1; k < object.size() && choice > 0; ++k)
      if(choice < 3 || k == 3)
        for(std::size_t axis = 0; axis < 3; ++axis)
          object[k][axis] = choice == 1   ? first[axis]
                            : choice == 2 ? first[axis] + (below(3) - 1) * step[axis]
                                          : object[1][axis] + object[2][axis] - first[axis];
    return object;
  }

  std::vector<Places> objects(bool are_degenerate)
  {
    std::vector<Places> result;
    while(result.size() < objects_per_family) {
      const Places object = are_degenerate ? any_with_degenerate() : any();
      if(are_degenerate || !is_degenerate(object))
        result.push_back(object);
    }
    return result;
  }

private:
  std::int64_t below(std::size_t count) { return static_cast<std::int64_t>(random_.below(count)); }

  Kind kind_;
  Random random_;
};

// ---- families -----------------------------------------------------------------------------------

class Family_maker
{
public:
  explicit Family_maker(const Kind& kind) : kind_(kind), random_(kind.name.size()) {}

  // The sizes make some boxes meet, and about half of these objects or fewer.
  Object_set general()
  {
    const double size = kind_.dimension == 2 ? 0.15 : 0.35;
    return of_vertices("general", [=](const Place& corner, Random& random, int axis) {
      return 0.1 * static_cast<double>(corner[axis]) + size * random.uniform();
    });
  }

  // Vertices are corners of a lattice, each moved at random, and no two of an object are the same.
  Object_set shared_vertices()
  {
    const std::size_t side = kind_.dimension == 2 ? 12 : 5, corners = side + 1;
    const auto moved = test_support::uniform_points(3, corners * corners * corners, 0, 0.8, 1);
    Object_set set = {kind_, "shared vertices", {}};
    for(std::size_t i = 0; i < objects_per_family; ++i) {
      std::array<std::size_t, 8> order = {0, 1, 2, 3, 4, 5, 6, 7}; // corners of a cell
      const std::size_t count = kind_.dimension == 2 ? 4 : 8;
      for(std::size_t k = count; k > 1; --k)
        std::swap(order[k - 1], order[random_.below(k)]);
      const Place cell = {below(side), below(side), kind_.dimension == 2 ? 0 : below(side)};
      for(int v = 0; v < kind_.vertices; ++v) {
        const auto bits = static_cast<std::int64_t>(order[static_cast<std::size_t>(v)]);
        const Place p = {cell[0] + bits % 2, cell[1] + bits / 2 % 2, cell[2] + bits / 4};
        const auto width = static_cast<std::int64_t>(corners);
        const auto& offset = moved[static_cast<std::size_t>((p[2] * width + p[1]) * width + p[0])];
        for(std::size_t axis = 0; axis < static_cast<std::size_t>(kind_.dimension); ++axis)
          set.numbers.push_back(static_cast<double>(p[axis]) + offset[axis]);
      }
    }
    return set;
  }

  // Lattice points, times a unit along each axis.
  Object_set lattice(const std::string& name, const std::array<double, 3>& units,
                     bool are_degenerate = false)
  {
    Object_set set = {kind_, name, {}};
    for(const Places& object : Lattice_objects(kind_, 1).objects(are_degenerate))
      for(const Place& vertex : object)
        for(std::size_t axis = 0; axis < static_cast<std::size_t>(kind_.dimension); ++axis)
          set.numbers.push_back(static_cast<double>(vertex[axis]) * units[axis]);
    return set;
  }

  // Of all vertices but perhaps the last one, one coordinate is that of a wall or a floor. The last
  // one of what has a vertex more than a line or plane holds is off it.
  Object_set floor()
  {
    const int height = kind_.dimension - 1;
    const int held = kind_.dimension == 2 ? 2 : 3;
    const double size = 0.3;
    Object_set set
      = of_vertices(kind_.dimension == 2 ? "on a line" : "floor",
                    [=](const Place& corner, Random& random, int axis) {
                      return axis == height ? 0.7 : 0.1 * double(corner[axis])
                                                      + size * random.uniform();
                    });
    for_each_vertex(set, [&](double* x, int v) {
      if(v >= held)
        x[height] += random_.uniform() - 0.5;
    });
    return set;
  }

  // As a floor, but tilted: (x, y) becomes (x, y, x + 2 y) in steps of a unit, and x becomes
  // (x, 3 x). What is off the plane is off by up to three steps.
  Object_set tilted(const std::string& name, const std::function<double(std::int64_t)>& in_unit)
  {
    const bool is_plane = kind_.dimension == 2;
    const int held = is_plane ? 2 : 3;
    Object_set set = {kind_, name, {}};
    while(set.size() < objects_per_family) {
      const Place corner = {below(is_plane ? 120 : 20), below(20), 0};
      Places object;
      for(int v = 0; v < kind_.vertices; ++v) {
        Place p = {corner[0] + below(4), is_plane ? 0 : corner[1] + below(4), 0};
        p[is_plane ? 1 : 2] = (is_plane ? 3 * p[0] : p[0] + 2 * p[1])
                              + (v < held ? 0 : below(7) - 3);
        object.push_back(p);
      }
      if(!is_degenerate(object))
        for(const Place& p : object)
          for(std::size_t axis = 0; axis < static_cast<std::size_t>(kind_.dimension); ++axis)
            set.numbers.push_back(in_unit(p[axis]));
    }
    return set;
  }

  // Each coordinate of touching objects stays, or goes to the next double up or down. Next to zero
  // this is 2^-1074.
  Object_set shifted_by_an_ulp(const std::string& name, double offset)
  {
    Object_set set = lattice(name, {1, 1, 1});
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for(double& x : set.numbers) {
      const std::size_t choice = random_.below(3);
      x += offset;
      x = choice == 0 ? x : std::nextafter(x, choice == 1 ? infinity : -infinity);
    }
    return set;
  }

  // Every other object is in the one before it, and has a vertex of it, or lies inside of it.
  Object_set nested(const std::string& name, double unit, bool is_inside)
  {
    Object_set set = {kind_, name, {}};
    const std::vector<Places> all = Lattice_objects(kind_, 2).objects(false);
    for(std::size_t i = 0; i < all.size(); ++i)
      for(const Place& vertex : all[i - i % 2])
        for(std::size_t axis = 0; axis < static_cast<std::size_t>(kind_.dimension); ++axis) {
          std::int64_t sum = 0; // the center, times the number of vertices
          for(const Place& p : all[i - i % 2])
            sum += p[axis];
          const std::int64_t x = kind_.vertices * vertex[axis],
                             center = is_inside ? sum : kind_.vertices * all[i - i % 2][0][axis];
          set.numbers.push_back(unit * static_cast<double>(i % 2 == 0 ? 2 * x : center + x));
        }
    return set;
  }

private:
  std::int64_t below(std::size_t count) { return static_cast<std::int64_t>(random_.below(count)); }

  // Of coordinate(corner, random, axis), where the corner is one of ten along each axis.
  Object_set
  of_vertices(const std::string& name,
              const std::function<double(const Place&, Random&, int)>& coordinate)
  {
    Object_set set = {kind_, name, {}};
    for(std::size_t i = 0; i < objects_per_family; ++i) {
      const Place corner = {below(10), below(10), below(10)};
      for(int v = 0; v < kind_.vertices; ++v)
        for(int axis = 0; axis < kind_.dimension; ++axis)
          set.numbers.push_back(coordinate(corner, random_, axis));
    }
    return set;
  }

  // Calls f(coordinates, v) for vertex v of each object.
  template <class Function>
  void for_each_vertex(Object_set& set, const Function& f) const
  {
    const auto dimension = static_cast<std::size_t>(kind_.dimension);
    for(std::size_t i = 0; i < set.numbers.size(); i += dimension)
      f(&set.numbers[i], static_cast<int>(i / dimension) % kind_.vertices);
  }

  Kind kind_;
  Random random_;
};

// All families of a kind. The odd unit of 45 bits makes integers of 50 bits, whose products no
// double holds.
inline std::vector<Object_set> object_families(const Kind& kind)
{
  constexpr double odd = 0x19E3779B97F5p0;
  const auto units = [](double unit) { return std::array<double, 3>{unit, unit, unit}; };
  const auto scaled = [=](int exponent) { return units(std::ldexp(odd, exponent)); };
  const std::string tilted = kind.dimension == 2 ? "tilted line" : "tilted plane";
  Family_maker make(kind);
  return {
    make.general(),
    make.shared_vertices(),
    make.lattice("small integers", units(1)),
    make.lattice("50-bit integers", units(odd)),
    make.floor(),
    make.tilted(tilted + ", 50 bits", [=](std::int64_t i) { return odd * double(i); }),
    make.tilted(tilted + ", decimals", [](std::int64_t i) { return double(i) / 10; }),
    make.shifted_by_an_ulp("shifted by an ulp", 1),
    make.shifted_by_an_ulp("shifted, around zero", -4),
    make.lattice("degenerate", units(odd), true),
    make.lattice("steps of 2^-1074", units(std::numeric_limits<double>::denorm_min())),
    make.lattice("50 bits, 2^-400", scaled(-400)),
    make.lattice("50 bits, 2^400", scaled(400)),
    make.lattice("50 bits, 2^970", scaled(970)),
    make.lattice("mixed axes", {std::ldexp(odd, -1074), std::ldexp(odd, 970), odd}),
  };
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_OBJECT_FAMILIES_H
