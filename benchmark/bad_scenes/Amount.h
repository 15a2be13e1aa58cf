// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A number of a recipe: plain, in reaches, or over a power of n. So a recipe serves any n.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_AMOUNT_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_AMOUNT_H

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

namespace thick_benchmark {

struct Amount
{
  double factor = 0;
  bool is_in_reaches = false;
  double exponent = 0;

  double at(double n, double reach) const
  {
    return factor * (is_in_reaches ? reach : 1) * std::pow(n, -exponent);
  }
};

// Writes "0.3", "4.5r", "600/n" or "1/n^0.5".
inline std::string to_text(const Amount& amount)
{
  std::ostringstream text;
  text << amount.factor << (amount.is_in_reaches ? "r" : "");
  if(amount.exponent == 1)
    text << "/n";
  else if(amount.exponent != 0)
    text << "/n^" << amount.exponent;
  return text.str();
}

// Reads what to_text() writes.
inline Amount read_amount(const std::string& text)
{
  Amount amount;
  char* rest = nullptr;
  amount.factor = std::strtod(text.c_str(), &rest);
  std::string unit = rest;
  if(rest == text.c_str())
    throw std::invalid_argument("This is no number: " + text);
  if(unit.rfind("r", 0) == 0) {
    amount.is_in_reaches = true;
    unit.erase(0, 1);
  }
  if(unit == "/n")
    amount.exponent = 1;
  else if(unit.rfind("/n^", 0) == 0)
    amount.exponent = std::strtod(unit.c_str() + 3, nullptr);
  else if(!unit.empty())
    throw std::invalid_argument("This is no unit of a number: " + text);
  return amount;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_AMOUNT_H
