// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// near_pairs: reports every pair of points of a file that are within a distance of each other.
// Reads the options and the file, searches, writes the outputs, and prints a summary.

#include "error.h"
#include "options.h"
#include "outputs.h"
#include "picture.h"
#include "point_file.h"
#include "search.h"

#include <sys/resource.h>

#include <csignal>
#include <exception>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace near_pairs {
namespace {

Search_result search(const Scene& scene, const Options& options, const Pair_sink& sink)
{
  if(options.kernel == "double")
    return search_double(scene, options, sink);
  if(options.kernel == "epeck")
    return search_epeck(scene, options, sink);
  if(options.kernel == "exact")
    return search_exact(scene, options, sink);
  return search_epick(scene, options, sink);
}

// Returns nothing if the name is empty.
std::unique_ptr<Output_file> open_output(const std::string& name, const Options& options)
{
  return name.empty() ? nullptr : std::make_unique<Output_file>(name, options.file);
}

// The most memory that this process ever had, in MiB.
double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.; // Linux counts in KiB
}

std::string distance_in_words(const Scene& scene, const Options& options)
{
  std::string words = options.open ? "< " : "\u2264 ";
  words += options.squared ? "sqrt(" + options.distance_text + ")" : options.distance_text;
  if(!scene.unit.empty())
    words += " " + scene.unit;
  return words;
}

void print_summary(std::ostream& out, const Scene& scene, const Options& options,
                   const Search_result& result)
{
  const auto line = [&](const char* name) -> std::ostream& {
    return out << std::left << std::setw(13) << name;
  };
  line("points") << scene.size() << '\n';
  line("pairs") << result.pairs << '\n';
  if(!options.open)
    line("on boundary") << result.on_boundary << '\n';
  line("distance") << distance_in_words(scene, options) << '\n';
  line("kernel") << options.kernel << (options.parallel ? ", parallel" : "") << '\n';
  line("arithmetic") << result.tier << '\n';
  out << std::fixed << std::setprecision(6);
  line("search") << result.seconds << " s, with its outputs\n";
  out << std::setprecision(1);
  line("peak memory") << peak_memory() << " MiB\n";
}

// Lets an interrupted search end by an error, so that no temporary file stays. A pipe that nobody
// reads is an error as well.
void catch_signals()
{
  const auto stop = [](int signal) {
    stop_requested = true;
    std::signal(signal, SIG_DFL); // the second one ends the program at once
  };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  std::signal(SIGPIPE, SIG_IGN);
}

void run(const Options& options)
{
  const Scene scene = read_scene(options);
  catch_signals();
  const auto pairs_file = open_output(options.pairs, options);
  const auto picture_file = open_output(options.picture, options);
  std::optional<Pair_table> table;
  if(pairs_file)
    table.emplace(pairs_file->stream(), scene);
  std::optional<Picture> picture;
  if(picture_file)
    picture.emplace(scene, options, distance_in_words(scene, options));

  const Search_result result = search(scene, options, [&](std::size_t i, std::size_t j) {
    if(table)
      table->add(i, j);
    if(picture)
      picture->add_pair(i, j);
  });

  if(picture) {
    picture->write(picture_file->stream());
    picture_file->commit();
  }
  if(pairs_file)
    pairs_file->commit();
  std::ostream& out = options.pairs == "-" ? std::cerr : std::cout;
  if(options.explain)
    out << result.profile << '\n';
  print_summary(out, scene, options, result);
}

} // namespace
} // namespace near_pairs

int main(int argc, char** argv)
{
  try {
    const near_pairs::Options options = near_pairs::parse_options(argc, argv);
    if(options.help)
      std::cout << near_pairs::help_text();
    else
      near_pairs::run(options);
    return 0;
  }
  catch(const std::exception& error) {
    std::cerr << "near_pairs: " << error.what() << '\n';
    return 2;
  }
}
