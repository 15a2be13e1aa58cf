// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// bad_scenes: looks for scenes that take a search more work per element and pair than uniform ones.
//
//   bad_scenes --search near3 --seconds 600 --seed 7    prints its finds, a line each
//   bad_scenes --replay '<line>'                        measures a find again, at n, 4 n and 16 n
//   bad_scenes --known                                  measures those that were bad once

#include "bad_scenes/climb.h"
#include "bad_scenes/known_recipes.h"

#include <boost/program_options.hpp>

#include <iomanip>
#include <iostream>

namespace thick_benchmark {
namespace {

namespace po = boost::program_options;

po::options_description known_options()
{
  po::options_description options("Options");
  options.add_options()
    ("help", "print this text")
    ("search", po::value<std::string>()->default_value(""), "one search; else all, in turn")
    ("seconds", po::value<double>()->default_value(60), "for each search")
    ("seed", po::value<unsigned int>()->default_value(1), "of the mutations")
    ("n", po::value<std::size_t>()->default_value(4000), "objects; finds are measured at 4 n, too")
    ("above", po::value<double>()->default_value(8), "finds with a larger factor at 16 n are shown")
    ("from", po::value<std::string>(), "a line of text to start from, instead of the known scenes")
    ("replay", po::value<std::string>(), "a line of text: measure it at n, 4 n and 16 n")
    ("known", "measure the scenes that were bad once");
  return options;
}

void print(const Factor& factor)
{
  std::cout << "counted " << factor.counted << ", time " << factor.time << ", k/n "
            << factor.pairs;
}

void replay(Recipe recipe)
{
  std::cout << to_text(recipe) << std::endl;
  Factors factors;
  for(const std::size_t times : {1, 4, 4}) {
    recipe.n *= times;
    std::cout << "  n = " << recipe.n << ": ";
    print(factors.of(recipe, 5));
    std::cout << std::endl;
  }
}

void show(const Find& find)
{
  std::cout << to_text(find.recipe) << "\n  n: ";
  print(find.factor);
  std::cout << "\n  4 n: ";
  print(find.larger_factor);
  std::cout << std::endl;
}

void run(const po::variables_map& options)
{
  const std::size_t n = options["n"].as<std::size_t>();
  const std::string wanted = options["search"].as<std::string>();
  for(const Subject_search& search : all_searches()) {
    if(!wanted.empty() && search.name != wanted)
      continue;
    std::vector<Recipe> known = known_recipes(search.name, n);
    if(options.count("from"))
      known = {read_recipe(options["from"].as<std::string>())};
    if(options.count("known"))
      for(const Recipe& recipe : known)
        replay(recipe);
    else {
      Climb climb({search.name, n, options["seconds"].as<double>(), options["above"].as<double>()},
                  options["seed"].as<unsigned int>(), show);
      const Find best = climb.run(known);
      std::cout << "the worst of " << climb.count() << " scenes:\n";
      show(best);
    }
  }
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
try {
  using namespace thick_benchmark;
  po::variables_map options;
  po::store(po::parse_command_line(argc, argv, known_options()), options);
  po::notify(options);
  std::cout << std::setprecision(3);
  if(options.count("help"))
    std::cout << known_options();
  else if(options.count("replay"))
    replay(read_recipe(options["replay"].as<std::string>()));
  else
    run(options);
  return 0;
}
catch(const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
