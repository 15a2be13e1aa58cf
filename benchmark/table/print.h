// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tables in Markdown.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_PRINT_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_PRINT_H

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace thick_benchmark {

// A figure with so many decimals.
inline std::string fixed(double value, int decimals)
{
  std::ostringstream text;
  text.precision(decimals);
  text << std::fixed << value;
  return text.str();
}

// A figure with so many digits.
inline std::string digits(double value, int count = 3)
{
  std::ostringstream text;
  text.precision(count);
  text << value;
  return text.str();
}

template <class... Cell>
void print_line(const Cell&... cell)
{
  std::cout << '|';
  ((std::cout << ' ' << cell << " |"), ...);
  std::cout << std::endl; // at once: the next line takes a while
}

// The names of columns of text, and of columns of figures, in their order: those of figures begin
// with '>'.
inline void print_head(const std::vector<std::string>& names)
{
  std::string rule = "|";
  std::cout << '|';
  for(const std::string& name : names) {
    const bool is_figure = name[0] == '>';
    std::cout << ' ' << name.substr(is_figure ? 1 : 0) << " |";
    rule += is_figure ? "--:|" : "---|";
  }
  std::cout << '\n' << rule << std::endl;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_PRINT_H
