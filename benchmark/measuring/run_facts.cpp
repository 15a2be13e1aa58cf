// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run_facts.h"

#include "processor.h"

#include <thick_benchmark_commit.h> // written by the build

#include <CGAL/version.h>

#include <boost/version.hpp>

#include <unistd.h>

#include <chrono>
#include <ctime>
#include <ostream>
#include <thread>

namespace thick_benchmark {

namespace {

std::string memory()
{
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES))
                       * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::to_string(static_cast<int>(bytes / (1 << 30) + 0.5)) + " GiB";
}

std::string today()
{
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  char text[11];
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::gmtime(&now));
  return text;
}

std::string compiler()
{
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

} // namespace

std::vector<Run_fact> run_facts()
{
  return {{"date", today()},
          {"commit", THICK_BENCHMARK_COMMIT},
          {"processor", processor()},
          {"threads of the machine", std::to_string(std::thread::hardware_concurrency())},
          {"memory", memory()},
          {"compiler", compiler()},
          {"flags", THICK_BENCHMARK_FLAGS},
          {"CGAL", CGAL_VERSION_STR},
          {"Boost", BOOST_LIB_VERSION}};
}

void print_run_facts(std::ostream& out)
{
  for(const Run_fact& fact : run_facts())
    out << "- " << fact.name << ": " << fact.value << '\n';
}

} // namespace thick_benchmark
