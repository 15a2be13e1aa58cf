// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hulls of vertices on a lattice, as the oracles take them, and their vertices as doubles.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_LATTICE_HULLS_H
#define THICK_INTERSECTION_TEST_SUPPORT_LATTICE_HULLS_H

#include "hull_oracle.h"
#include "point_generators.h"

namespace test_support {

using Integers = Hull_vectors<std::int64_t>;

// `side` places along each axis, `step` apart, from `low` on.
struct Lattice
{
  std::size_t dimension;
  std::uint64_t side;
  std::int64_t low = 0, step = 1;
};

// The integers from -size to size.
inline Lattice lattice_around_origin(std::size_t dimension, std::int64_t size)
{
  return {dimension, static_cast<std::uint64_t>(2 * size + 1), -size};
}

inline Hull_vector<std::int64_t> lattice_point(Random& random, const Lattice& lattice)
{
  Hull_vector<std::int64_t> p = {};
  for(std::size_t axis = 0; axis < lattice.dimension; ++axis)
    p[axis] = lattice.low + lattice.step * static_cast<std::int64_t>(random.below(lattice.side));
  return p;
}

inline Integers lattice_hull(Random& random, const Lattice& lattice, std::size_t size)
{
  Integers vertices;
  while(vertices.size() < size)
    vertices.push_back(lattice_point(random, lattice));
  return vertices;
}

template <std::size_t Dimension>
std::array<double, Dimension> as_doubles(const Hull_vector<std::int64_t>& p, double unit = 1)
{
  std::array<double, Dimension> x;
  for(std::size_t axis = 0; axis < Dimension; ++axis)
    x[axis] = static_cast<double>(p[axis]) * unit;
  return x;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_LATTICE_HULLS_H
