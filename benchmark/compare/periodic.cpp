// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// periodic_table: points in a cube that repeats, by our search and by what simulations use.

#include "near_tables.h"

#include "measuring/run_facts.h"
#include "measuring/timing.h"
#include "methods/periodic_methods.h"
#include "methods/periodic_scene_file.h"

#include "support/point_generators.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

namespace thick_benchmark {

namespace {

// Points in the unit cube, about 10 pairs for each.
Periodic_scene uniform_scene(std::size_t n)
{
  constexpr double pi = 3.14159265358979323846;
  Periodic_scene scene = {"uniform, n = " + std::to_string(n), {}, {}, 0};
  for(const auto& c : test_support::uniform_points(3, n, 0, 1, 1))
    scene.points.push_back({c[0], c[1], c[2]});
  for(std::size_t k = 0; k < 3; ++k)
    scene.vectors[k][k] = 1;
  scene.r = std::cbrt(15 / (pi * static_cast<double>(n)));
  return scene;
}

std::vector<Periodic_method> methods()
{
  std::vector<Periodic_method> methods
    = {periodic_stored(), periodic_counted(), points_without_periods(), periodic_lists()};
#ifdef THICK_BENCHMARK_HAS_VESIN
  methods.push_back(vesin_half_list());
  methods.push_back(vesin_full_list());
#endif
  return methods;
}

Image_pairs sorted_pairs(const Periodic_method& method, const Periodic_scene& scene)
{
  Image_pairs pairs = method.prepare(scene).pairs();
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool are_equal(const Image_pairs& a, const Image_pairs& b)
{
  return a.size() == b.size()
         && std::equal(a.begin(), a.end(), b.begin(), [](const auto& p, const auto& q) {
              return !(p < q) && !(q < p);
            });
}

// Random points have no ties, so that methods agree, whether they are exact or not.
void check_pairs(const Periodic_scene& scene)
{
  const Image_pairs pairs = sorted_pairs(periodic_stored(), scene);
  for(const Periodic_method& method : methods())
    if(!are_equal(sorted_pairs(method, scene), pairs))
      throw std::runtime_error(method.name + " finds other pairs");
}

void print_times(std::size_t n, int rounds)
{
  const Periodic_scene scene = uniform_scene(n);
  check_pairs(scene);
  std::vector<Job> jobs;
  std::vector<std::size_t> counts;
  const std::vector<Periodic_method> all = methods();
  for(const Periodic_method& method : all) {
    const Periodic_run run = method.prepare(scene);
    counts.push_back(run.count());
    jobs.push_back(timed(run.count));
  }
  const std::vector<Seconds> times = time_in_turns(jobs, rounds, 0);
  for(std::size_t k = 0; k < all.size(); ++k)
    print_line(scene.name, all[k].name, counts[k],
               1000 * std::min_element(times.begin(), times.end(), [=](auto& s, auto& t) {
                        return s[k] < t[k];
                      })->at(k),
               median(times, [=](const Seconds& s) { return s[k] / s[0]; }),
               median(times, [=](const Seconds& s) { return s[k] / s[1]; }));
}

void write_scene(std::size_t n, const std::string& folder)
{
  const Periodic_scene scene = uniform_scene(n);
  const Image_pairs pairs = sorted_pairs(periodic_stored(), scene);
  write_scene(folder, scene, pairs, std::vector<bool>(pairs.size()));
}

} // namespace

} // namespace thick_benchmark

int main(int argc, char** argv)
try {
  using namespace thick_benchmark;
  namespace po = boost::program_options;
  po::options_description known("Options");
  known.add_options()("help", "print this text")(
    "quick", "few points: to see that everything runs, not for figures")(
    "write", po::value<std::string>(), "a folder: write the scenes there, and measure nothing");
  po::variables_map options;
  po::store(po::parse_command_line(argc, argv, known), options);
  if(options.count("help")) {
    std::cout << known;
    return 0;
  }
  const bool is_quick = options.count("quick") != 0;
  const std::vector<std::size_t> sizes
    = is_quick ? std::vector<std::size_t>{3000} : std::vector<std::size_t>{100000, 1000000};
  if(options.count("write")) {
    for(const std::size_t n : sizes)
      write_scene(n, options["write"].as<std::string>());
    return 0;
  }
  print_run_facts(std::cout);
  std::cout << std::setprecision(4) << '\n';
  print_head("scene", "found", "ms", "/ stored", "/ counted");
  for(const std::size_t n : sizes)
    print_times(n, is_quick ? 1 : 7);
  return 0;
}
catch(const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
