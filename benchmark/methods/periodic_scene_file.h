// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A scene of points that repeats and its pairs, as files for other programs.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_PERIODIC_SCENE_FILE_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_PERIODIC_SCENE_FILE_H

#include "periodic_methods.h"

#include <cctype>
#include <fstream>
#include <stdexcept>

namespace thick_benchmark {

// Writes three files, for compare/periodic_rivals.py: the distance, the vectors and the name as
// text, the points as doubles, and for each pair its positions, offset and whether it is a tie.
inline void write_scene(const std::string& folder, const Periodic_scene& scene,
                        const Image_pairs& all, const std::vector<bool>& are_ties)
{
  std::string path = folder + '/' + scene.name;
  for(std::size_t k = folder.size() + 1; k < path.size(); ++k)
    if(std::isalnum(static_cast<unsigned char>(path[k])) == 0)
      path[k] = '_';
  std::ofstream facts(path + ".scene");
  facts.precision(17);
  facts << scene.r << '\n';
  for(const auto& v : scene.vectors)
    facts << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
  facts << scene.name << '\n';
  std::ofstream points(path + ".points", std::ios::binary);
  points.write(reinterpret_cast<const char*>(scene.points.data()),
               static_cast<std::streamsize>(scene.points.size() * sizeof(scene.points[0])));
  std::ofstream pairs(path + ".pairs", std::ios::binary);
  for(std::size_t k = 0; k < all.size(); ++k) {
    const auto& [i, j, o] = all[k];
    const std::int32_t row[] = {i, j, o[0], o[1], o[2], are_ties[k] ? 1 : 0};
    pairs.write(reinterpret_cast<const char*>(row), sizeof(row));
  }
  if(!facts || !points || !pairs)
    throw std::runtime_error("cannot write " + path);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_PERIODIC_SCENE_FILE_H
