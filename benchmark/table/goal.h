// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a figure of a table has to reach, and whether it does.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_GOAL_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_GOAL_H

#include "print.h"

#include <cmath>
#include <optional>
#include <string>

namespace thick_benchmark {

// What a quantity has to reach, and what would be better still; some are only shown.
struct Goal
{
  enum Sense { AT_MOST, AT_LEAST };

  Sense sense = AT_MOST;
  std::optional<double> target;
  std::optional<double> good;
};

inline Goal at_most(double target) { return {Goal::AT_MOST, target, std::nullopt}; }
inline Goal at_most(double target, double good) { return {Goal::AT_MOST, target, good}; }
inline Goal at_least(double target) { return {Goal::AT_LEAST, target, std::nullopt}; }

// How many decimals of a figure are shown: three digits in all, the others are noise.
inline int decimals(double value) { return value < 10 ? 2 : value < 100 ? 1 : 0; }

inline std::string figure(const std::optional<double>& value)
{
  return value ? fixed(*value, decimals(*value)) : "";
}

inline std::string target_of(const Goal& goal)
{
  return goal.target ? (goal.sense == Goal::AT_MOST ? "<= " : ">= ") + figure(goal.target) : "";
}

// "good", "met" or "missed", by the figure that is shown; empty for quantities without a target.
inline std::string verdict(double measured, const Goal& goal)
{
  const double unit = std::pow(0.1, decimals(measured));
  const double shown = std::round(measured / unit) * unit;
  const auto reaches = [&](double value) {
    return goal.sense == Goal::AT_MOST ? shown <= value + unit / 2 : shown >= value - unit / 2;
  };
  if(!goal.target)
    return "";
  if(!reaches(*goal.target))
    return "missed";
  return goal.good && reaches(*goal.good) ? "good" : "met";
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_GOAL_H
