// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The program of each table, which it prints in Markdown.
//
//   <table>_table [--quick] [--large] [--chart] [--only=<word>] [--data=<folder>] [--postgis]
//
//   --quick      few elements: does it work? The figures mean nothing
//   --large      larger scenes as well
//   --chart      what the chart of the table is drawn from, as CSV
//   --only       only rows with this in their names
//   --data       where pba38478.tsp and aircraft_ch_2018-08-01_am.csv lie, for rows of them
//   --postgis    psql finds a server with PostGIS
//
// It ends with status 1 if two methods disagree about the pairs.

#include "table.h"
#include <exception>
#include <iostream>
#include <stdexcept>

namespace thick_benchmark {
namespace {

void read_option(const std::string& option, Settings& settings)
{
  const auto begins_with = [&](const std::string& name) { return option.rfind(name, 0) == 0; };
  const std::string value = option.substr(option.find('=') + 1);
  if(option == "--quick")
    settings.is_quick = true;
  else if(option == "--large")
    settings.is_large = true;
  else if(option == "--chart")
    settings.is_chart = true;
  else if(option == "--postgis")
    settings.has_postgis = true;
  else if(begins_with("--only="))
    settings.only = value;
  else if(begins_with("--data="))
    settings.data = value;
  else
    throw std::invalid_argument("There is no option " + option);
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
try {
  using namespace thick_benchmark;
  Settings settings;
  for(int i = 1; i < argc; ++i)
    read_option(argv[i], settings);
  print_table(settings);
  return 0;
}
catch(const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
