// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Prints what near_pairs reads of files of features, for compare_features.py: a line of JSON for
// each file, which is a list of features or, if the file is refused, a string.

#include "error.h"
#include "feature.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <string>

namespace {

nlohmann::json read(const char* file)
{
  nlohmann::json features = nlohmann::json::array();
  std::string system;
  try {
    for(const near_pairs::Feature& feature :
        near_pairs::read_features(near_pairs::Input(file), {}, system))
      features.push_back({{"lines", feature.lines}, {"polygons", feature.polygons}});
  }
  catch(const near_pairs::Error& error) {
    return error.what();
  }
  return features;
}

} // namespace

int main(int argc, char** argv)
{
  for(int file = 1; file < argc; ++file)
    std::cout << read(argv[file]) << '\n';
}
