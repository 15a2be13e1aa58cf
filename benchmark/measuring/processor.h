// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The name and the family of the processor, as Linux tells them.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_PROCESSOR_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_PROCESSOR_H

#include <fstream>
#include <string>

namespace thick_benchmark {

inline std::string processor()
{
  std::ifstream in("/proc/cpuinfo");
  std::string family; // the name of a virtual processor may not tell one generation from another
  for(std::string line; std::getline(in, line);) {
    if(line.rfind("cpu family", 0) == 0)
      family = ", family " + line.substr(line.find(':') + 2);
    if(line.rfind("model name", 0) == 0)
      return line.substr(line.find(':') + 2) + family;
  }
  return "unknown";
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_PROCESSOR_H
