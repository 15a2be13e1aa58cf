// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// table and object_table: measure what the package promises about its speed and memory, and print
// for each promise what it is, what was measured, and whether it holds.

#include "outputs.h"
#include "rows.h"

#include "measuring/speed_up.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <regex>

namespace thick_benchmark {
namespace {

namespace po = boost::program_options;

po::options_description known_options()
{
  po::options_description options("Options");
  options.add_options()
    ("help", "print this text")
    ("quick", "few points or objects: to see that everything runs, not for figures")
    ("huge", "larger scenes as well: of 10^8 points, which take 20 GB, and all of 10^6 objects")
    ("rows", po::value<std::string>()->value_name("REGEX")->default_value(""),
     "only rows whose name has a match")
    ("data", po::value<std::string>()->value_name("FOLDER")->default_value(""),
     "where pba38478.tsp lies, for the row that needs it")
    ("json", po::value<std::string>()->value_name("FILE"),
     "write the table, and the machine, as JSON")
    ("csv", po::value<std::string>()->value_name("FILE"), "likewise as CSV")
    ("markdown", po::value<std::string>()->value_name("FILE"), "likewise as Markdown");
  return options;
}

Rows run(const po::variables_map& options)
{
  Settings settings;
  settings.is_quick = options.count("quick") != 0;
  settings.huge = options.count("huge") != 0;
  settings.extra_data = options["data"].as<std::string>();

  const std::regex wanted(options["rows"].as<std::string>());
  Rows rows;
  print_head(std::cout);
  for(const Experiment& experiment : experiments(settings))
    if(std::regex_search(experiment.name, wanted))
      for(const Row& row : experiment.run()) {
        print_row(std::cout, row);
        rows.push_back(row);
      }
  return rows;
}

void write_files(const Rows& rows, const po::variables_map& options)
{
  if(options.count("json"))
    write_json(options["json"].as<std::string>(), rows);
  if(options.count("csv"))
    write_csv(options["csv"].as<std::string>(), rows);
  if(options.count("markdown"))
    write_markdown(options["markdown"].as<std::string>(), rows);
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
try {
  using namespace thick_benchmark;
#ifdef CGAL_LINKED_WITH_TBB
  const Two_threads two_threads;
#endif
  po::variables_map options;
  po::store(po::parse_command_line(argc, argv, known_options()), options);
  po::notify(options);
  if(options.count("help")) {
    std::cout << known_options();
    return 0;
  }
  write_files(run(options), options);
  return 0;
}
catch(const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
