// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H

// The parts of a set of points on disk, of which one is in memory at a time.

#include <CGAL/Memory_budget.h>

#include <CGAL/Thick_intersection_d/internal/external/Loaded_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Part_limits.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Streamed_sample.h>
#include <CGAL/Thick_intersection_d/internal/external/plan_parts.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns functions of an axis, as `Part_box` takes them.
inline auto ends_of(const Stored_point& point)
{
  return [&x = point.x](int axis) {
    const double coordinate = x[static_cast<std::size_t>(axis)];
    return std::pair<double, double>(coordinate, coordinate);
  };
}

inline auto ends_of(const Part_box& box)
{
  return [&box](int axis) {
    const Interval& interval = box.intervals()[static_cast<std::size_t>(axis)];
    return std::pair<double, double>(interval.low, interval.high);
  };
}

// Each point is owned by one part. The parts are searched one after another. A part that has been
// searched gives its points to those that are still to come: each of them to all parts near it. So
// a part is searched with the points that it owns and points of parts before it. Of two near points
// of different parts, the one whose part comes first is there when the other part is searched, and
// at no other time: the pair is found, and found once.
//
// A part that does not fit in memory is cut. The parts that it becomes take its place in the order,
// and the points that it was given go to those of them that they are near. So nothing above
// changes, and the parts before it need not know.
class External_parts
{
  struct Part
  {
    Stored_points owned;
    Stored_points given;
    Part_box box{3}; // of the owned points

    std::uint64_t size() const { return owned.size() + given.size(); }
  };

public:
  External_parts(const Memory_budget& budget, double reach)
    : limits_(budget.bytes()), reach_(reach),
      store_(budget.directory(), limits_.points_per_chunk())
  {}

  const Part_limits& limits() const { return limits_; }

  // Makes the first parts. `visit_points(visit)` calls visit(point) for each of the points that
  // `sample` is of.
  template <class Visit_points>
  void make(const Streamed_sample& sample, const Visit_points& visit_points)
  {
    add_parts(plan_parts(sample, reach_, limits_), visit_points, Stored_points());
  }

  // Gets the next part ready to be taken. Returns false if there is none.
  bool find_next()
  {
    while(!parts_.empty() && parts_.back().size() > limits_.points_per_search())
      cut_last();
    return !parts_.empty();
  }

  // Takes the part away, and gives its points to the parts behind it.
  template <class Point>
  Loaded_points<Point> take_next()
  {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    std::vector<Part*> near_parts;
    for(Part& other : parts_)
      if(other.box.is_near(ends_of(part.box), reach_))
        near_parts.push_back(&other);
    const auto owned = static_cast<std::size_t>(part.owned.size());
    std::vector<Stored_point> stored;
    stored.reserve(static_cast<std::size_t>(part.size()));
    part.owned.take_chunks(store_, [&](const std::vector<Stored_point>& points) {
      stored.insert(stored.end(), points.begin(), points.end());
      for(const Stored_point& point : points)
        for(Part* other : near_parts)
          give(*other, point);
    });
    part.given.take_chunks(store_, [&](const std::vector<Stored_point>& points) {
      stored.insert(stored.end(), points.begin(), points.end());
    });
    return Loaded_points<Point>(stored, owned, part.box);
  }

private:
  void give(Part& part, const Stored_point& point)
  {
    if(part.box.is_near(ends_of(point), reach_))
      part.given.add(store_, point);
  }

  // Parts become smaller by each cut. One that has few points of its own would not by another.
  void cut_last()
  {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    if(part.owned.size() < limits_.points_per_search() / 16)
      refuse_crowd(limits_.points_per_search());
    Streamed_sample sample(limits_.points_per_sample());
    part.owned.visit_chunks(store_, [&](const std::vector<Stored_point>& points) {
      for(const Stored_point& point : points)
        sample.add(point);
    });
    const auto visit_owned = [&](const auto& visit) {
      part.owned.take_chunks(store_, [&](const std::vector<Stored_point>& points) {
        for(const Stored_point& point : points)
          visit(point);
      });
    };
    add_parts(plan_parts(sample, reach_, limits_), visit_owned, std::move(part.given));
  }

  // Adds the parts of a plan, in front of all others.
  template <class Visit_points>
  void add_parts(const Part_plan& plan, const Visit_points& visit_points, Stored_points given)
  {
    const std::size_t first = parts_.size();
    const auto count = static_cast<std::size_t>(plan.part_count);
    parts_.resize(first + count);
    std::vector<std::array<Interval, 3>> boxes(count);
    visit_points([&](const Stored_point& point) {
      const auto part = count - 1 - static_cast<std::size_t>(plan.cuts.owner(point.x, point.id));
      for(std::size_t axis = 0; axis < 3; ++axis)
        boxes[part][axis].add(point.x[axis]);
      parts_[first + part].owned.add(store_, point);
    });
    for(std::size_t part = 0; part < count; ++part)
      parts_[first + part].box = Part_box({boxes[part].begin(), boxes[part].end()});
    given.take_chunks(store_, [&](const std::vector<Stored_point>& points) {
      for(const Stored_point& point : points)
        for(std::size_t part = first; part < parts_.size(); ++part)
          give(parts_[part], point);
    });
    for(std::size_t part = first; part < parts_.size(); ++part) {
      parts_[part].owned.flush(store_);
      parts_[part].given.flush(store_);
    }
  }

  Part_limits limits_;
  double reach_;
  Chunk_store store_;
  std::vector<Part> parts_; // the next one last
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H
