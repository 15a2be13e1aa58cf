// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The tables of near_objects_table.

#ifndef THICK_INTERSECTION_BENCHMARK_COMPARE_NEAR_TABLES_H
#define THICK_INTERSECTION_BENCHMARK_COMPARE_NEAR_TABLES_H

#include "methods/near_methods.h"

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace thick_benchmark {

void print_near_times(std::size_t n, int rounds); // of n objects with about one near pair each
void print_wrong_pairs(std::size_t n);            // of scenes full of ties
void print_contacts(std::size_t n, int rounds);   // of two meshes of n faces each
void print_rays(std::size_t n, int rounds);       // of rays through up to n triangles

// ---- for all of them ----------------------------------------------------------------------------

// Those of other libraries that take the objects of a scene, as far as the libraries are there.
std::vector<Near_method> other_methods(const Near_scene& scene);

std::string name_of(const Near_scene& scene);

// One line of a table: a scene, a method, and figures.
template <class... Figure>
void print_line(const std::string& scene, const std::string& method, const Figure&... figure)
{
  std::cout << "| " << scene << " | " << method << " |";
  ((std::cout << ' ' << figure << " |"), ...);
  std::cout << std::endl;
}

// The head of a table, with the names of the figures.
template <class... Name>
void print_head(const std::string& scene, const Name&... name)
{
  print_line(scene, "method", name...);
  std::cout << "|---|---|";
  for(std::size_t k = 0; k < sizeof...(name); ++k)
    std::cout << "--:|";
  std::cout << std::endl;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_COMPARE_NEAR_TABLES_H
