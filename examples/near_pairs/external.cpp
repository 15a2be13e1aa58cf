// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The option --memory; see external.h.

#include "external.h"

#include "error.h"
#include "hints.h"
#include "outputs.h"
#include "standard_streams.h"
#include "summary.h"

#include <filesystem>
#include <iostream>
#include <optional>
#include <ostream>
#include <string>

namespace near_pairs {
namespace {

// What is left of the memory that the user gives, without what the program has, and what the
// streams will have. The program's own differs from run to run, so the least that it names has one
// mebibyte to spare: who takes it at its word is not refused again.
std::size_t bytes_for_search(const Options& options)
{
  const double mebibyte = 1 << 20;
  const double own = (peak_memory() + 2) * mebibyte;
  const double least = 4 * mebibyte; // of the library
  if(static_cast<double>(options.memory) < own + least)
    throw Error("--memory: the program itself takes "
                + std::to_string(static_cast<int>((own + least) / mebibyte) + 2) + "M");
  return options.memory - static_cast<std::size_t>(own);
}

// What can be read only once is kept in memory by Input.
void check_input(const std::string& name)
{
  std::error_code error;
  if(!std::filesystem::exists(name, error))
    throw Error(name, "No such file or directory");
  if(!std::filesystem::is_regular_file(name, error))
    throw Error(name, "--memory is for a regular file: a pipe is kept in memory");
}

void print_summary(std::ostream& out, const Options& options, const External_result& result)
{
  print_name(out, "points") << result.points << '\n';
  print_guessed(out, {result.guessed});
  print_frames(out, {result.frame});
  print_name(out, "pairs") << result.pairs << '\n';
  print_name(out, "distance") << distance_in_words(options, result.unit) << '\n';
  print_name(out, "on boundary") << "not counted with --memory\n";
  print_kernel(out, options);
  print_costs(out, result.seconds, ", with reading and outputs");
}

} // namespace

void run_external(const Options& options)
{
  check_input(options.files.front());
  const std::size_t bytes = bytes_for_search(options);
  catch_signals();
  std::optional<Output_file> pairs;
  External_sink sink;
  if(!options.pairs.empty()) {
    pairs.emplace(options.pairs, options.files);
    pairs->stream() << "i,j\n";
    sink = [&](std::uint64_t i, std::uint64_t j) {
      if(!(pairs->stream() << i << ',' << j << '\n'))
        pairs->check();
    };
  }
  const External_result result = search_external(options, bytes, sink);
  if(pairs)
    pairs->commit();
  std::ostream& out = options.pairs == "-" ? std::cerr : std::cout;
  print_summary(out, options, result);
  finish(out, "the summary");
  print_degree_hints(std::cerr, options, result.unit == "deg");
  if(pairs)
    std::cerr << "near_pairs: hint: pairs are positions with --memory, without ids and distances\n";
}

} // namespace near_pairs
