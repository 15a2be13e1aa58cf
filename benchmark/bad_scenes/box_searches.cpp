// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The box route, on boxes that count.

#include "bad_scenes/Work.h"
#include "measuring/timing.h"
#include "support/counted_boxes.h"
#include "support/number_boxes.h"

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_route.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_reporter.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <limits>
#include <numeric>

namespace thick_benchmark {
namespace {

using test_support::Counted_boxes;
using test_support::Number_objects;
namespace internal = CGAL::Thick_intersection_d::internal;

template <int Axes>
Work search_boxes(const Number_objects& objects, std::size_t set_count, std::size_t first_size)
{
  std::vector<int> axes(static_cast<std::size_t>(objects.dimension()));
  std::iota(axes.begin(), axes.end(), 0);
  const Counted_boxes<Axes> test(objects, axes);
  std::vector<typename Counted_boxes<Axes>::Box> boxes(objects.size());
  for(std::size_t i = 0; i < boxes.size(); ++i)
    test.put(i, boxes[i]);
  using Piece = internal::Piece<typename Counted_boxes<Axes>::Box>;
  const auto first = boxes.data(), middle = first + first_size, last = first + boxes.size();
  const Piece piece
    = set_count == 1 ? Piece({first, last}) : Piece({first, middle}, {middle, last});
  Work work;
  const double limit = max_pairs_per_element * static_cast<double>(objects.size());
  const auto callback = [&](std::size_t, std::size_t) { return ++work.pairs < limit; };
  using Report = internal::Pair_reporter<decltype(callback)>;
  Report report(callback);
  internal::Unwatched_progress progress;
  internal::Box_route<CGAL::Sequential_tag, Counted_boxes<Axes>, Report,
                      internal::Unwatched_progress>
    route(test, report, progress);
  work.seconds = processor_seconds_of([&] { route.search(piece); });
  if(work.pairs >= limit)
    work.pairs = std::numeric_limits<double>::infinity();
  const internal::Box_tuning costs;
  work.counted = test.swept + test.candidates * costs.candidate_cost / costs.box_cost;
  return work;
}

template <int Axes, bool AreTwoSets>
Work run_boxes(const Made_scene& scene)
{
  test_support::Number_boxes boxes(scene.boxes.size());
  for(std::size_t i = 0; i < boxes.size(); ++i)
    for(int axis = 0; axis < scene.dimension; ++axis) {
      const std::size_t c = static_cast<std::size_t>(axis);
      boxes[i][c] = {scene.boxes[i].low[c], scene.boxes[i].low[c] + scene.boxes[i].extent[c]};
    }
  const Number_objects objects(boxes, scene.dimension);
  Work work = search_boxes<Axes>(objects, 1, 0);
  if(!AreTwoSets || !std::isfinite(work.pairs))
    return work;
  const double pairs = work.pairs;
  work = search_boxes<Axes>(objects, 2, scene.first_size);
  work.pairs = pairs;
  return work;
}

} // namespace

// Two cubes meet if their corners differ by less than a side along each axis.
std::vector<Subject_search> box_searches()
{
  return {{"boxes2", 2, true, run_boxes<2, false>, 4},
          {"boxes3", 3, true, run_boxes<3, false>, 8},
          {"boxes4", 4, true, run_boxes<4, false>, 16},
          {"boxes2_sets", 2, true, run_boxes<2, true>, 4},
          {"boxes3_sets", 3, true, run_boxes<3, true>, 8},
          {"boxes4_sets", 4, true, run_boxes<4, true>, 16}};
}

} // namespace thick_benchmark
