// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The box route, on boxes that count.

#include "bad_scenes/Work.h"
#include "measuring/timing.h"
#include "support/number_boxes.h"

#include <CGAL/Thick_intersection_d/internal/boxes/Box_route.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

#include <cstddef>
#include <limits>
#include <optional>

namespace thick_benchmark {
namespace {

using test_support::Number_objects;
namespace internal = CGAL::Thick_intersection_d::internal;

template <int Axes>
Work search_boxes(const Number_objects& objects, std::optional<std::size_t> first_set_size)
{
  Work work;
  const double limit = max_pairs_per_element * static_cast<double>(objects.size());
  const auto callback = [&](std::size_t, std::size_t) { return ++work.pairs < limit; };
  internal::Unwatched_progress progress;
  const internal::Box_tuning costs;
  const auto search = [&](auto& client, const auto& piece) {
    internal::Box_route<Axes> route(client, internal::Threads());
    work.seconds = processor_seconds_of([&] { route.search(piece); });
    work.counted = static_cast<double>(route.swept_count())
                   + static_cast<double>(route.candidate_count()) * costs.candidate_cost
                       / costs.box_cost;
  };
  test_support::with_piece<Axes>(objects, first_set_size, callback, progress, search);
  if(work.pairs >= limit)
    work.pairs = std::numeric_limits<double>::infinity();
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
  Work work = search_boxes<Axes>(objects, std::nullopt);
  if(!AreTwoSets || !std::isfinite(work.pairs))
    return work;
  const double pairs = work.pairs;
  work = search_boxes<Axes>(objects, scene.first_size);
  work.pairs = pairs;
  return work;
}

} // namespace

// Two cubes meet if their corners differ by less than a side along each axis.
std::vector<Subject_search> box_searches()
{
  return {{"boxes2", 2, run_boxes<2, false>, 4},
          {"boxes3", 3, run_boxes<3, false>, 8},
          {"boxes4", 4, run_boxes<4, false>, 16},
          {"boxes2_sets", 2, run_boxes<2, true>, 4},
          {"boxes3_sets", 3, run_boxes<3, true>, 8},
          {"boxes4_sets", 4, run_boxes<4, true>, 16}};
}

} // namespace thick_benchmark
