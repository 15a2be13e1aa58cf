// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PLAN_PARTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PLAN_PARTS_H

// Chooses parts that fit in memory together with the points near them, by a sample.

#include <CGAL/Thick_intersection_d/internal/external/Part_limits.h>
#include <CGAL/Thick_intersection_d/internal/external/Streamed_sample.h>
#include <CGAL/Thick_intersection_d/internal/parts/Bisection.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Part_plan
{
  int part_count;
  Bisection cuts;
};

// What a plan would cost, as numbers of points of the sample.
struct Part_costs
{
  std::size_t largest = 0; // of a part, with the points of earlier parts near it
  std::size_t copies = 0;  // of points near later parts
};

// Returns a function of an axis, as `Part_box` takes it.
inline auto ends_of_sampled(const Point_sample& sample, std::size_t i)
{
  return [x = sample.point(i)](int axis) { return std::pair<double, double>(x[axis], x[axis]); };
}

inline Part_costs costs_of(const Part_plan& plan, const Point_sample& sample, double reach)
{
  std::vector<int> owners;
  std::vector<Part_box> boxes(static_cast<std::size_t>(plan.part_count),
                              Part_box(sample.dimension));
  std::vector<std::size_t> sizes(boxes.size());
  for(std::size_t i = 0; i < sample.size(); ++i) {
    owners.push_back(plan.cuts.owner(sample.point(i), sample.ids[i]));
    const auto owner = static_cast<std::size_t>(owners.back());
    boxes[owner].add(ends_of_sampled(sample, i));
    ++sizes[owner];
  }
  Part_costs costs;
  for(std::size_t part = 0; part < boxes.size(); ++part) {
    std::size_t copies = 0;
    for(std::size_t i = 0; i < sample.size(); ++i)
      copies += owners[i] < static_cast<int>(part)
                && boxes[part].is_near(ends_of_sampled(sample, i), reach);
    costs.copies += copies;
    costs.largest = (std::max)(costs.largest, sizes[part] + copies);
  }
  return costs;
}

[[noreturn]] inline void refuse_crowd(std::size_t points_per_search)
{
  throw std::length_error("The points near a part of the points do not fit in the memory budget, "
                          "which has room for " + std::to_string(points_per_search)
                          + " points: take a larger budget or a smaller bound.");
}

// Returns a plan for points of which a sample is given. Its parts are small enough, as far as the
// sample can tell, or small enough to be cut again. Throws std::length_error if small parts would
// not be enough, because most of the points near them are not their own.
inline Part_plan plan_parts(const Streamed_sample& points, double reach, const Part_limits& limits)
{
  const Point_sample& sample = points.sample();
  const double limit = static_cast<double>(limits.points_per_search());
  const double scale = static_cast<double>(points.count()) / static_cast<double>(sample.size());
  const double needed = static_cast<double>(points.count()) / limit;
  const int most = static_cast<int>((std::min)(16 * needed + 2, 1. * Part_limits::most_parts));
  int part_count = static_cast<int>((std::min)(1.125 * needed + 1.5, 1. * most));
  while(true) {
    Part_plan plan = {part_count, Bisection(sample, part_count, reach)};
    const Part_costs costs = costs_of(plan, sample, reach);
    const double largest = static_cast<double>(costs.largest) * scale;
    if(largest <= .9 * limit)
      return plan;
    if(part_count == most) {
      const bool is_final = 2 * needed <= part_count;
      if(costs.copies > 8 * sample.size() || (is_final && largest > 1.25 * limit))
        refuse_crowd(limits.points_per_search());
      return plan;
    }
    part_count = (std::min)(part_count + part_count / 8 + 1, most);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_PLAN_PARTS_H
