// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "methods/object_methods.h"
#include "scenes/generators.h"
#include "scenes/object_generators.h"

namespace thick_benchmark {

namespace {

// ---- against box intersection -------------------------------------------------------------------

// A way to the pairs of a scene, which has been run once.
struct Entrant
{
  std::string name;
  Run<Tally> run;
  Tally tally;
  double seconds;
};

template <class Method, class Scene>
Entrant make_entrant(const Method& method, const Scene& scene)
{
  Entrant entrant{method.name, method.prepare(scene), {}, 0};
  entrant.seconds = processor_seconds_of([&] { entrant.tally = entrant.run(); });
  return entrant;
}

// Box intersection with the cutoff that is the best of four; all of them have found the same pairs.
// Once a cutoff takes twice as long as the best, larger ones are left out.
template <class Scene, class Boxes>
Entrant best_boxes(const std::string& name, const Scene& scene, const Boxes& boxes)
{
  Entrant best = make_entrant(boxes(10), scene);
  for(const std::ptrdiff_t cutoff : {100, 1000, 10000}) {
    const Entrant entrant = make_entrant(boxes(cutoff), scene);
    check_equal(name + ": " + entrant.name, best.tally, entrant.tally);
    if(entrant.seconds > 2 * best.seconds)
      break;
    if(entrant.seconds < best.seconds)
      best = entrant;
  }
  return best;
}

// Slow rounds are fewer.
int rounds_for(const std::vector<Entrant>& entrants)
{
  double seconds = 0;
  for(const Entrant& entrant : entrants)
    seconds += entrant.seconds;
  return seconds < 0.3 ? 7 : seconds < 1 ? 5 : 3;
}

// A row for each entrant: the time of the subject in that of the entrant. The goal is that of the
// first one. All have been run once, and so has the subject.
Rows measure_against(const Subject& subject, const Goal& goal,
                     const std::vector<Entrant>& entrants)
{
  std::vector<Job> jobs = {timed(subject.search.sequential)};
  for(const Entrant& entrant : entrants)
    jobs.push_back(timed(entrant.run));
  const std::vector<Seconds> times = time_in_turns(jobs, rounds_for(entrants), 0);
  Rows rows;
  for(std::size_t i = 0; i < entrants.size(); ++i)
    rows.push_back({subject.name, "time / " + entrants[i].name, i == 0 ? goal : Goal(),
                    median(times, [=](const Seconds& s) { return s[0] / s[i + 1]; }), subject.n,
                    subject.k, median(times, milliseconds_of_first)});
  return rows;
}

// ---- objects ------------------------------------------------------------------------------------

// What else is measured: nothing, the speed-up by two threads, and the default cutoff of boxes
// besides.
enum class Extras { NONE, THREADS, DEFAULT_CUTOFF };

using Make_objects = std::function<Object_scene(std::size_t)>;

Rows measure_objects(const std::string& name, const Goal& goal, const Make_objects& make,
                     std::size_t n, Extras extras)
{
  const Object_scene scene = make(n);
  std::vector<Entrant> entrants = {best_boxes(name, scene, boxes_of_objects)};
  const Tally expected = entrants.front().tally;
  if(extras == Extras::DEFAULT_CUTOFF)
    entrants.push_back(make_entrant(boxes_of_objects(10), scene));
  const Subject subject = make_subject(name, scene.size(), search_objects(scene), expected);
  Rows rows = measure_against(subject, goal, entrants);
#ifdef CGAL_LINKED_WITH_TBB
  if(extras != Extras::NONE)
    rows.push_back(measure_two_threads(subject));
#endif
  return rows;
}

Rows measure_points(const std::string& name, const Goal& goal, int dimension, std::size_t n,
                    Dimension_kind kind)
{
  const Scene scene = uniform(dimension, n, static_cast<double>(n) / 2);
  const Entrant boxes = best_boxes(
    name, scene, [=](std::ptrdiff_t cutoff) { return boxes_of_points_d(cutoff, kind); });
  return measure_against(make_subject(name, n, search_points_d(scene, kind), boxes.tally), goal,
                         {boxes});
}

Rows measure_boxes_d(const std::string& name, const Goal& goal, int dimension, std::size_t n,
                     Dimension_kind kind)
{
  const Object_scene scene = uniform_boxes_d(dimension, n, static_cast<double>(n) / 2);
  const Entrant boxes = best_boxes(name, scene, boxes_d);
  return measure_against(make_subject(name, n, search_boxes_d(scene, kind), boxes.tally), goal,
                         {boxes});
}

// ---- the table ----------------------------------------------------------------------------------

// Main rows are measured with the default cutoff and with 10^6 objects as well, dense ones with few
// objects.
enum class Importance { OTHER, MAIN, DENSE };

struct Object_row
{
  std::string name;
  Goal goal;
  Make_objects make;
  Importance importance = Importance::OTHER;
};
using Object_rows = std::vector<Object_row>;

Object_rows boxes_of_the_plane()
{
  const Goal goal = at_most(0.25, 0.14);
  return {{"2D rectangles, k ~ n/2", goal, [](auto n) { return uniform_boxes(2, n, n / 2); },
           Importance::MAIN},
          {"2D rectangles, k ~ 10 n", goal, [](auto n) { return uniform_boxes(2, n, 10 * n); }},
          {"2D squares by a power law", goal, [](auto n) { return power_law_boxes(2, n, n); },
           Importance::MAIN},
          {"2D squares of six decades", goal, [](auto n) { return log_uniform_boxes(2, n, n); }},
          {"2D thin rectangles", goal, [](auto n) { return thin_boxes(n, n); }},
          {"2D rectangles and a giant", goal, [](auto n) { return boxes_with_giant(2, n, n / 2); }},
          {"2D squares in clusters", goal, [](auto n) { return clustered_boxes(2, n); }},
          {"2D long along one axis", goal, [](auto n) { return long_boxes(2, n, n); }}};
}

Object_rows boxes_of_space()
{
  const Goal even = at_most(0.2, 0.1), skewed = at_most(0.25, 0.12);
  return {{"3D cuboids, k ~ n/2", even, [](auto n) { return uniform_boxes(3, n, n / 2); },
           Importance::MAIN},
          {"3D cuboids, k ~ 10 n", even, [](auto n) { return uniform_boxes(3, n, 10 * n); },
           Importance::MAIN},
          {"3D cubes by a power law", skewed, [](auto n) { return power_law_boxes(3, n, n); }},
          {"3D cubes of six decades", skewed, [](auto n) { return log_uniform_boxes(3, n, n); },
           Importance::MAIN},
          {"3D cuboids and a giant", skewed, [](auto n) { return boxes_with_giant(3, n, n / 2); }},
          {"3D beams", skewed, [](auto n) { return beams(n, n); }},
          {"3D cubes in clusters", skewed, [](auto n) { return clustered_boxes(3, n); }},
          {"3D long along one axis", skewed, [](auto n) { return long_boxes(3, n, n); }}};
}

// With the exact test, which takes most of the time of both sides where segments in space meet at
// their ends, so paths have no target.
Object_rows other_shapes()
{
  const Goal goal = at_most(0.3, 0.2), of_mesh = at_most(0.3, 0.18);
  return {{"3D balls of radii .3 to .5", at_most(0.2, 0.1),
           [](auto n) { return uniform_balls(n, n); }, Importance::MAIN},
          {"3D balls by a power law", at_most(0.25, 0.12),
           [](auto n) { return power_law_balls(n, n); }},
          {"2D segments", goal, [](auto n) { return uniform_segments(2, n, n / 2); },
           Importance::MAIN},
          {"3D segments", goal, [](auto n) { return uniform_segments(3, n, n / 2); }},
          {"2D roads", goal, roads},
          {"3D paths", Goal(), [](auto n) { return paths(n, n / 2); }},
          {"3D triangles", goal, [](auto n) { return uniform_triangles(n, n / 2); },
           Importance::MAIN},
          {"2D boxes of a mesh", of_mesh, [](auto n) { return mesh_boxes(2, n); },
           Importance::MAIN},
          {"3D boxes of a mesh", of_mesh, [](auto n) { return mesh_boxes(3, n); },
           Importance::MAIN}};
}

std::string in_space(int dimension, const std::string& name)
{
  return std::to_string(dimension) + "D " + name;
}

// Where no cut helps, and then two sets.
Object_rows hard_boxes_and_two_sets()
{
  const Goal goal = at_most(0.6, 0.3);
  Object_rows rows;
  for(int d : {2, 3}) {
    rows.push_back({in_space(d, "overlap on one axis"), goal,
                    [=](auto n) { return boxes_on_one_axis(d, n, n / 2); }});
    rows.push_back({in_space(d, "trap for trees"), goal, [=](auto n) { return trap(d, n); }});
    rows.push_back({in_space(d, "nested"), goal, [=](auto n) { return nested_boxes(d, n); },
                    Importance::DENSE});
    rows.push_back({in_space(d, "identical"), goal, [=](auto n) { return identical_boxes(d, n); },
                    Importance::DENSE});
  }
  for(int d : {2, 3})
    rows.push_back({in_space(d, "boxes of two sets, k ~ n/2"), at_most(0.3, 0.15),
                    [=](auto n) { return in_two_sets(uniform_boxes(d, n, n)); }});
  return rows;
}

void add_objects(Experiments& all, const Object_row& row, const Settings& settings)
{
  const auto add = [&](const std::string& name, std::size_t n, Extras extras) {
    all.push_back({name, [=, fitted = settings.is_quick ? n / 30 : n] {
                     return measure_objects(name, row.goal, row.make, fitted, extras);
                   }});
  };
  const bool is_main = row.importance == Importance::MAIN;
  const bool is_dense = row.importance == Importance::DENSE;
  add(row.name, is_dense ? 20000 : 300000, is_main ? Extras::DEFAULT_CUTOFF : Extras::NONE);
  if(is_main ? !settings.is_quick : settings.is_large && !is_dense)
    add(row.name + ", 10^6", 1000000, is_main ? Extras::THREADS : Extras::NONE);
}

// Boxes have the targets of points, and what the compiler knows less about has the same targets.
void add_more_dimensions(Experiments& all, const Settings& settings)
{
  const Goal in_four = at_most(0.25, 0.12), in_six = at_most(0.45, 0.3);
  const auto add = [&](const auto& measure, const char* what, int dimension, const Goal& goal,
                       Dimension_kind kind, std::size_t n = 200000) {
    const std::string name = in_space(dimension, what)
                             + (kind == Dimension_kind::STATIC ? "" : ", dynamic dimension");
    all.push_back({name, [=, fitted = settings.is_quick ? n / 30 : n] {
                     return measure(name, goal, dimension, fitted, kind);
                   }});
  };
  for(const auto kind : {Dimension_kind::STATIC, Dimension_kind::DYNAMIC}) {
    const bool is_static = kind == Dimension_kind::STATIC;
    add(measure_points, "points, k ~ n/2", 4, in_four, kind);
    if(is_static)
      add(measure_points, "points, k ~ n/2", 5, at_most(0.35, 0.2), kind);
    add(measure_points, "points, k ~ n/2", 6, in_six, kind);
    if(is_static)
      add(measure_points, "points, k ~ n/2", 8, at_most(0.7, 0.5), kind, 30000);
    add(measure_boxes_d, "boxes, k ~ n/2", 4, in_four, kind);
    add(measure_boxes_d, "boxes, k ~ n/2", 6, in_six, kind);
  }
}

} // namespace

void print_table(const Settings& settings)
{
  Experiments all;
  for(const auto& rows : {boxes_of_the_plane(), boxes_of_space(), other_shapes(),
                          hard_boxes_and_two_sets()})
    for(const Object_row& row : rows)
      add_objects(all, row, settings);
  add_more_dimensions(all, settings);
  print_rows(all, settings);
}

} // namespace thick_benchmark
