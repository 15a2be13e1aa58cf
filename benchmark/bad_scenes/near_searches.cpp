// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// fixed_radius_near_neighbors() in the plane and in space. The slab route is run once more on
// points that count.

#include "bad_scenes/Work.h"
#include "measuring/timing.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_reporter.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_route.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_question.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/near_points.h>

#include <limits>

namespace thick_benchmark {
namespace {

namespace internal = CGAL::Thick_intersection_d::internal;
using Kernel = CGAL::Simple_cartesian<double>;

// Points as the slab route asks for them. Doubles decide each pair, rounded.
template <int Dimension>
class Counting_points
{
public:
  using Point = internal::Slab_point<Dimension>;
  using Run = internal::Run<Dimension>;

  explicit Counting_points(const Made_scene& scene)
    : boxes_(scene.boxes),
      near_{scene.reach, {scene.reach * scene.reach, scene.reach * scene.reach}}
  {
    for(const Made_box& box : boxes_)
      for(int axis = 0; axis < Dimension; ++axis)
        intervals_[axis].add(box.low[axis]);
  }

  std::size_t size() const { return boxes_.size(); }
  double reach() const { return near_.reach; }
  internal::Interval interval(int axis) const { return intervals_[axis]; }
  double coordinate(std::size_t position, int axis) const { return boxes_[position].low[axis]; }
  bool are_all_pairs() const { return false; }
  void publish(const internal::Decision_counts&) const {}
  void put(std::size_t position, Point& place) const
  {
    ++counted;
    std::copy_n(boxes_[position].low.begin(), Dimension, place.x.begin());
    place.position = static_cast<internal::Place>(position);
  }

  // The points behind a run are NaN, and end these loops.
  template <class Flush>
  void collect_within(const Run& run, internal::Found_pairs& found, const Flush& flush) const
  {
    counted += run.size;
    const double* const x = run.x[0];
    for(internal::Place i = 0, j = 0; i < run.size; ++i) {
      while(x[j] - x[i] <= near_.reach)
        ++j;
      counted += j - i - 1;
    }
    internal::Near_points_lanes::collect_within(run, near_, found, flush);
  }

  template <class Flush>
  void collect_between(const Run& a, const Run& b, internal::Found_pairs& found,
                       const Flush& flush) const
  {
    counted += a.size + b.size;
    const double* const x = b.x[0];
    for(internal::Place i = 0, first = 0, last = 0; i < a.size; ++i) {
      while(a.x[0][i] - x[first] > near_.reach)
        ++first;
      while(x[last] - a.x[0][i] <= near_.reach)
        ++last;
      counted += last - first;
    }
    internal::Near_points_lanes::collect_between(a, b, near_, found, flush);
  }

  bool is_pair(const Run&, const Run&, internal::Found_pair, internal::Decision_counts&) const
  {
    return true;
  }

  mutable double counted = 0;

private:
  const std::vector<Made_box>& boxes_;
  const internal::Near_question near_;
  std::array<internal::Interval, Dimension> intervals_;
};

template <int Dimension, class Sets>
double count_work(const Made_scene& scene, const Sets& sets)
{
  const Counting_points<Dimension> points(scene);
  const auto ignore = [](std::size_t, std::size_t) {};
  internal::Pair_reporter<decltype(ignore)> report(ignore);
  internal::Unwatched_progress progress;
  internal::Slab_route<CGAL::Sequential_tag, Counting_points<Dimension>>(points).search(
    sets, report, progress);
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
    work.counted = count_work<Dimension>(scene, internal::One_set());
    return work;
  }
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(scene.first_size);
  const std::vector<Point> first(points.begin(), middle), second(middle, points.end());
  work.seconds = processor_seconds_of([&] {
    CGAL::fixed_radius_near_neighbors(first, second, bound, [](std::size_t, std::size_t) {});
  });
  work.counted = count_work<Dimension>(scene, internal::Two_sets{scene.first_size});
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
