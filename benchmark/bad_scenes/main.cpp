// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// bad_scenes: scenes that were bad once, and how much work per element and pair they take today.
//
//   bad_scenes [<search>]     measures those of one search, or all, with n, 4 n and 16 n elements
//
// It ends with status 1 if one of them takes more counted work than it may. Times are printed only.

#include "bad_scenes/Factors.h"

#include <exception>
#include <iomanip>
#include <iostream>

namespace thick_benchmark {
namespace {

const double most_counted = 12; // times as much as for uniform elements

// Returns whether the scene takes no more than it may.
bool measure(const std::string& line, Factors& factors)
{
  bool is_good = true;
  Recipe recipe = read_recipe(line);
  std::cout << line << std::endl;
  for(recipe.n = 4000; recipe.n <= 64000; recipe.n *= 4) {
    const std::optional<Factor> factor = factors.of(recipe);
    std::cout << "  n = " << recipe.n << ": ";
    if(factor)
      std::cout << "counted " << factor->counted << ", time " << factor->time << ", k/n "
                << factor->pairs << std::endl;
    else
      std::cout << "too many pairs" << std::endl;
    is_good = is_good && (!factor || factor->counted <= most_counted);
  }
  return is_good;
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
try {
  using namespace thick_benchmark;
  std::cout << std::setprecision(3);
  Factors factors;
  bool are_good = true;
  for(const char* line : known_recipes())
    if(argc < 2 || read_recipe(line).search == argv[1])
      are_good = measure(line, factors) && are_good;
  return are_good ? 0 : 1;
}
catch(const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
