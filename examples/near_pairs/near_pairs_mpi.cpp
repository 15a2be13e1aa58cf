// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// near_pairs_mpi: reports every pair of points of a file that are within a distance of each other,
// by several processes of MPI. Each process reads a share of the file, searches a box of space, and
// writes the pairs that it finds to a file of its own. The first process prints what each of them
// has done, as JSON.

#include "error.h"
#include "exact_number.h"
#include "file_share.h"
#include "rational.h"

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Remote_error.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/distributed_fixed_radius_near_neighbors.h>

#include <boost/program_options.hpp>

#include <mpi.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace near_pairs {
namespace {

namespace po = boost::program_options;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Phase = CGAL::Distributed_phase;

constexpr std::array<std::pair<Phase, const char*>, 5> phases
  = {{{Phase::CHECK, "check"}, {Phase::PARTITION, "partition"}, {Phase::MIGRATION, "migration"},
      {Phase::HALO, "halo"}, {Phase::SEARCH, "search"}}};

struct Arguments
{
  std::string file;
  CGAL::Exact_rational distance;
  bool open = false;
  bool as_is = false;
  std::string pairs; // the beginning of names of files; empty: pairs are only counted
};

// Returns nothing if the user asked for help.
std::optional<Arguments> parse_arguments(int argc, char** argv, std::ostringstream& help)
{
  Arguments arguments;
  std::string distance;
  po::options_description visible("mpiexec -n P near_pairs_mpi [options] FILE");
  visible.add_options()
    ("distance", po::value(&distance)->value_name("R"), "pairs at most R apart, exactly")
    ("open", po::bool_switch(&arguments.open), "strictly closer pairs only")
    ("as-is", po::bool_switch(&arguments.as_is), "leave points where they are read")
    ("pairs", po::value(&arguments.pairs)->value_name("NAME"),
     "write the pairs of each process to NAME.<rank>.csv")
    ("help", "print this text");
  po::options_description all;
  all.add(visible).add_options()("file", po::value(&arguments.file));
  po::variables_map map;
  po::store(po::command_line_parser(argc, argv).options(all)
              .positional(po::positional_options_description().add("file", 1)).run(), map);
  po::notify(map);
  help << visible;
  if(map.count("help"))
    return std::nullopt;
  const auto value = parse_exact(distance);
  if(arguments.file.empty() || !value || is_negative(*value))
    throw Error("give a file and --distance (--help lists the options)");
  arguments.distance = (*value)->value;
  return arguments;
}

// What this process has done, as an object of JSON. Names of files are not in it.
std::string json_of(int rank, const CGAL::Distributed_profile& profile, std::uint64_t pairs)
{
  std::ostringstream json;
  json << R"({"rank": )" << rank << R"(, "points": )" << profile.size_of_points()
       << R"(, "halo": )" << profile.size_of_halo() << R"(, "pairs": )" << pairs;
  for(const auto& [phase, name] : phases)
    json << R"(, "seconds_)" << name << R"(": )" << profile.seconds(phase);
  for(const auto& [phase, name] : phases)
    json << R"(, "bytes_sent_)" << name << R"(": )" << profile.bytes_sent(phase);
  json << '}';
  return json.str();
}

// Returns the texts of all processes on the first one.
std::vector<std::string> gather_texts(const std::string& text)
{
  int rank, size;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  int length = static_cast<int>(text.size());
  std::vector<int> lengths(size), begins(size + 1);
  MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  for(int i = 0; i < size; ++i)
    begins[i + 1] = begins[i] + lengths[i];
  std::string all(begins[size], ' ');
  MPI_Gatherv(text.data(), length, MPI_CHAR, all.data(), lengths.data(), begins.data(), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  std::vector<std::string> texts;
  for(int i = 0; rank == 0 && i < size; ++i)
    texts.push_back(all.substr(begins[i], lengths[i]));
  return texts;
}

// A task that only some processes can do, such as to read a file: if it fails on one of them, this
// throws on all.
template <class Task>
void do_together(const Task& task)
{
  std::exception_ptr error;
  try {
    task();
  }
  catch(...) {
    error = std::current_exception();
  }
  int fails = error != nullptr, any_fails = 0;
  MPI_Allreduce(&fails, &any_fails, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if(error)
    std::rethrow_exception(error);
  if(any_fails)
    throw CGAL::Remote_error(-1, "failed");
}

void run(const Arguments& arguments)
{
  int rank, size;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const std::string name = arguments.pairs + "." + std::to_string(rank) + ".csv";
  std::vector<Point> points;
  do_together([&] {
    std::error_code ignored;
    if(!arguments.pairs.empty() && std::filesystem::equivalent(name, arguments.file, ignored))
      throw Error(name, "is the input file");
    for(const auto& x : read_share(arguments.file, rank, size))
      points.emplace_back(x[0], x[1], x[2]);
  });
  const std::uint64_t own_points = points.size();
  std::uint64_t all_points = 0;
  MPI_Reduce(&own_points, &all_points, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  std::ofstream output;
  do_together([&] {
    if(rank == 0 && all_points == 0) // of another format, perhaps
      throw Error(arguments.file, "has no point");
    if(!arguments.pairs.empty())
      output.open(name);
    if(!output)
      throw Error(name, std::strerror(errno));
  });

  const auto closed = CGAL::within_distance(arguments.distance);
  using Distribution = CGAL::Point_distribution;
  CGAL::Distributed_profile profile(arguments.as_is ? Distribution::AS_IS
                                                    : Distribution::BALANCED);
  std::uint64_t pairs = 0;
  const auto report = [&](std::uint64_t i, std::uint64_t j) {
    ++pairs;
    if(output.is_open())
      output << i << ',' << j << '\n';
  };
  CGAL::distributed_fixed_radius_near_neighbors(
    MPI_COMM_WORLD, points, arguments.open ? closed.open() : closed, report, profile);
  do_together([&] {
    if(!output.flush())
      throw Error(arguments.pairs, "cannot be written to its end");
  });

  std::uint64_t all_pairs = 0;
  MPI_Reduce(&pairs, &all_pairs, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  const std::vector<std::string> texts = gather_texts(json_of(rank, profile, pairs));
  if(rank != 0)
    return;
  std::cout << R"({"processes": )" << size << R"(, "pairs": )" << all_pairs << R"(, "profile": [)";
  for(const std::string& text : texts)
    std::cout << (&text == &texts.front() ? "\n" : ",\n") << text;
  std::cout << "\n]}\n";
}

// Returns the exit status of this process. Each error is printed once.
int run_and_tell(int argc, char** argv)
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  bool is_ours = rank == 0; // all processes find the same errors in the command line
  try {
    std::ostringstream help;
    const std::optional<Arguments> arguments = parse_arguments(argc, argv, help);
    if(!arguments && rank == 0)
      std::cout << help.str();
    is_ours = true;
    if(arguments)
      run(*arguments);
    if(!std::cout.flush())
      throw Error("the standard output", "cannot be written to its end");
    return 0;
  }
  catch(const CGAL::Remote_error&) {
  }
  catch(const std::exception& error) {
    if(is_ours)
      std::cerr << std::string("near_pairs_mpi: ") + error.what() + '\n'; // at once
  }
  return 2;
}

} // namespace
} // namespace near_pairs

int main(int argc, char** argv)
{
  int provided;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  const int status = near_pairs::run_and_tell(argc, argv);
  MPI_Finalize();
  return status;
}
