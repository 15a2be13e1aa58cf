// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Groups of galaxies in a universe that repeats: friends are at most a linking length apart, and
// friends of friends are in one group. No boundary cuts a group, so a box with its corner elsewhere
// has the same groups.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/periodic_fixed_radius_near_neighbors.h>
#include <boost/pending/disjoint_sets.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <random>
#include <set>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr int side = 1000, linking_length = 15;

// Galaxies in clusters. What leaves the box enters it from the other side.
std::vector<Kernel::Point_3> galaxies_from_corner(int corner)
{
  std::mt19937 engine(1);
  const auto random = [&](int size) { return static_cast<int>(engine() % size); };
  std::vector<Kernel::Point_3> galaxies;
  for(int cluster = 0; cluster < 200; ++cluster) {
    const int x = corner + random(side), y = corner + random(side), z = corner + random(side);
    for(int i = 0; i < 100; ++i) {
      const int dx = random(50), dy = random(50), dz = random(50);
      galaxies.emplace_back((x + dx) % side, (y + dy) % side, (z + dz) % side);
    }
  }
  return galaxies;
}

// Counts groups, and returns the first galaxy of the group of each galaxy.
std::vector<std::size_t> find_groups(const std::vector<Kernel::Point_3>& galaxies)
{
  boost::disjoint_sets_with_storage<> sets(galaxies.size());
  std::vector<std::size_t> across; // a galaxy of each such pair
  const Kernel::Iso_cuboid_3 box(0, 0, 0, side, side, side);
  CGAL::periodic_fixed_radius_near_neighbors(
    galaxies, box, CGAL::within_distance(linking_length),
    [&](std::size_t i, std::size_t j, const std::array<int, 3>& offset) {
      sets.union_set(i, j);
      if(offset != std::array<int, 3>{})
        across.push_back(i);
    });
  std::vector<std::size_t> firsts(galaxies.size(), galaxies.size()), groups;
  for(std::size_t i = 0; i < galaxies.size(); ++i) {
    std::size_t& first = firsts[sets.find_set(i)];
    first = (std::min)(first, i);
    groups.push_back(first);
  }
  std::set<std::size_t> all(groups.begin(), groups.end()), crossing;
  for(std::size_t i : across)
    crossing.insert(groups[i]);
  std::cout << all.size() << " groups, " << crossing.size() << " across the boundary\n";
  return groups;
}

int main()
{
  const auto groups = find_groups(galaxies_from_corner(0));
  const bool are_same = groups == find_groups(galaxies_from_corner(side / 2));
  std::cout << (are_same ? "the same groups\n" : "other groups\n");
}
