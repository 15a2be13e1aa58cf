// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A table of measurements: comment lines that say how the truth was found and on what machine, a
// line of column names, and rows.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_CSV_FILE_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_CSV_FILE_H

#include <CGAL/version.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace thick_benchmark {

// The name and the family of the processor, as Linux tells them.
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

class Csv_file
{
public:
  // In a folder. `truth` says how the right answers were found, and in which file that is done.
  Csv_file(const std::string& folder, const std::string& name, const std::string& truth,
           const std::string& columns)
    : out_(folder + "/" + name)
  {
    if(!out_)
      throw std::runtime_error("cannot write " + name + " in " + folder);
    out_ << "# truth: " << truth << '\n'
         << "# machine: " << processor() << "; compiler " << __VERSION__ << "; CGAL "
         << CGAL_VERSION_STR << '\n'
         << columns << '\n';
    out_.precision(9);
  }

  template <class First, class... Others>
  void row(const First& first, const Others&... others)
  {
    put(first);
    ((out_ << ',', put(others)), ...);
    out_ << '\n' << std::flush;
  }

private:
  template <class Value>
  void put(const Value& value)
  {
    out_ << value;
  }
  void put(const std::string& text) { out_ << '"' << text << '"'; }
  void put(const char* text) { put(std::string(text)); }

  std::ofstream out_;
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_CSV_FILE_H
