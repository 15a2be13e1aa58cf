// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lines of summaries; see summary.h.

#include "summary.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <string>

namespace near_pairs {

double peak_memory()
{
  // Linux has it in KiB. getrusage() counts what the process that became this one had, as well.
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(double kibibytes; word == "VmHWM:" && status >> kibibytes)
      return kibibytes / 1024;
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.; // most systems count in KiB
}

std::string distance_in_words(const Options& options, const std::string& unit_of_scene)
{
  std::string words = options.open ? "< " : "\u2264 ";
  words += options.squared ? "sqrt(" + options.distance_text + ")" : options.distance_text;
  const std::string& unit
    = options.distance_unit.empty() ? unit_of_scene : options.distance_unit;
  return words + (unit.empty() ? "" : " ") + unit;
}

std::ostream& print_name(std::ostream& out, const char* name)
{
  return out << std::left << std::setw(13) << name;
}

void print_guessed(std::ostream& out, const std::vector<std::string>& columns_of_files)
{
  std::string list;
  for(const std::string& columns : columns_of_files)
    if(!columns.empty())
      list += (list.empty() ? "" : " and ") + columns;
  if(!list.empty())
    print_name(out, "columns") << list << " (guessed)\n";
}

void print_frames(std::ostream& out, const std::vector<Frame>& frames)
{
  const auto is_one = [](const Frame& frame) { return frame.count == 1; };
  if(std::all_of(frames.begin(), frames.end(), is_one))
    return;
  print_name(out, "frame");
  for(const Frame& frame : frames)
    out << (&frame == &frames.front() ? "" : " and ") << frame.number << " of " << frame.count;
  out << '\n';
}

void print_kernel(std::ostream& out, const Options& options)
{
  print_name(out, "kernel") << options.kernel << (options.parallel ? ", parallel" : "") << '\n';
}

void print_costs(std::ostream& out, double seconds, const char* of_what)
{
  out << std::fixed << std::setprecision(6);
  print_name(out, "search") << seconds << " s" << of_what << '\n';
  out << std::setprecision(1);
  print_name(out, "peak memory") << peak_memory() << " MiB\n";
}

} // namespace near_pairs
