// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// near_objects_table: segments and triangles within a distance, two meshes that meet, and rays, by
// our searches and by what else there is: times, and how many pairs are wrong.

#include "near_tables.h"

#include "measuring/run_facts.h"

#include <boost/program_options.hpp>

#include <exception>

namespace thick_benchmark {

std::vector<Near_method> other_methods(const Near_scene& scene)
{
  const bool is_plane = scene.objects.dimension == 2;
  std::vector<Near_method> methods = {near_by_boxes(10), near_by_boxes(1000)};
  if(!is_plane)
    methods.push_back(near_by_aabb_tree());
#ifdef THICK_BENCHMARK_HAS_GEOS
  if(is_plane)
    methods.push_back(near_by_geos());
#endif
#ifdef THICK_BENCHMARK_HAS_EMBREE
  if(!is_plane)
    methods.push_back(near_by_embree());
#endif
#ifdef THICK_BENCHMARK_HAS_FCL
  if(!is_plane && scene.objects.shape == Shape::TRIANGLE)
    methods.push_back(near_by_fcl());
#endif
  return methods;
}

std::string name_of(const Near_scene& scene)
{
  return std::to_string(scene.objects.dimension) + "D "
         + (scene.objects.shape == Shape::SEGMENT ? "segments, " : "triangles, ") + scene.name;
}

} // namespace thick_benchmark

int main(int argc, char** argv)
try {
  using namespace thick_benchmark;
  namespace po = boost::program_options;
  po::options_description known("Options");
  known.add_options()("help", "print this text")(
    "quick", "few objects: to see that everything runs, not for figures");
  po::variables_map options;
  po::store(po::parse_command_line(argc, argv, known), options);
  if(options.count("help")) {
    std::cout << known;
    return 0;
  }
  print_run_facts(std::cout);
  std::cout << std::setprecision(3);
  const bool is_quick = options.count("quick") != 0;
  const int rounds = is_quick ? 1 : 7;
  print_near_times(is_quick ? 3000 : 300000, rounds);
  print_wrong_pairs(is_quick ? 300 : 3000);
  print_contacts(is_quick ? 3000 : 200000, rounds);
  print_rays(is_quick ? 2000 : 200000, rounds);
  return 0;
}
catch(const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
