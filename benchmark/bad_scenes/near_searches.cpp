// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// fixed_radius_near_neighbors() in the plane and in space. The points are moved into slabs once
// more, and a sweep counts them.

#include "bad_scenes/Work.h"
#include "measuring/timing.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Point_reader.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_column.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_sweep.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_window.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <limits>

namespace thick_benchmark {
namespace {

namespace internal = CGAL::Thick_intersection_d::internal;
using Kernel = CGAL::Simple_cartesian<double>;

// Points as slabs read them. They are counted when they are moved.
template <int Dimension>
class Counting_points final : public internal::Near_points<Dimension>
{
public:
  using Task = internal::Near_task<Dimension>;

  explicit Counting_points(const Made_scene& scene) : boxes_(scene.boxes)
  {
    this->size = boxes_.size();
    for(const Made_box& box : boxes_)
      for(int axis = 0; axis < Dimension; ++axis)
        task.box[axis].add(box.low[axis]);
    task.near.scale = 1;
  }

  void read(std::size_t first, std::size_t count, int axis, double* x) const override
  {
    counted += axis == internal::Near_points<Dimension>::all_axes ? count : 0;
    for(std::size_t i = 0; i < count; ++i, x += Dimension)
      std::copy_n(boxes_[first + i].low.begin(), Dimension, x);
  }
  void read_at(const internal::Place* positions, std::size_t count, double* x) const override
  {
    counted += count;
    for(std::size_t i = 0; i < count; ++i, x += Dimension)
      std::copy_n(boxes_[positions[i]].low.begin(), Dimension, x);
  }
  void prefetch(std::size_t) const override {}
  void read_numbers(std::size_t, std::size_t, internal::Place*) const override {}
  std::size_t position(internal::Place number) const override { return number; }
  const internal::Integer_distance* integers() const override { return nullptr; }
  bool is_pair(std::size_t, std::size_t, internal::Decision_counts&) const override
  {
    return false;
  }
  bool advance(std::size_t) override { return true; }

  Task task;
  mutable double counted = 0;

private:
  const std::vector<Made_box>& boxes_;
};

// Sweeps nothing, and counts the points of runs and the pairs within reach along axis 0. The points
// behind a run are NaN, and end these loops.
template <class Run>
class Counting_sweep
{
public:
  Counting_sweep(double reach, double& counted) : reach_(reach), counted_(counted) {}

  bool is_stopped() const { return false; }

  void within(const Run& run)
  {
    counted_ += run.size;
    const double* const x = run.x[0];
    for(internal::Place i = 0, j = 0; i < run.size; ++i) {
      while(x[j] - x[i] <= reach_)
        ++j;
      counted_ += j - i - 1;
    }
  }

  void between(const Run& a, const Run& b)
  {
    counted_ += a.size + b.size;
    const double* const x = b.x[0];
    for(internal::Place i = 0, first = 0, last = 0; i < a.size; ++i) {
      while(a.x[0][i] - x[first] > reach_)
        ++first;
      while(x[last] - a.x[0][i] <= reach_)
        ++last;
      counted_ += last - first;
    }
  }

private:
  const double reach_;
  double& counted_;
};

// Sweeps one slab after another as the slab route does.
template <int Dimension>
double count_work(const Made_scene& scene, const internal::Point_sets& sets)
{
  using Point = internal::Slab_point<Dimension, double>;
  using Sweep = Counting_sweep<typename Point::Run>;
  const Counting_points<Dimension> points(scene);
  const internal::Slab_tuning tuning;
  const internal::Slabs<Point> slabs(
    internal::Point_reader<Dimension, double>(points, points.task), scene.reach, sets,
    internal::Threads(), tuning);
  const internal::Slab_column<Point> column(slabs, 0, scene.reach, false);
  Sweep counting(scene.reach, points.counted);
  internal::Slab_sweep<Point, Sweep> sweep(scene.reach, counting);
  internal::Slab_window<Point> window(column, scene.reach, 0, tuning);
  typename internal::Slab_window<Point>::Slabs_nearby nearby;
  for(; window.front(); window.pop()) {
    window.find_within_reach(window.front()->interval(Point::slab_axis).high, nearby);
    sweep.between(*window.front(), nearby);
  }
  return points.counted;
}

// The search takes the axes along which points differ, and is another one if these are fewer.
template <int Dimension>
bool has_all_extents(const Made_scene& scene)
{
  std::array<internal::Interval, Dimension> intervals;
  for(const Made_box& box : scene.boxes)
    for(int axis = 0; axis < Dimension; ++axis)
      intervals[axis].add(box.low[axis]);
  for(const internal::Interval& interval : intervals)
    if(!(interval.low < interval.high))
      return false;
  return true;
}

template <class Point>
std::vector<Point> make_points(const Made_scene& scene)
{
  std::vector<Point> points;
  for(const Made_box& box : scene.boxes)
    if constexpr(CGAL::Ambient_dimension<Point>::value == 2)
      points.emplace_back(box.low[0], box.low[1]);
    else
      points.emplace_back(box.low[0], box.low[1], box.low[2]);
  return points;
}

template <int Dimension, bool AreTwoSets>
Work run_near(const Made_scene& scene)
{
  using Point = std::conditional_t<Dimension == 2, Kernel::Point_2, Kernel::Point_3>;
  const std::vector<Point> points = make_points<Point>(scene);
  const auto bound = CGAL::within_distance(scene.reach);
  const double limit = max_pairs_per_element * static_cast<double>(points.size());
  Work work;
  const auto count_pairs = [&] {
    CGAL::fixed_radius_near_neighbors(points, bound, [&](std::size_t, std::size_t) {
      return ++work.pairs < limit;
    });
  };
  work.seconds = processor_seconds_of(count_pairs);
  if(work.pairs >= limit || !has_all_extents<Dimension>(scene)) {
    work.pairs = std::numeric_limits<double>::infinity();
    return work;
  }
  if constexpr(!AreTwoSets) {
    work.counted = count_work<Dimension>(scene, internal::Point_sets());
    return work;
  }
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(scene.first_size);
  const std::vector<Point> first(points.begin(), middle), second(middle, points.end());
  work.seconds = processor_seconds_of([&] {
    CGAL::fixed_radius_near_neighbors(first, second, bound, [](std::size_t, std::size_t) {});
  });
  work.counted = count_work<Dimension>(
    scene, internal::Point_sets{static_cast<internal::Place>(scene.first_size)});
  return work;
}

const double pi = std::acos(-1);

} // namespace

std::vector<Subject_search> near_searches()
{
  return {{"near2", 2, false, run_near<2, false>, pi},
          {"near3", 3, false, run_near<3, false>, 4 * pi / 3},
          {"near2_sets", 2, false, run_near<2, true>, pi},
          {"near3_sets", 3, false, run_near<3, true>, 4 * pi / 3}};
}

} // namespace thick_benchmark
