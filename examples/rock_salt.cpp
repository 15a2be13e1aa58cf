// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The bonds of rock salt: sodium and chlorine in turn, 2.82 Angstrom apart. The cell of the crystal
// has eight atoms and repeats, so each atom has six neighbors, most of them across a face.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>
#include <array>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  std::vector<Kernel::Point_3> atoms;
  for(const double x : {0., 2.82})
    for(const double y : {0., 2.82})
      for(const double z : {0., 2.82})
        atoms.emplace_back(x, y, z);
  const Kernel::Iso_cuboid_3 cell(0, 0, 0, 5.64, 5.64, 5.64);
  int bonds = 0;
  CGAL::periodic_fixed_radius_near_neighbors(
    atoms, cell, CGAL::within_distance(2.82),
    [&](std::size_t, std::size_t, const std::array<int, 3>&) { ++bonds; });
  std::cout << bonds << " bonds, " << 2 * bonds / atoms.size() << " of each atom\n";
}
